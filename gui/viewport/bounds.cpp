#include "gui/viewport/bounds.h"

#include <cmath>

namespace glint {

namespace {

constexpr int kRingPoints = 32, kRings = 12;

using Points = std::vector<DVec3>;

void addRing(Points& out, double radius, double y) {
    for (int i = 0; i < kRingPoints; ++i) {
        const double angle = 2 * kPi * i / kRingPoints;
        out.push_back({radius * std::cos(angle), y, radius * std::sin(angle)});
    }
}

void addCorners(Points& out, const DVec3& half) {
    for (int i = 0; i < 8; ++i)
        out.push_back(
            {i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z});
}

Points pointsOf(const Sphere& s) {
    Points out;
    for (int i = 0; i <= kRings; ++i) {
        const double angle = kPi * i / kRings;
        addRing(out, s.radius * std::sin(angle), s.radius * std::cos(angle));
    }
    return out;
}
Points pointsOf(const Box& s) {
    Points out;
    addCorners(out, s.size / 2.0);
    return out;
}
Points pointsOf(const Plane&) { return {}; }
Points pointsOf(const Quad& s) {
    Points out;
    addCorners(out, {s.size.x / 2, 0, s.size.y / 2});
    return out;
}
Points pointsOf(const Disk& s) {
    Points out;
    addRing(out, s.radius, 0);
    return out;
}
Points pointsOf(const Cylinder& s) {
    Points out;
    addRing(out, s.radius, s.height / 2);
    addRing(out, s.radius, -s.height / 2);
    return out;
}
Points pointsOf(const Cone& s) {
    Points out{{0, s.height / 2, 0}};
    addRing(out, s.radius, -s.height / 2);
    return out;
}
Points pointsOf(const Torus& s) {
    Points out;
    for (int i = 0; i <= kRings; ++i) {
        const double angle = kPi * i / kRings - kPi / 2;
        addRing(out, s.majorRadius + s.minorRadius * std::cos(angle),
                s.minorRadius * std::sin(angle));
    }
    return out;
}
/// Its file's extent is not known to the document: a cube stands for it.
Points pointsOf(const Mesh&) {
    Points out;
    addCorners(out, DVec3(0.5));
    return out;
}

void addObject(Bounds& bounds, const Scene& scene, const Object& object) {
    const Affine world = worldFromObject(scene, object);
    for (const DVec3& point : hullPoints(object.shape)) bounds.add(world.point(point));
}

}  // namespace

std::vector<DVec3> hullPoints(const Shape& shape) {
    return std::visit([](const auto& s) { return pointsOf(s); }, shape);
}

Bounds boundsOf(const Scene& scene, const std::vector<Item>& items) {
    Bounds bounds;
    for (const ObjectId id : objectsWithin(scene, items))
        addObject(bounds, scene, scene.objects.at(id));
    for (const Item item : items)
        if (item.kind == ItemKind::Light || item.kind == ItemKind::Camera)
            bounds.add(worldFromItem(scene, item).translation);
    return bounds;
}

Bounds boundsOf(const Scene& scene) {
    Bounds bounds;
    scene.objects.forEach([&](ObjectId, const Object& object) {
        if (isVisible(scene, object)) addObject(bounds, scene, object);
    });
    scene.lights.forEach([&](LightId id, const Light& light) {
        if (light.visible && !std::holds_alternative<SunLight>(light.value))
            bounds.add(worldFromItem(scene, Item::of(id)).translation);
    });
    return bounds;
}

}  // namespace glint
