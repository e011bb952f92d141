// Mirror: perfect reflection, both sides.
#pragma once

#include "tracer/base/reflect.h"
#include "tracer/materials/bsdf.h"
#include "tracer/scene/ids.h"

namespace glint {

/// R = V - 2 (V . N) N with V = -wo.
struct MirrorBsdf {
    static constexpr bool kSmooth = false, kDelta = true;
    Rgb color;

    [[nodiscard]] int branches(const Vec3& wo, float, DeltaBranch* out) const {
        out[0] = {mirrored(wo), color};
        return 1;
    }
};

struct Mirror {
    Textured<Color> color{Color{0.95, 0.95, 0.95}};

    bool operator==(const Mirror&) const = default;
    static constexpr std::string_view kind = "mirror";
    static constexpr auto fields() {
        return std::tuple{Field{
            "color", &Mirror::color, {.min = 0, .max = 1, .doc = "Share of light reflected"}}};
    }
    template <class Builder>
    void compile(Builder& builder, const Rgb& weight) const {
        builder.add(MirrorBsdf{builder.value(color)}, weight);
    }
};

}  // namespace glint
