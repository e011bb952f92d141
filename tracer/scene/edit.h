// Edits: pure functions Scene -> Scene. The editor's commands, paste and tests share them; undo
// keeps the old value.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tracer/scene/scene.h"

namespace glint {

/// A name not yet used in the table: `wanted`, or with " 2", " 3" ... behind it.
[[nodiscard]] std::string freeObjectName(const Scene& scene, std::string_view wanted);
[[nodiscard]] std::string freeGroupName(const Scene& scene, std::string_view wanted);
[[nodiscard]] std::string freeMaterialName(const Scene& scene, std::string_view wanted);
[[nodiscard]] std::string freeLightName(const Scene& scene, std::string_view wanted);
[[nodiscard]] std::string freeCameraName(const Scene& scene, std::string_view wanted);

/// A changed scene, and what is new in it.
template <class IdType>
struct Added {
    Scene scene;
    IdType id;
};

/// Adds with a free name made from the value's own.
[[nodiscard]] Added<ObjectId> withObject(Scene scene, Object object);
[[nodiscard]] Added<GroupId> withGroup(Scene scene, Group group);
[[nodiscard]] Added<MaterialId> withMaterial(Scene scene, Material material);
[[nodiscard]] Added<LightId> withLight(Scene scene, Light light);
[[nodiscard]] Added<CameraId> withCamera(Scene scene, Camera camera);

[[nodiscard]] Scene withoutObjects(Scene scene, const std::vector<ObjectId>& objects);
/// Removes the group; what it held moves to its parent and keeps its place in the world.
[[nodiscard]] Scene withoutGroup(Scene scene, GroupId group);
[[nodiscard]] Scene withoutLight(Scene scene, LightId light);
/// Objects and mixes that used it get `replacement` (none: black objects; in a mix: clear).
[[nodiscard]] Scene withoutMaterial(Scene scene, MaterialId material, MaterialId replacement);

/// Copies of the objects, with free names, in the order given.
struct Duplicated {
    Scene scene;
    std::vector<ObjectId> copies;
};
[[nodiscard]] Duplicated withDuplicates(Scene scene, const std::vector<ObjectId>& objects);

/// Moves objects or a group into `parent` (none: the top), keeping their place in the world. A
/// group cannot go into itself: then the scene comes back unchanged.
[[nodiscard]] Scene reparented(Scene scene, const std::vector<ObjectId>& objects, GroupId parent);
[[nodiscard]] Scene reparentedGroup(Scene scene, GroupId group, GroupId parent);

/// Sets an object's transform so that its world transform becomes `world`.
[[nodiscard]] Scene withWorldTransform(Scene scene, ObjectId object, const Affine& world);

}  // namespace glint
