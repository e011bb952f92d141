// LightBuffers: which shapes may lie between a light and a point, by the direction in which the
// light sees the point (Haines and Greenberg, "The Light Buffer: A Shadow-Testing Accelerator",
// IEEE CG&A 6(9), 1986). Lights may have a size: what is seen from their middle is widened by their
// radius. Start reading at between().
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "tracer/base/shared_list.h"
#include "tracer/compile/light_table.h"
#include "tracer/compile/shape_lists.h"

namespace glint {

/// Where a light is: around a point, or in a direction infinitely far away.
struct LightPlace {
    bool infinitelyFar = false;
    DVec3 at{0.0};      ///< its middle, or the unit vector towards it
    double radius = 0;  ///< [m]; infinitely far: tangent of half its angle
};

class LightBuffer {
  public:
    /// `reach`: no shape but planes extends farther from zero [m].
    LightBuffer(const LightPlace& place, const ShapeLists& lists, double reach);

    /// The shapes that rays between `p` and any part of the light can meet; null: it may be any.
    [[nodiscard, gnu::always_inline]] const FewShapes* between(const DVec3& p) const {
        const int index = place_.infinitelyFar ? farCell(p) : cell(p - place_.at);
        if (index < 0) return nullptr;
        const std::uint16_t few = cells_[static_cast<std::size_t>(index)];
        return few != kAny ? &few_[few] : nullptr;
    }

  private:
    static constexpr int kSide = 8;  ///< cells along an edge of a face of the cube around a light
    static constexpr std::uint16_t kAny = 0xffff;  ///< a cell from which any shape may be met
    static constexpr int kFarSide = 16;            ///< ... of the square before one infinitely far
    /// Rays to a light infinitely far away are followed from at most so many times the scene's
    /// reach before it.
    static constexpr double kDepth = 2;

    /// Of a place from -1 to 1 along an edge; any for one that is not a number.
    [[nodiscard]] static int column(double place, int side) {
        const double at = 0.5 * side * (place + 1);
        return at < side ? static_cast<int>(std::max(at, 0.0)) : side - 1;
    }
    /// The cell that a vector from the light points to; -1: it has no direction.
    [[nodiscard, gnu::always_inline]] static int cell(const DVec3& to) {
        const DVec3 sizes = absolute(to);
        int face = 4;
        double along = to.z, size = sizes.z, x = to.x, y = to.y;
        if (sizes.x >= sizes.y && sizes.x >= sizes.z) {
            if (!(sizes.x > 0)) return -1;
            face = 0, along = to.x, size = sizes.x, x = to.y, y = to.z;
        } else if (sizes.y >= sizes.z) {
            face = 2, along = to.y, size = sizes.y, x = to.z, y = to.x;
        }
        const double scale = 1 / size;
        face += along < 0 ? 1 : 0;
        return (face * kSide + column(y * scale, kSide)) * kSide + column(x * scale, kSide);
    }
    [[nodiscard]] int farCell(const DVec3& p) const {
        const double x = glm::dot(p, across_), y = glm::dot(p, up_);
        if (!(std::max(std::abs(x), std::abs(y)) <= reach_)) return -1;
        if (place_.radius > 0 && !(glm::dot(p, place_.at) >= -kDepth * reach_)) return -1;
        return column(y / reach_, kFarSide) * kFarSide + column(x / reach_, kFarSide);
    }
    void addCell(const RayBundle& bundle, const ShapeLists& lists);
    void addFace(int axis, double sign, const ShapeLists& lists);

    LightPlace place_;
    double reach_;
    DVec3 across_{0.0}, up_{0.0};       ///< infinitely far: the square's axes
    std::vector<FewShapes> few_{1};     ///< the first is empty
    std::vector<std::uint16_t> cells_;  ///< which of these, or kAny
};

/// The buffers of all lights that have one. Copies share them.
class LightBuffers {
  public:
    LightBuffers() = default;
    LightBuffers(const LightTable& lights, const std::vector<ShapeInstance>& shapes,
                 const ShapeLists& lists);

    /// See LightBuffer; for the light of that index.
    [[nodiscard, gnu::always_inline]] const FewShapes* between(std::uint32_t light,
                                                               const DVec3& p) const {
        if (of_.empty()) return nullptr;
        const std::optional<LightBuffer>& buffer = of_[light];
        return buffer ? buffer->between(p) : nullptr;
    }

  private:
    /// More lights are sampled one at a time, so each is worth less.
    static constexpr std::size_t kMostLights = 8;
    /// A light of more than this share of the scene's reach sees most shapes from everywhere.
    static constexpr double kMostRadius = 0.25;

    SharedList<std::optional<LightBuffer>> of_;  ///< by index of the light; or empty
};

}  // namespace glint
