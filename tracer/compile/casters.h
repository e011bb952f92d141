// Casters: perfect balls and flat faces (mirrors, clear glass) that throw light into caustics, and
// the lights small enough for these to matter. For next-event estimation by way of them, see
// render/connections.h. Start at makeCasters().
#pragma once

#include <span>
#include <vector>

#include "tracer/compile/light_table.h"
#include "tracer/compile/mirror_points.h"
#include "tracer/materials/builder.h"
#include "tracer/math/discrete_choice.h"

namespace glint {

struct CompiledMaterial;

struct Caster {
    enum class Kind { Ball, Faces };  ///< Faces: a box, quad, disk or plane
    Kind kind = Kind::Ball;
    std::uint32_t shape = kNoShape;
    DVec3 center{0.0};
    double radius = 0;  ///< Faces: of a ball around it; infinite for planes
    double ior = 1;
    float reflects = 0;     ///< how strongly, for roulette: 1 a mirror, about 0.15 glass
    bool refracts = false;  ///< Faces: a box

    bool operator==(const Caster&) const = default;
};

/// A flat face of a caster, in render space.
struct CasterFace {
    DVec3 position{0.0}, normal{0.0, 1.0, 0.0};  ///< of some point on it; unit, outward
};
[[nodiscard]] CasterFace faceOf(const ShapeInstance& shape, int face);

/// A place on a light or a direction to it, drawn for a caster.
struct CasterTarget {
    DVec3 position{0.0};  ///< on the light; far lights: the unit direction towards it
    DVec3 normal{0.0};    ///< outward there; not for far lights
    Rgb radiance{0.0f};
    double pdf = 0;  ///< per area; far lights: per solid angle; 0: none
};

struct CasterTable {
    /// At most this many casters, the largest.
    static constexpr std::size_t kMostCasters = 32;

    std::vector<Caster> casters;
    std::vector<std::uint32_t>
        lights;              ///< indices of lights that are worth it, in LightTable::lights
    DiscreteChoice byPower;  ///< among them
    std::vector<std::uint32_t> casterOf;  ///< of each shape; ~0: none
    double farSolidAngle = 0;             ///< of the environment's bright part, sr

    [[nodiscard]] bool empty() const { return casters.empty(); }
    [[nodiscard]] const Caster* find(std::uint32_t shape) const {
        return empty() || casterOf[shape] == ~0u ? nullptr : &casters[casterOf[shape]];
    }
    /// The shape has an inside: only its outer side throws light outwards.
    [[nodiscard]] static bool isClosed(const ShapeInstance& shape) {
        return std::visit(
            [](const auto& canonical) { return std::decay_t<decltype(canonical)>::closed; },
            shape.shape);
    }
    /// A light for u in [0, 1).
    [[nodiscard]] std::uint32_t pick(double u) const { return lights[byPower.pick(u)]; }
    /// Probability of pick() to choose it; 0 for lights that are not in the list.
    [[nodiscard]] double pickProbability(std::uint32_t light) const;
};

/// Whether light comes from infinitely far.
[[nodiscard]] inline bool isFar(const CompiledLight& light) {
    return light.kind == LightKind::Sun || light.kind == LightKind::Environment;
}

/// Finds them. Empty where there is no caster or no light for one.
[[nodiscard]] CasterTable makeCasters(const std::vector<ShapeInstance>& shapes,
                                      const std::vector<CompiledMaterial>& materials,
                                      const LightTable& lights);

/// A place on `light` that the caster, a ball, may see. Uniform by area: on rectangles and disks
/// over all, on balls over the cap that some point of the caster can see. Suns and environments: as
/// sampleLight().
[[nodiscard]] CasterTarget sampleTarget(const Caster& caster, const CompiledLight& light,
                                        const LightTable& lights,
                                        const std::vector<ShapeInstance>& shapes, const DVec2& u);
/// The density with which sampleTarget() draws a place that is hit on the light, or the direction
/// `wi` to a far one.
[[nodiscard]] double targetPdf(const Caster& caster, const CompiledLight& light,
                               const LightTable& lights, const std::vector<ShapeInstance>& shapes,
                               const DVec3& wi);
/// Solid angle of the light from the caster, roughly; 0 for casters without end.
[[nodiscard]] double targetSolidAngle(const Caster& caster, const CompiledLight& light,
                                      const CasterTable& table,
                                      const std::vector<ShapeInstance>& shapes);

}  // namespace glint
