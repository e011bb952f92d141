#include "tests/bench/shape_field.h"

#include <cmath>

#include "tracer/math/transform.h"

namespace glint::bench {

namespace {

ShapeInstance instanceOf(const CanonicalShape& shape, std::size_t count, Random& random, bool turned) {
    const double size = random(0.5, 1.5) * 0.25 * 2 * kHalfSize / std::cbrt(static_cast<double>(count));
    ShapeInstance out;
    out.shape = shape;
    out.center = random.point();
    DMat3 linear(size);
    if (turned) {
        linear = rotationFromDegrees({random(0, 360), random(0, 360), random(0, 360)});
        for (int axis = 0; axis < 3; ++axis) linear[axis] *= size * random(0.5, 1.5);
    }
    out.worldFromLocal = linear;
    out.localFromWorld = glm::inverse(linear);
    return out;
}

}  // namespace

std::vector<ShapeInstance> makeShapes(std::size_t count, FieldOf kind) {
    const CanonicalShape kinds[] = {CanonicalSphere{}, CanonicalBox{},  CanonicalQuad{},      CanonicalDisk{},
                                    CanonicalCylinder{}, CanonicalCone{}, CanonicalTorus{0.25}};
    Random random;
    std::vector<ShapeInstance> out;
    out.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t k = kind == FieldOf::Mixed ? i % 8 : 0;
        out.push_back(instanceOf(kinds[k == 7 ? 0 : k], count, random, kind == FieldOf::Mixed && k != 7));
    }
    return out;
}

std::vector<BenchRay> incoherentRays(std::size_t count) {
    Random random;
    random.engine.seed(11);
    std::vector<BenchRay> rays(count);
    for (BenchRay& r : rays) {
        r.ray.origin = random.point();
        r.ray.direction = random.direction();
        r.tMax = random(0, 2 * kHalfSize);
    }
    return rays;
}

std::vector<BenchRay> cameraRays(std::size_t side) {
    std::vector<BenchRay> rays(side * side);
    const DVec3 eye(0, 0, 3 * kHalfSize);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const DVec2 place = DVec2(static_cast<double>(i % side) + 0.5, static_cast<double>(i / side) + 0.5) / static_cast<double>(side) * 2.0 - 1.0;
        rays[i].ray.origin = eye;
        rays[i].ray.direction = glm::normalize(DVec3(kHalfSize * place.x, -kHalfSize * place.y, kHalfSize) - eye);
        rays[i].tMax = kInfinity;
    }
    return rays;
}

}  // namespace glint::bench
