// PropertyPanel: the fields of the selected items, made from the field tables. It is rebuilt when what it is about changes
// (other items, another type), and else only refreshed.
#pragma once

#include <functional>
#include <vector>

#include "gui/widgets/form_scroll.h"

namespace glint {

class Document;
class FormBuilder;
class Selection;
struct Scene;

class PropertyPanel : public FormScroll {
    Q_OBJECT

  public:
    PropertyPanel(Document& document, const Selection& selection, QWidget* parent = nullptr);

  private:
    void onChanged();
    void rebuild();
    /// Text that changes whenever other rows are needed.
    [[nodiscard]] QString structure() const;

    Document& document_;
    const Selection& selection_;
    QString builtFor_;
    std::vector<std::function<void(const Scene&)>> refreshes_;
};

}  // namespace glint
