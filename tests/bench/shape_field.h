// Random shapes and rays in a cube, for measurements of the shape lists alone.
#pragma once

#include <random>
#include <vector>

#include "tracer/compile/camera_model.h"
#include "tracer/compile/shape_lists.h"
#include "tracer/math/warp.h"

namespace glint::bench {

inline constexpr double kHalfSize = 10;  ///< of the cube [m]

struct Random {
    std::mt19937_64 engine{7};
    double operator()(double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(engine);
    }
    DVec3 point() {
        return {(*this)(-kHalfSize, kHalfSize), (*this)(-kHalfSize, kHalfSize),
                (*this)(-kHalfSize, kHalfSize)};
    }
    DVec3 direction() { return uniformSphere({(*this)(0, 1), (*this)(0, 1)}); }
};

enum class FieldOf { Balls, Mixed };

/// Shapes of about a quarter of the mean distance between them, at random places. Mixed: of eight,
/// two spheres, one of them round, and one of each other finite shape, turned and scaled.
[[nodiscard]] std::vector<ShapeInstance> makeShapes(std::size_t count, FieldOf kind);

struct BenchRay {
    Ray ray;
    double tMax;  ///< for shadow rays [m]
};
/// From random points of the cube in random directions, up to a cube's side away.
[[nodiscard]] std::vector<BenchRay> incoherentRays(std::size_t count);
/// A camera outside that sees the whole cube in a square picture.
[[nodiscard]] CameraModel fieldCamera(int side);
inline constexpr int kBenchTile = 16;
/// Its rays through the middles of `side` squared pixels, tile by tile (rows of kBenchTile
/// squared); `side` is a multiple.
[[nodiscard]] std::vector<BenchRay> cameraRays(int side);

}  // namespace glint::bench
