// Mix: a blend of two materials, or of one and "clear" (straight through), linear in the BSDF.
// BsdfBuilder takes it apart.
#pragma once

#include "tracer/base/reflect.h"
#include "tracer/materials/bsdf.h"
#include "tracer/scene/ids.h"

namespace glint {

/// Nothing there: straight through.
struct ClearBsdf {
    static constexpr bool kSmooth = false, kDelta = true;

    [[nodiscard]] int branches(const Vec3& wo, float, DeltaBranch* out) const {
        out[0] = {-wo, Rgb(1.0f), true};
        return 1;
    }
};

struct Mix {
    MixPart a{}, b{};
    Textured<double> amount{0.5};

    bool operator==(const Mix&) const = default;
    static constexpr std::string_view kind = "mix";
    static constexpr auto fields() {
        return std::tuple{
            Field{"a", &Mix::a, {.required = true, .doc = "Material at amount 0, or clear"}},
            Field{"b", &Mix::b, {.required = true, .doc = "Material at amount 1, or clear"}},
            Field{"amount", &Mix::amount, {.min = 0, .max = 1, .doc = "0 is all a, 1 is all b"}}};
    }
};

}  // namespace glint
