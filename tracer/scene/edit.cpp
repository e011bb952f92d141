#include "tracer/scene/edit.h"

#include <set>

namespace glint {

namespace {

template <class Table>
std::string freeName(const Table& table, std::string_view wanted) {
    std::set<std::string, std::less<>> used;
    table.forEach([&](auto, const auto& value) { used.insert(value.name); });
    std::string base(wanted.empty() ? "Unnamed" : wanted);
    if (!used.contains(base)) return base;
    // "Ball 2" continues as "Ball 3", not as "Ball 2 2".
    const std::size_t space = base.rfind(' ');
    if (space != std::string::npos && space + 1 < base.size() &&
        base.find_first_not_of("0123456789", space + 1) == std::string::npos)
        base.resize(space);
    for (int number = 2;; ++number) {
        std::string name = base + " " + std::to_string(number);
        if (!used.contains(name)) return name;
    }
}

template <class Table, class Value>
auto added(Scene scene, Table Scene::*table, Value value) {
    value.name = freeName(scene.*table, value.name);
    auto id = (scene.*table).add(std::move(value));
    return Added<decltype(id)>{std::move(scene), id};
}

bool isWithin(const Scene& scene, GroupId group, GroupId ancestor) {
    for (; group; group = scene.groups.at(group).parent)
        if (group == ancestor) return true;
    return false;
}

/// The transform that puts something with world matrix `world` at the same place under `parent`.
Transform keptPlace(const Scene& scene, const Transform& old, const Affine& world, GroupId parent) {
    if (!parent && toAffine(old) == world) return old;
    const auto parentFromWorld = inverse(worldFromGroup(scene, parent));
    return parentFromWorld ? toTransform(*parentFromWorld * world) : old;
}

}  // namespace

std::string freeObjectName(const Scene& scene, std::string_view wanted) {
    return freeName(scene.objects, wanted);
}
std::string freeGroupName(const Scene& scene, std::string_view wanted) {
    return freeName(scene.groups, wanted);
}
std::string freeMaterialName(const Scene& scene, std::string_view wanted) {
    return freeName(scene.materials, wanted);
}
std::string freeLightName(const Scene& scene, std::string_view wanted) {
    return freeName(scene.lights, wanted);
}
std::string freeCameraName(const Scene& scene, std::string_view wanted) {
    return freeName(scene.cameras, wanted);
}

Added<ObjectId> withObject(Scene scene, Object object) {
    return added(std::move(scene), &Scene::objects, std::move(object));
}
Added<GroupId> withGroup(Scene scene, Group group) {
    return added(std::move(scene), &Scene::groups, std::move(group));
}
Added<MaterialId> withMaterial(Scene scene, Material material) {
    return added(std::move(scene), &Scene::materials, std::move(material));
}
Added<LightId> withLight(Scene scene, Light light) {
    return added(std::move(scene), &Scene::lights, std::move(light));
}
Added<CameraId> withCamera(Scene scene, Camera camera) {
    return added(std::move(scene), &Scene::cameras, std::move(camera));
}

Scene withoutObjects(Scene scene, const std::vector<ObjectId>& objects) {
    for (const ObjectId id : objects)
        if (scene.objects.find(id)) scene.objects.erase(id);
    return scene;
}

Scene withoutGroup(Scene scene, GroupId group) {
    const GroupId parent = scene.groups.at(group).parent;
    std::vector<ObjectId> objects;
    scene.objects.forEach([&](ObjectId id, const Object& o) {
        if (o.parent == group) objects.push_back(id);
    });
    std::vector<GroupId> groups;
    scene.groups.forEach([&](GroupId id, const Group& g) {
        if (g.parent == group) groups.push_back(id);
    });
    scene = reparented(std::move(scene), objects, parent);
    for (const GroupId child : groups) scene = reparentedGroup(std::move(scene), child, parent);
    scene.groups.erase(group);
    return scene;
}

Scene withoutLight(Scene scene, LightId light) {
    scene.lights.erase(light);
    return scene;
}

Scene withoutMaterial(Scene scene, MaterialId material, MaterialId replacement) {
    for (const ObjectId id : scene.objects.ids()) {
        Object object = scene.objects.at(id);
        if (object.material != material) continue;
        object.material = replacement;
        scene.objects.set(id, std::move(object));
    }
    for (const MaterialId id : scene.materials.ids()) {
        Material user = scene.materials.at(id);
        auto* mix = std::get_if<Mix>(&user.value);
        if (!mix || (mix->a.material != material && mix->b.material != material)) continue;
        for (MixPart* part : {&mix->a, &mix->b})
            if (part->material == material)
                *part = replacement ? MixPart{replacement, false} : MixPart{{}, true};
        scene.materials.set(id, std::move(user));
    }
    scene.materials.erase(material);
    return scene;
}

Duplicated withDuplicates(Scene scene, const std::vector<ObjectId>& objects) {
    std::vector<ObjectId> copies;
    for (const ObjectId id : objects) {
        auto [next, copy] = withObject(scene, scene.objects.at(id));
        scene = std::move(next);
        copies.push_back(copy);
    }
    return {std::move(scene), std::move(copies)};
}

Scene reparented(Scene scene, const std::vector<ObjectId>& objects, GroupId parent) {
    for (const ObjectId id : objects) {
        Object object = scene.objects.at(id);
        object.transform =
            keptPlace(scene, object.transform, worldFromObject(scene, object), parent);
        object.parent = parent;
        scene.objects.set(id, std::move(object));
    }
    return scene;
}

Scene reparentedGroup(Scene scene, GroupId group, GroupId parent) {
    if (isWithin(scene, parent, group)) return scene;
    Group moved = scene.groups.at(group);
    moved.transform = keptPlace(scene, moved.transform, worldFromGroup(scene, group), parent);
    moved.parent = parent;
    scene.groups.set(group, std::move(moved));
    return scene;
}

Scene withWorldTransform(Scene scene, ObjectId object, const Affine& world) {
    Object moved = scene.objects.at(object);
    moved.transform = keptPlace(scene, moved.transform, world, moved.parent);
    scene.objects.set(object, std::move(moved));
    return scene;
}

}  // namespace glint
