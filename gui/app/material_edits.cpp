#include "gui/app/material_edits.h"

#include <QCoreApplication>
#include <set>

#include "tracer/scene/edit.h"

namespace glint {

const QString kMaterialMimeType = QStringLiteral("application/x-glint-material");

Scene withAssigned(Scene scene, const std::vector<ObjectId>& objects, MaterialId material) {
    for (const ObjectId id : objects) {
        const Object* object = scene.objects.find(id);
        if (!object || object->material == material) continue;
        Object changed = *object;
        changed.material = material;
        scene.objects.set(id, std::move(changed));
    }
    return scene;
}

std::vector<MaterialId> usedMaterials(const Scene& scene) {
    std::set<MaterialId> used;
    const auto add = [&](auto&& self, MaterialId id) -> void {
        if (!id || !scene.materials.find(id) || !used.insert(id).second) return;
        if (const auto* mix = std::get_if<Mix>(&scene.materials.at(id).value)) {
            self(self, mix->a.material);
            self(self, mix->b.material);
        }
    };
    scene.objects.forEach([&](ObjectId, const Object& object) { add(add, object.material); });
    return {used.begin(), used.end()};
}

Scene withoutUnusedMaterials(Scene scene) {
    const std::vector<MaterialId> list = usedMaterials(scene);
    const std::set<MaterialId> used(list.begin(), list.end());
    for (const MaterialId id : scene.materials.ids())
        if (!used.contains(id)) scene.materials.erase(id);
    return scene;
}

MaterialAdded withDuplicateMaterial(Scene scene, MaterialId material) {
    Material copy = scene.materials.at(material);
    auto [next, id] = withMaterial(std::move(scene), std::move(copy));
    return {std::move(next), id};
}

QMimeData* materialMime(MaterialId material) {
    auto* mime = new QMimeData;
    // The process too: an id means nothing in another window.
    mime->setData(kMaterialMimeType, QByteArray::number(QCoreApplication::applicationPid()) + ' ' +
                                         QByteArray::number(material.value));
    return mime;
}

std::optional<MaterialId> draggedMaterial(const QMimeData* mime, const Scene& scene) {
    if (!mime || !mime->hasFormat(kMaterialMimeType)) return std::nullopt;
    const QList<QByteArray> parts = mime->data(kMaterialMimeType).split(' ');
    if (parts.size() != 2 || parts[0].toLongLong() != QCoreApplication::applicationPid())
        return std::nullopt;
    const MaterialId id{parts[1].toUInt()};
    return scene.materials.find(id) ? std::optional(id) : std::nullopt;
}

}  // namespace glint
