#include "gui/app/material_previews.h"

#include "gui/app/document.h"
#include "gui/app/preview_scenes.h"

namespace glint {

MaterialPreviews::MaterialPreviews(const Document& document, PreviewRenderer& renderer,
                                   QObject* parent)
    : QObject(parent), document_(document), renderer_(renderer) {
    connect(&document, &Document::changed, this, &MaterialPreviews::onDocumentChanged);
    connect(&document, &Document::replaced, this, [this] { shown_.clear(); });
    connect(&renderer, &PreviewRenderer::ready, this, &MaterialPreviews::onReady);
    connect(&renderer, &PreviewRenderer::released, this, &MaterialPreviews::onReleased);
}

void MaterialPreviews::ask(Shown& shown, const Scene& scene, MaterialId material,
                           const QString& slot) {
    // Not even the key: writing down a scene for each material takes its time.
    if (renderer_.isHeld()) return;
    Scene preview = materialPreview(scene, material, {kSide, kSide});
    const QString key = previewKey(preview);
    if (key == shown.key) return;
    shown.key = key;
    if (const QImage made = renderer_.picture(key); !made.isNull())
        shown.picture = made;
    else
        renderer_.request({key, slot, std::move(preview), document_.assetFolder()});
}

QImage MaterialPreviews::of(MaterialId material) {
    if (!document_.scene().materials.find(material)) return {};
    Shown& shown = shown_[material];
    if (shown.key.isEmpty())
        ask(shown, document_.scene(), material, QStringLiteral("material %1").arg(material.value));
    return shown.picture;
}

void MaterialPreviews::hurry(MaterialId material) {
    if (const auto found = shown_.find(material);
        found != shown_.end() && found->second.picture.isNull())
        found->second.key.clear();
    (void)of(material);
}

QImage MaterialPreviews::of(const Scene& scene, MaterialId material, const QString& slot) {
    Shown& shown = slots_[slot];
    if (shown.key.isEmpty()) ask(shown, scene, material, slot);
    return shown.picture;
}

void MaterialPreviews::onDocumentChanged(const Scene& before) {
    const Scene& after = document_.scene();
    if (before.materials == after.materials && before.textures == after.textures) return;
    for (auto& [material, shown] : shown_) {
        const Material* now = after.materials.find(material);
        if (!now) continue;
        const Material* old = before.materials.find(material);
        // A mix changes with its parts: its key is asked again always.
        if (old && *old == *now && !std::holds_alternative<Mix>(now->value) &&
            before.textures == after.textures)
            continue;
        ask(shown, after, material, QStringLiteral("material %1").arg(material.value));
        emit changed(material);
    }
}

void MaterialPreviews::onReady(const QString& key, const QImage& picture) {
    for (auto& [material, shown] : shown_) {
        if (shown.key != key) continue;
        shown.picture = picture;
        emit changed(material);
    }
    for (auto& [slot, shown] : slots_) {
        if (shown.key != key) continue;
        shown.picture = picture;
        emit slotChanged(slot);
    }
}

// Whoever shows a picture asks for it again.
void MaterialPreviews::onReleased() {
    for (const auto& [material, shown] : shown_) emit changed(material);
    for (const auto& [slot, shown] : slots_) emit slotChanged(slot);
}

}  // namespace glint
