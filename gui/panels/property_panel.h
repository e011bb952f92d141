// PropertyPanel: the fields of the selected items, made from the field tables. It is rebuilt when
// what it is about changes (other items, another type), and else only refreshed.
#pragma once

#include <functional>
#include <vector>

#include "gui/widgets/form_scroll.h"
#include "tracer/scene/ids.h"

namespace glint {

class Document;
class FormBuilder;
class MaterialPreviews;
class Selection;
struct Scene;

class PropertyPanel : public FormScroll {
    Q_OBJECT

  public:
    PropertyPanel(Document& document, const Selection& selection, QWidget* parent = nullptr);

    /// Gives each material section the picture of its material.
    void setPreviews(MaterialPreviews& previews);
    /// Shows a material while nothing is selected.
    void showMaterial(MaterialId material);

  private:
    void onChanged();
    void rebuild();
    /// Of whom the rows are, and of which kinds: changes whenever other rows are needed.
    [[nodiscard]] std::vector<std::size_t> structure() const;
    void addForm(QWidget* content, std::vector<std::uint32_t> targets, void (*build)(FormBuilder&));
    void addMaterials(QWidget* content, const std::vector<std::uint32_t>& materials);
    void addHint(QWidget* content);

    Document& document_;
    const Selection& selection_;
    MaterialPreviews* previews_ = nullptr;
    MaterialId material_;  ///< to be shown while nothing is selected
    std::vector<std::size_t> builtFor_;
    std::vector<std::function<void(const Scene&)>> refreshes_;
};

}  // namespace glint
