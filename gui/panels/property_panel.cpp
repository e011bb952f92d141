#include "gui/panels/property_panel.h"

#include <QLabel>
#include <QScrollBar>
#include <QVBoxLayout>

#include "gui/app/document.h"
#include "gui/app/selection.h"
#include "gui/panels/item_forms.h"

namespace glint {

namespace {

Targets makeTargets(std::vector<std::uint32_t> ids) { return std::make_shared<const std::vector<std::uint32_t>>(std::move(ids)); }

/// The ids of the selected items of the active item's kind, the active one first: its values are shown.
std::vector<std::uint32_t> selectedIds(const Selection& selection) {
    std::vector<std::uint32_t> out;
    const Item active = selection.items().back();
    for (auto item = selection.items().rbegin(); item != selection.items().rend(); ++item)
        if (item->kind == active.kind) out.push_back(item->id);
    return out;
}

template <class Variant>
QString kindText(const Variant& value) {
    return toQString(kindOf(value)) + ' ';
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

QString PropertyPanel::structure() const {
    if (selection_.isEmpty()) return QStringLiteral("nothing");
    const Scene& scene = document_.scene();
    const ItemKind kind = selection_.items().back().kind;
    const std::vector<std::uint32_t> ids = selectedIds(selection_);
    QString out = QString::number(static_cast<int>(kind)) + ' ' + QString::number(scene.textures.size()) + ' ';
    for (const std::uint32_t id : ids) {
        out += QString::number(id) + ' ';
        if (kind == ItemKind::Object) out += kindText(scene.objects.at(ObjectId{id}).shape);
        if (kind == ItemKind::Light) out += kindText(scene.lights.at(LightId{id}).value);
    }
    if (kind != ItemKind::Object) return out;
    const auto materials = materialsOf(scene, ids);
    for (const std::uint32_t id : materials)
        out += QString::number(id) + ' ' + kindText(scene.materials.at(MaterialId{id}).value);
    for (const std::uint32_t id : texturesOf(scene, materials)) out += QString::number(id) + ' ';
    return out;
}

void PropertyPanel::rebuild() {
    builtFor_ = structure();
    refreshes_.clear();
    auto* content = new QWidget(this);
    auto* layout = new QVBoxLayout(content);
    if (selection_.isEmpty()) {
        auto* hint = new QLabel(tr("Nothing selected.\nClick an object in the picture or in the list."), content);
        hint->setAlignment(Qt::AlignCenter);
        hint->setWordWrap(true);
        hint->setEnabled(false);
        layout->addWidget(hint);
        setForm(content);
        return;
    }

    const ItemKind kind = selection_.items().back().kind;
    const std::vector<std::uint32_t> ids = selectedIds(selection_);
    const auto add = [&](std::vector<std::uint32_t> targets, void (*build)(FormBuilder&)) {
        if (targets.empty()) return;
        FormBuilder form(document_, makeTargets(std::move(targets)), content);
        build(form);
        for (auto& refresh : form.takeRefreshes()) refreshes_.push_back(std::move(refresh));
    };
    switch (kind) {
        case ItemKind::Object: {
            add(ids, buildObjectForm);
            const auto materials = materialsOf(document_.scene(), ids);
            add(materials, buildMaterialForm);
            add(texturesOf(document_.scene(), materials), buildTextureForm);
            break;
        }
        case ItemKind::Group: add(ids, buildGroupForm); break;
        case ItemKind::Light: add(ids, buildLightForm); break;
        case ItemKind::Camera: add(ids, buildCameraForm); break;
    }
    layout->addStretch(1);
    setForm(content);
    for (const auto& refresh : refreshes_) refresh(document_.scene());
}

}  // namespace glint
