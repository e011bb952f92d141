#include "gui/app/item.h"

#include <algorithm>
#include <map>
#include <set>

#include "tracer/scene/edit.h"

namespace glint {

namespace {

ObjectId objectOf(Item item) { return ObjectId{item.id}; }
GroupId groupOf(Item item) { return GroupId{item.id}; }
LightId lightOf(Item item) { return LightId{item.id}; }
CameraId cameraOf(Item item) { return CameraId{item.id}; }

/// Sets one member of a table's entry.
template <class Table, class IdType, class T, class Member>
void setMember(Table& table, IdType id, Member T::*member, Member value) {
    T changed = table.at(id);
    changed.*member = std::move(value);
    table.set(id, std::move(changed));
}

template <class Table>
bool hasName(const Table& table, std::uint32_t except, const std::string& name) {
    bool found = false;
    table.forEach([&](auto id, const auto& value) {
        found = found || (id.value != except && value.name == name);
    });
    return found;
}

bool isWithin(const Scene& scene, GroupId group, const std::set<GroupId>& ancestors) {
    for (; group; group = scene.groups.at(group).parent)
        if (ancestors.contains(group)) return true;
    return false;
}

std::set<GroupId> groupsAmong(const std::vector<Item>& items) {
    std::set<GroupId> groups;
    for (const Item item : items)
        if (item.kind == ItemKind::Group) groups.insert(groupOf(item));
    return groups;
}

/// The groups in `roots` and all below them, parents first.
std::vector<GroupId> groupsWithin(const Scene& scene, const std::set<GroupId>& roots) {
    std::vector<GroupId> out;
    scene.groups.forEach([&](GroupId id, const Group&) {
        if (isWithin(scene, id, roots)) out.push_back(id);
    });
    const auto depth = [&](GroupId id) {
        int n = 0;
        for (; id; id = scene.groups.at(id).parent) ++n;
        return n;
    };
    std::stable_sort(out.begin(), out.end(),
                     [&](GroupId a, GroupId b) { return depth(a) < depth(b); });
    return out;
}

Light transformedLight(Light light, const Affine& change) {
    std::visit(
        [&](auto& l) {
            if constexpr (requires { l.position; }) l.position = change.point(l.position);
            if constexpr (requires { l.target; }) l.target = change.point(l.target);
            if constexpr (requires { l.direction; }) l.direction = change.vector(l.direction);
        },
        light.value);
    return light;
}

Camera transformedCamera(Camera camera, const Affine& change) {
    camera.position = change.point(camera.position);
    camera.target = change.point(camera.target);
    camera.up = glm::normalize(change.vector(camera.up));
    return camera;
}

}  // namespace

bool exists(const Scene& scene, Item item) {
    switch (item.kind) {
        case ItemKind::Object:
            return scene.objects.find(objectOf(item)) != nullptr;
        case ItemKind::Group:
            return scene.groups.find(groupOf(item)) != nullptr;
        case ItemKind::Light:
            return scene.lights.find(lightOf(item)) != nullptr;
        case ItemKind::Camera:
            return item.id == 0 || scene.cameras.find(cameraOf(item)) != nullptr;
    }
    return false;
}

std::string nameOf(const Scene& scene, Item item) {
    switch (item.kind) {
        case ItemKind::Object:
            return scene.objects.at(objectOf(item)).name;
        case ItemKind::Group:
            return scene.groups.at(groupOf(item)).name;
        case ItemKind::Light:
            return scene.lights.at(lightOf(item)).name;
        case ItemKind::Camera:
            return item.id == 0 ? std::string() : scene.cameras.at(cameraOf(item)).name;
    }
    return {};
}

NameFault nameFault(const Scene& scene, Item item, const std::string& name) {
    if (name.empty()) return NameFault::Empty;
    bool taken = false;
    switch (item.kind) {
        case ItemKind::Object:
            taken = hasName(scene.objects, item.id, name);
            break;
        case ItemKind::Group:
            taken = hasName(scene.groups, item.id, name);
            break;
        case ItemKind::Light:
            taken = hasName(scene.lights, item.id, name);
            break;
        case ItemKind::Camera:
            if (item.id == 0) return NameFault::Fixed;
            taken = hasName(scene.cameras, item.id, name);
            break;
    }
    return taken ? NameFault::Taken : NameFault::None;
}

Scene renamed(Scene scene, Item item, std::string name) {
    switch (item.kind) {
        case ItemKind::Object:
            setMember(scene.objects, objectOf(item), &Object::name, std::move(name));
            break;
        case ItemKind::Group:
            setMember(scene.groups, groupOf(item), &Group::name, std::move(name));
            break;
        case ItemKind::Light:
            setMember(scene.lights, lightOf(item), &Light::name, std::move(name));
            break;
        case ItemKind::Camera:
            setMember(scene.cameras, cameraOf(item), &Camera::name, std::move(name));
            break;
    }
    return scene;
}

bool isVisible(const Scene& scene, Item item) {
    switch (item.kind) {
        case ItemKind::Object:
            return scene.objects.at(objectOf(item)).visible;
        case ItemKind::Group:
            return scene.groups.at(groupOf(item)).visible;
        case ItemKind::Light:
            return scene.lights.at(lightOf(item)).visible;
        case ItemKind::Camera:
            return true;
    }
    return true;
}

bool isLocked(const Scene& scene, Item item) {
    if (item.kind == ItemKind::Object) return scene.objects.at(objectOf(item)).locked;
    return item.kind == ItemKind::Group && scene.groups.at(groupOf(item)).locked;
}

bool isLockedInTree(const Scene& scene, Item item) {
    if (isLocked(scene, item)) return true;
    for (GroupId group = parentOf(scene, item); group; group = scene.groups.at(group).parent)
        if (scene.groups.at(group).locked) return true;
    return false;
}

Scene withVisible(Scene scene, Item item, bool visible) {
    switch (item.kind) {
        case ItemKind::Object:
            setMember(scene.objects, objectOf(item), &Object::visible, visible);
            break;
        case ItemKind::Group:
            setMember(scene.groups, groupOf(item), &Group::visible, visible);
            break;
        case ItemKind::Light:
            setMember(scene.lights, lightOf(item), &Light::visible, visible);
            break;
        case ItemKind::Camera:
            break;
    }
    return scene;
}

Scene withLocked(Scene scene, Item item, bool locked) {
    if (item.kind == ItemKind::Object)
        setMember(scene.objects, objectOf(item), &Object::locked, locked);
    if (item.kind == ItemKind::Group)
        setMember(scene.groups, groupOf(item), &Group::locked, locked);
    return scene;
}

GroupId parentOf(const Scene& scene, Item item) {
    if (item.kind == ItemKind::Object) return scene.objects.at(objectOf(item)).parent;
    return item.kind == ItemKind::Group ? scene.groups.at(groupOf(item)).parent : GroupId{};
}

Scene movedInto(Scene scene, Item item, GroupId parent) {
    if (parentOf(scene, item) == parent) return scene;
    if (item.kind == ItemKind::Object)
        return reparented(std::move(scene), {objectOf(item)}, parent);
    if (item.kind == ItemKind::Group)
        return reparentedGroup(std::move(scene), groupOf(item), parent);
    return scene;
}

Affine worldFromItem(const Scene& scene, Item item) {
    switch (item.kind) {
        case ItemKind::Object:
            return worldFromObject(scene, scene.objects.at(objectOf(item)));
        case ItemKind::Group:
            return worldFromGroup(scene, groupOf(item));
        case ItemKind::Light: {
            Affine out;
            std::visit(
                [&](const auto& l) {
                    if constexpr (requires { l.position; }) out.translation = l.position;
                },
                scene.lights.at(lightOf(item)).value);
            return out;
        }
        case ItemKind::Camera: {
            const Camera& camera = item.id == 0 ? scene.camera : scene.cameras.at(cameraOf(item));
            return {DMat3(1.0), camera.position};
        }
    }
    return {};
}

Scene transformed(Scene scene, Item item, const Affine& change) {
    switch (item.kind) {
        case ItemKind::Object:
            return withWorldTransform(scene, objectOf(item), change * worldFromItem(scene, item));
        case ItemKind::Group: {
            Group group = scene.groups.at(groupOf(item));
            const auto parentFromWorld = inverse(worldFromGroup(scene, group.parent));
            if (!parentFromWorld) return scene;
            group.transform =
                toTransform(*parentFromWorld * change * worldFromGroup(scene, groupOf(item)));
            scene.groups.set(groupOf(item), std::move(group));
            return scene;
        }
        case ItemKind::Light:
            scene.lights.set(lightOf(item),
                             transformedLight(scene.lights.at(lightOf(item)), change));
            return scene;
        case ItemKind::Camera:
            if (item.id == 0)
                scene.camera = transformedCamera(scene.camera, change);
            else
                scene.cameras.set(cameraOf(item),
                                  transformedCamera(scene.cameras.at(cameraOf(item)), change));
            return scene;
    }
    return scene;
}

std::vector<Item> topmost(const Scene& scene, const std::vector<Item>& items) {
    const std::set<GroupId> groups = groupsAmong(items);
    std::vector<Item> out;
    for (const Item item : items)
        if (!isWithin(scene, parentOf(scene, item), groups)) out.push_back(item);
    return out;
}

CopiedItems duplicated(Scene scene, const std::vector<Item>& items) {
    CopiedItems out;
    const std::vector<Item> tops = topmost(scene, items);
    const std::vector<GroupId> groups = groupsWithin(scene, groupsAmong(tops));
    const std::vector<ObjectId> objects = objectsWithin(scene, tops);
    std::map<GroupId, GroupId> copyOf;
    const auto mapped = [&](GroupId parent) {
        return copyOf.contains(parent) ? copyOf.at(parent) : parent;
    };
    const std::set<Item> chosen(tops.begin(), tops.end());
    const auto note = [&](Item original, Item copy) {
        if (chosen.contains(original)) out.copies.push_back(copy);
    };
    for (const GroupId id : groups) {
        Group copy = scene.groups.at(id);
        copy.parent = mapped(copy.parent);
        auto [next, copyId] = withGroup(std::move(scene), std::move(copy));
        scene = std::move(next);
        copyOf[id] = copyId;
        note(Item::of(id), Item::of(copyId));
    }
    for (const ObjectId id : objects) {
        Object copy = scene.objects.at(id);
        copy.parent = mapped(copy.parent);
        auto [next, copyId] = withObject(std::move(scene), std::move(copy));
        scene = std::move(next);
        note(Item::of(id), Item::of(copyId));
    }
    for (const Item item : tops) {
        if (item.kind == ItemKind::Light) {
            auto [next, id] = withLight(scene, scene.lights.at(lightOf(item)));
            scene = std::move(next);
            out.copies.push_back(Item::of(id));
        } else if (item.kind == ItemKind::Camera) {
            Camera copy = item.id == 0 ? scene.camera : scene.cameras.at(cameraOf(item));
            if (copy.name.empty()) copy.name = "Camera";
            auto [next, id] = withCamera(std::move(scene), std::move(copy));
            scene = std::move(next);
            out.copies.push_back(Item::of(id));
        }
    }
    out.scene = std::move(scene);
    return out;
}

Scene removed(Scene scene, const std::vector<Item>& items) {
    const std::vector<ObjectId> objects = objectsWithin(scene, items);
    scene = withoutObjects(std::move(scene), objects);
    std::vector<GroupId> groups = groupsWithin(scene, groupsAmong(items));
    std::reverse(groups.begin(), groups.end());
    for (const GroupId id : groups) scene.groups.erase(id);
    for (const Item item : items) {
        if (item.kind == ItemKind::Light && exists(scene, item)) scene.lights.erase(lightOf(item));
        if (item.kind != ItemKind::Camera || item.id == 0 || !exists(scene, item)) continue;
        if (scene.activeCamera == cameraOf(item)) {
            // The view stays where it is: the scene's own camera takes it over.
            scene.camera = scene.cameras.at(cameraOf(item));
            scene.camera.name.clear();
            scene.activeCamera = {};
        }
        scene.cameras.erase(cameraOf(item));
    }
    return scene;
}

std::vector<ObjectId> objectsWithin(const Scene& scene, const std::vector<Item>& items) {
    const std::set<GroupId> groups = groupsAmong(items);
    std::vector<ObjectId> out;
    for (const Item item : items)
        if (item.kind == ItemKind::Object && exists(scene, item)) out.push_back(objectOf(item));
    if (!groups.empty())
        scene.objects.forEach([&](ObjectId id, const Object& o) {
            if (isWithin(scene, o.parent, groups)) out.push_back(id);
        });
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

}  // namespace glint
