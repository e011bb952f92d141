// Packets of eight coherent rays against one ball at a time, in float alone: the most that packets
// could gain over Glint's single rays against blocks of eight shapes, because nothing is decided in
// double and no hit is described.
#pragma once

#include <cmath>
#include <vector>

#include "tests/bench/shape_field.h"

namespace glint::bench {

class PacketBalls {
  public:
    static constexpr std::size_t kWidth = 8;

    explicit PacketBalls(const std::vector<ShapeInstance>& shapes) {
        for (const ShapeInstance& shape : shapes) {
            const auto radius =
                static_cast<float>(std::cbrt(std::abs(glm::determinant(shape.worldFromLocal))));
            balls_.push_back({toFloat(shape.center), radius * radius});
        }
    }
    [[nodiscard]] static bool isSupported() {
        return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    }

    /// Of so many rays from one point, a multiple of kWidth, those that hit. Needs isSupported().
    [[nodiscard]] __attribute__((target("avx2,fma"))) std::size_t hits(
        const std::vector<BenchRay>& rays) const {
        std::size_t out = 0;
        for (std::size_t first = 0; first < rays.size(); first += kWidth) {
            Lanes ox, oy, oz, dx, dy, dz;
            for (std::size_t i = 0; i < kWidth; ++i) {
                const Vec3 o = toFloat(rays[first + i].ray.origin),
                           d = toFloat(rays[first + i].ray.direction);
                ox[i] = o.x, oy[i] = o.y, oz[i] = o.z;
                dx[i] = d.x, dy[i] = d.y, dz[i] = d.z;
            }
            Lanes nearest = Lanes{} + 1e30f;
            for (const Ball& ball : balls_) {
                const Lanes cx = ball.center.x - ox, cy = ball.center.y - oy,
                            cz = ball.center.z - oz;
                const Lanes along = cx * dx + cy * dy + cz * dz;
                const Lanes px = cx - along * dx, py = cy - along * dy, pz = cz - along * dz;
                const Lanes inside = ball.radius2 - (px * px + py * py + pz * pz);
                const Lanes half = root(inside);
                const Lanes t = along - half > 0 ? along - half : along + half;
                nearest = inside > 0 && t > 0 && t < nearest ? t : nearest;
            }
            for (std::size_t i = 0; i < kWidth; ++i) out += nearest[i] < 1e30f;
        }
        return out;
    }

  private:
    using Lanes = float __attribute__((vector_size(sizeof(float) * kWidth)));
    struct Ball {
        Vec3 center;
        float radius2;
    };
    [[nodiscard]] __attribute__((target("avx2,fma"), always_inline)) static inline Lanes root(
        Lanes square) {
        for (std::size_t i = 0; i < kWidth; ++i) square[i] = std::sqrt(std::max(square[i], 0.0f));
        return square;
    }

    std::vector<Ball> balls_;
};

}  // namespace glint::bench
