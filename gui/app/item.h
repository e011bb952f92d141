// Item: one entry of the object list (object, group, light or camera), and what all of them can do.
// Pure functions.
#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <vector>

#include "tracer/scene/scene.h"

namespace glint {

enum class ItemKind : std::uint8_t { Group, Object, Light, Camera };

/// A reference into a scene. Camera 0 is the scene's own `camera`, the others are entries of
/// `cameras`.
struct Item {
    ItemKind kind = ItemKind::Object;
    std::uint32_t id = 0;
    auto operator<=>(const Item&) const = default;  // NOLINT(modernize-use-nullptr): false alarm

    static Item of(ObjectId id) { return {ItemKind::Object, id.value}; }
    static Item of(GroupId id) { return {ItemKind::Group, id.value}; }
    static Item of(LightId id) { return {ItemKind::Light, id.value}; }
    static Item of(CameraId id) { return {ItemKind::Camera, id.value}; }
};

[[nodiscard]] bool exists(const Scene& scene, Item item);
/// The item's name; empty for the scene's own camera, which has none.
[[nodiscard]] std::string nameOf(const Scene& scene, Item item);
/// Why the item cannot get this name (empty, or taken); empty if it can.
enum class NameFault { None, Empty, Taken, Fixed };
[[nodiscard]] NameFault nameFault(const Scene& scene, Item item, const std::string& name);
[[nodiscard]] Scene renamed(Scene scene, Item item, std::string name);

/// The item's own switch, not that of its groups. Cameras are always visible; only objects and
/// groups can be locked.
[[nodiscard]] bool isVisible(const Scene& scene, Item item);
[[nodiscard]] bool isLocked(const Scene& scene, Item item);
/// Locked itself or by a group above it.
[[nodiscard]] bool isLockedInTree(const Scene& scene, Item item);
[[nodiscard]] Scene withVisible(Scene scene, Item item, bool visible);
[[nodiscard]] Scene withLocked(Scene scene, Item item, bool locked);

/// The group that holds the item; none for lights and cameras.
[[nodiscard]] GroupId parentOf(const Scene& scene, Item item);
/// Moves the item into `parent`, keeping its place; lights and cameras stay where they are.
[[nodiscard]] Scene movedInto(Scene scene, Item item, GroupId parent);

/// Where gizmos act: world transform of objects and groups, place (and aim) of lights and cameras.
[[nodiscard]] Affine worldFromItem(const Scene& scene, Item item);
/// Applies `change` (world from world) to the item.
[[nodiscard]] Scene transformed(Scene scene, Item item, const Affine& change);

/// Without items whose group is in the list too, so that nothing is moved twice.
[[nodiscard]] std::vector<Item> topmost(const Scene& scene, const std::vector<Item>& items);
/// Copies with free names; of a group all that it holds.
struct CopiedItems {
    Scene scene;
    std::vector<Item> copies;
};
[[nodiscard]] CopiedItems duplicated(Scene scene, const std::vector<Item>& items);
/// Without the items; a group goes with all that it holds. The scene's own camera stays.
[[nodiscard]] Scene removed(Scene scene, const std::vector<Item>& items);
/// All objects within the groups among `items`, and the objects among them.
[[nodiscard]] std::vector<ObjectId> objectsWithin(const Scene& scene,
                                                  const std::vector<Item>& items);

}  // namespace glint
