#include "tests/bench/shape_field.h"

#include <cmath>

#include "tracer/math/transform.h"

namespace glint::bench {

namespace {

ShapeInstance instanceOf(const CanonicalShape& shape, std::size_t count, Random& random,
                         bool turned) {
    const double size =
        random(0.5, 1.5) * 0.25 * 2 * kHalfSize / std::cbrt(static_cast<double>(count));
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
    const CanonicalShape kinds[] = {CanonicalSphere{},   CanonicalBox{},      CanonicalQuad{},
                                    CanonicalDisk{},     CanonicalCylinder{}, CanonicalCone{},
                                    CanonicalTorus{0.25}};
    Random random;
    std::vector<ShapeInstance> out;
    out.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t k = kind == FieldOf::Mixed ? i % 8 : 0;
        out.push_back(
            instanceOf(kinds[k == 7 ? 0 : k], count, random, kind == FieldOf::Mixed && k != 7));
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

CameraModel fieldCamera(int side) {
    Camera camera;
    camera.position = {0, 0, 3 * kHalfSize};
    camera.target = DVec3(0.0);
    camera.verticalFovDegrees = radiansToDegrees(2 * std::atan(0.5));
    return {camera, DVec3(0.0), side, side};
}

std::vector<BenchRay> cameraRays(int side) {
    const CameraModel camera = fieldCamera(side);
    std::vector<BenchRay> rays;
    for (int top = 0; top < side; top += kBenchTile)
        for (int left = 0; left < side; left += kBenchTile)
            for (int y = top; y < top + kBenchTile; ++y)
                for (int x = left; x < left + kBenchTile; ++x)
                    rays.push_back({camera.ray(x + 0.5, y + 0.5), kInfinity});
    return rays;
}

}  // namespace glint::bench
