// A few shapes as the tracer sees them, without a document: instances, their lists, and the media
// around a point.
#pragma once

#include "tests/support/rays.h"
#include "tracer/compile/render_scene.h"
#include "tracer/render/surface.h"

namespace glint::test {

struct World {
    RenderScene scene;

    /// All shapes are opaque; `dielectric` makes the closed ones glass of index 1.5.
    explicit World(std::vector<ShapeInstance> shapes, bool dielectric = false) {
        CompiledMaterial material;
        material.dielectric = dielectric;
        material.medium.ior = 1.5f;
        scene.materials.push_back(material);
        for (ShapeInstance& shape : shapes) shape.dielectric = dielectric && isClosed(shape.shape);
        scene.shapes = std::move(shapes);
        scene.lists = std::make_shared<const ShapeLists>(scene.shapes);
    }
    [[nodiscard]] SurfacePoint point(const Ray& ray, const ShapeHit& hit,
                                     const MediaStack& media = {}) const {
        return surfacePoint(scene, ray, hit, media);
    }
};

/// A random unit direction with z > 0, as toFloat() of a frame's local vector gives it; grazing
/// ones are as likely as others.
[[nodiscard]] inline Vec3 randomUp(Random& random) {
    DVec3 d = random.direction();
    d.z = std::abs(d.z);
    if (random.next() % 4 == 0) d.z *= random.logUniform(1e-7, 1);
    return toFloat(glm::normalize(d));
}

}  // namespace glint::test
