// Highlights: the blurred pictures of lights in glossy surfaces, which light what is around them as
// lamps would. Here are the surfaces and lights that make them, and directions from a place towards
// them with their density; render/highlights.h samples them. Start at makeHighlights() and
// aimAtHighlight().
#pragma once

#include <array>
#include <vector>

#include "tracer/compile/light_table.h"
#include "tracer/compile/mirror_points.h"
#include "tracer/materials/builder.h"
#include "tracer/math/discrete_choice.h"

namespace glint {

struct CompiledMaterial;

/// A surface with a narrow rough lobe.
struct GlossySurface {
    std::uint32_t shape = kNoShape;
    double alpha = 0;    ///< of its narrowest lobe
    float strength = 0;  ///< how strongly it reflects, for roulette: 1 metal, about 0.15 a coat
    DVec3 center{0.0};
    double reach = 0;  ///< radius of a ball around it; infinite for planes

    bool operator==(const GlossySurface&) const = default;
};

/// A light, or the bright part of the environment, as the ball or the cone around it.
struct HighlightLight {
    std::uint32_t light = 0;  ///< in LightTable::lights
    MirrorTarget center;
    double radius = 0;  ///< in metres; far lights: as a length on the unit sphere
};

struct HighlightTable {
    /// At most this many surfaces, the largest.
    static constexpr std::size_t kMostSurfaces = 32;

    std::vector<GlossySurface> surfaces;
    std::vector<HighlightLight> lights;    ///< in the order of LightTable::lights
    DiscreteChoice byPower;                ///< among them
    std::vector<std::uint32_t> surfaceOf;  ///< of each shape; ~0: none
    std::vector<double>
        worth;  ///< of each surface's highlights of each light, light by light; see chance()
    std::vector<double> worthOfAll;  ///< of all surfaces together, of each light

    [[nodiscard]] bool empty() const { return surfaces.empty(); }
    [[nodiscard]] const GlossySurface* find(std::uint32_t shape) const {
        return empty() || surfaceOf[shape] == ~0u ? nullptr : &surfaces[surfaceOf[shape]];
    }
    /// The light at `u` in [0, 1).
    [[nodiscard]] const HighlightLight& pick(double u) const { return lights[byPower.pick(u)]; }
    /// The entry of a light of LightTable; null if there is none.
    [[nodiscard]] const HighlightLight* findLight(std::uint32_t light) const;
    /// Probability of trying the highlight of `light` in `surface` from `from`, where the path
    /// carries `drive`: wider, fainter and farther ones bring less than their rays cost.
    [[nodiscard]] double chance(const GlossySurface& surface, const HighlightLight& light,
                                const DVec3& from, float drive) const {
        return chanceFrom(
            surface,
            static_cast<double>(drive) *
                worth[static_cast<std::size_t>(&light - lights.data()) * surfaces.size() +
                      static_cast<std::size_t>(&surface - surfaces.data())],
            from);
    }
    /// The same where it is `q` beside the surface.
    [[nodiscard]] static double chanceFrom(const GlossySurface& surface, double q,
                                           const DVec3& from) {
        constexpr double kLeast = 1e-3;
        const DVec3 apart = surface.center - from;
        const double far2 = glm::dot(apart, apart), near2 = surface.reach * surface.reach;
        if (!(far2 > near2)) return q < kLeast ? 0 : std::min(1.0, q);
        return q * near2 < kLeast * far2 ? 0 : std::min(1.0, q * near2 / far2);
    }
    /// At most the sum of all surfaces' chances.
    [[nodiscard]] double mostTries(const HighlightLight& light, float drive) const {
        return static_cast<double>(drive) *
               worthOfAll[static_cast<std::size_t>(&light - lights.data())];
    }
    /// Probability of pick() to choose it.
    [[nodiscard]] double pickProbability(const HighlightLight& light) const {
        return byPower.probability(static_cast<std::size_t>(&light - lights.data()));
    }
};

/// Empty where there is no such surface or no light for one, or where too few would be tried.
[[nodiscard]] HighlightTable makeHighlights(const std::vector<ShapeInstance>& shapes,
                                            const std::vector<CompiledMaterial>& materials,
                                            const LightTable& lights);

/// A place on a glossy surface near the picture of a light in it.
struct HighlightAim {
    DVec3 point{0.0};
    int face = 0;
    double pdf = 0;  ///< per solid angle at the eye
};
inline constexpr std::size_t kMaxAims = 6;
/// Places where the surface mirrors a point near the light, drawn by `u`, to the eye. What lies in
/// between is not looked at.
[[nodiscard]] int aimAtHighlight(const GlossySurface& surface, const HighlightLight& light,
                                 const ShapeInstance& shape, const DVec3& eye, const DVec2& u,
                                 std::array<HighlightAim, kMaxAims>& out);
/// The density with which aimAtHighlight() finds the point `p` of the face; 0 where it does not.
[[nodiscard]] double highlightPdf(const GlossySurface& surface, const HighlightLight& light,
                                  const ShapeInstance& shape, const DVec3& eye, const DVec3& p,
                                  int face);

}  // namespace glint
