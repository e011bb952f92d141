// Rays in render space (double). A ray knows which surface it starts on, so that no epsilon has to
// keep it from hitting that surface again: see shapes/crossing.h.
#pragma once

#include <cstdint>

#include "tracer/math/types.h"

namespace glint {

inline constexpr std::uint32_t kNoShape = ~0u;

struct Ray {
    DVec3 origin{0.0};
    DVec3 direction{0.0, 0.0, -1.0};     ///< unit length
    std::uint32_t fromShape = kNoShape;  ///< index of the shape instance the origin lies on
    bool fromInside = false;             ///< the ray starts towards the inside of `fromShape`
    bool returns = false;  ///< it starts towards the side of `fromShape` that the path came from
    std::uint64_t passed =
        0;  ///< tieRank() (compile/coincidence.h) of `fromShape` if the path goes through it; 0: it
            ///< does not, or is tracked to be inside or outside

    [[nodiscard]] DVec3 at(double t) const { return origin + t * direction; }
};

}  // namespace glint
