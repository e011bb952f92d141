// What can be done with the materials of a scene. Pure functions, see tracer/scene/edit.h for the
// basic ones.
#pragma once

#include <QMimeData>
#include <optional>
#include <string>
#include <vector>

#include "tracer/scene/scene.h"

namespace glint {

/// Gives the material to the objects.
[[nodiscard]] Scene withAssigned(Scene scene, const std::vector<ObjectId>& objects,
                                 MaterialId material);
/// Materials that an object has, or that such a one is made of.
[[nodiscard]] std::vector<MaterialId> usedMaterials(const Scene& scene);
[[nodiscard]] Scene withoutUnusedMaterials(Scene scene);

struct MaterialAdded {
    Scene scene;
    MaterialId id;
};
/// A copy under a free name.
[[nodiscard]] MaterialAdded withDuplicateMaterial(Scene scene, MaterialId material);

/// A material of this document on its way by drag and drop.
[[nodiscard]] QMimeData* materialMime(MaterialId material);
/// The material that is dragged, if it is one of `scene`.
[[nodiscard]] std::optional<MaterialId> draggedMaterial(const QMimeData* mime, const Scene& scene);
/// The type that materialMime() has.
extern const QString kMaterialMimeType;

}  // namespace glint
