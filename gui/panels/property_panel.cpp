#include "gui/panels/property_panel.h"

#include <QLabel>
#include <QScrollBar>
#include <QVBoxLayout>

#include "gui/app/document.h"
#include "gui/app/material_previews.h"
#include "gui/app/selection.h"
#include "gui/panels/item_forms.h"
#include "gui/widgets/preview_ball.h"
#include "gui/widgets/section.h"

namespace glint {

namespace {

Targets makeTargets(std::vector<std::uint32_t> ids) {
    return std::make_shared<const std::vector<std::uint32_t>>(std::move(ids));
}

/// The ids of the selected items of the active item's kind, the active one first: its values are
/// shown.
std::vector<std::uint32_t> selectedIds(const Selection& selection) {
    std::vector<std::uint32_t> out;
    const Item active = selection.items().back();
    for (auto item = selection.items().rbegin(); item != selection.items().rend(); ++item)
        if (item->kind == active.kind) out.push_back(item->id);
    return out;
}

}  // namespace

PropertyPanel::PropertyPanel(Document& document, const Selection& selection, QWidget* parent)
    : FormScroll(parent), document_(document), selection_(selection) {
    setAccessibleName(tr("Properties"));
    connect(&document, &Document::changed, this, &PropertyPanel::onChanged);
    connect(&selection, &Selection::changed, this, &PropertyPanel::onChanged);
    rebuild();
}

void PropertyPanel::onChanged() {
    if (structure() != builtFor_) return rebuild();
    for (const auto& refresh : refreshes_) refresh(document_.scene());
}

void PropertyPanel::setPreviews(MaterialPreviews& previews) {
    previews_ = &previews;
    rebuild();
}

void PropertyPanel::showMaterial(MaterialId material) {
    material_ = material;
    onChanged();
}

std::vector<std::size_t> PropertyPanel::structure() const {
    const Scene& scene = document_.scene();
    enum About : std::size_t { kNothing, kMaterial, kItems };
    std::vector<std::size_t> out;
    const auto addMaterialKinds = [&](const std::vector<std::uint32_t>& materials) {
        for (const std::uint32_t id : materials)
            out.insert(out.end(), {id, scene.materials.at(MaterialId{id}).value.index()});
        const std::vector<std::uint32_t> textures = texturesOf(scene, materials);
        out.insert(out.end(), textures.begin(), textures.end());
    };
    if (selection_.isEmpty()) {
        if (!scene.materials.find(material_)) return {kNothing};
        out.push_back(kMaterial);
        addMaterialKinds({material_.value});
        return out;
    }
    const ItemKind kind = selection_.items().back().kind;
    const std::vector<std::uint32_t> ids = selectedIds(selection_);
    out.insert(out.end(),
               {kItems, static_cast<std::size_t>(kind), scene.textures.size(), ids.size()});
    for (const std::uint32_t id : ids) {
        out.push_back(id);
        if (kind == ItemKind::Object) out.push_back(scene.objects.at(ObjectId{id}).shape.index());
        if (kind == ItemKind::Light) out.push_back(scene.lights.at(LightId{id}).value.index());
    }
    if (kind == ItemKind::Object) addMaterialKinds(materialsOf(scene, ids));
    return out;
}

void PropertyPanel::addForm(QWidget* content, std::vector<std::uint32_t> targets,
                            void (*build)(FormBuilder&)) {
    if (targets.empty()) return;
    FormBuilder form(document_, makeTargets(std::move(targets)), content);
    build(form);
    for (auto& refresh : form.takeRefreshes()) refreshes_.push_back(std::move(refresh));
}

void PropertyPanel::addMaterials(QWidget* content, const std::vector<std::uint32_t>& materials) {
    const int head = content->layout()->count();
    addForm(content, materials, buildMaterialForm);
    if (previews_ && materials.size() == 1)
        static_cast<Section*>(content->layout()->itemAt(head)->widget())
            ->addHead(new PreviewBall(*previews_, MaterialId{materials.front()}, content));
    addForm(content, texturesOf(document_.scene(), materials), buildTextureForm);
}

void PropertyPanel::addHint(QWidget* content) {
    auto* hint = new QLabel(tr("Nothing selected.\nClick an object in the picture or in the list."),
                            content);
    hint->setAlignment(Qt::AlignCenter);
    hint->setWordWrap(true);
    hint->setEnabled(false);
    content->layout()->addWidget(hint);
}

void PropertyPanel::rebuild() {
    builtFor_ = structure();
    refreshes_.clear();
    QWidget* content = newForm();
    auto* layout = new QVBoxLayout(content);
    const bool nothing = selection_.isEmpty(),
               material = nothing && document_.scene().materials.find(material_);
    if (nothing && !material) {
        addHint(content);
        showForm();
        return;
    }
    if (material) {
        addMaterials(content, {material_.value});
    } else {
        const std::vector<std::uint32_t> ids = selectedIds(selection_);
        switch (selection_.items().back().kind) {
            case ItemKind::Object:
                addForm(content, ids, buildObjectForm);
                addMaterials(content, materialsOf(document_.scene(), ids));
                break;
            case ItemKind::Group:
                addForm(content, ids, buildGroupForm);
                break;
            case ItemKind::Light:
                addForm(content, ids, buildLightForm);
                break;
            case ItemKind::Camera:
                addForm(content, ids, buildCameraForm);
                break;
        }
    }
    layout->addStretch(1);
    showForm();
    for (const auto& refresh : refreshes_) refresh(document_.scene());
}

}  // namespace glint
