// FormPanel: a scrolled form about parts of the scene that are always there, such as film and
// render settings.
#pragma once

#include <functional>
#include <vector>

#include "gui/widgets/form_scroll.h"

namespace glint {

class Document;
class FormBuilder;
struct Scene;

class FormPanel : public FormScroll {
    Q_OBJECT

  public:
    /// `build` makes the sections; `structure` gives a text that changes whenever others are
    /// needed.
    FormPanel(Document& document, std::function<void(FormBuilder&)> build,
              std::function<QString(const Scene&)> structure, QWidget* parent = nullptr);

  private:
    void onChanged();
    void rebuild();

    Document& document_;
    std::function<void(FormBuilder&)> build_;
    std::function<QString(const Scene&)> structure_;
    QString builtFor_;
    std::vector<std::function<void(const Scene&)>> refreshes_;
};

}  // namespace glint
