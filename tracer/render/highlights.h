// Next-event estimation by way of glossy surfaces: from a smooth surface towards the blurred
// picture of a light in a surface with a narrow lobe, and from there to that light. Paths that
// follow the smooth surface's own directions find these bright spots by luck only. Both ways share
// the step from the smooth surface to the glossy one by multiple importance sampling; what that one
// sends back of the light is estimated anew by either. Source: next-event estimation with the
// light's picture in the place of the light (cf. Hanika, Droske, Fascione, "Manifold Next Event
// Estimation", CGF 34(4), 2015, sec. 4, for perfect surfaces). Only outside all media, and for
// surfaces of compile/highlights.h.
#pragma once

#include "tracer/render/scattering.h"

namespace glint {

/// A path's step from a smooth surface straight to a glossy one, which a highlight could have
/// drawn.
struct HighlightStep {
    const GlossySurface* surface = nullptr;  ///< null: it could not
    DVec3 from{0.0}, at{0.0};
    int face = 0;
    double pdf = 0;   ///< per solid angle, with which the surface at `from` drew it
    float drive = 0;  ///< see highlightDrive()
};

/// What roulette on highlights goes by: the throughput at a surface times what its broad lobes send
/// on. Measured on rooms and fields of tori (`glint-bench choices --only highlights`).
[[nodiscard]] inline float highlightDrive(const Rgb& throughput, const CompiledMaterial& material) {
    return 0.5f * maxComponent(throughput) * material.broadAlbedo;
}

/// The density per solid angle with which a highlight of `light` would have drawn the step.
[[nodiscard]] inline double highlightDensity(const RenderScene& scene, const HighlightStep& step,
                                             std::uint32_t light) {
    const HighlightLight* entry = scene.highlights.findLight(light);
    if (!entry) return 0;
    const double chance = scene.highlights.chance(*step.surface, *entry, step.from, step.drive);
    if (!(chance > 0)) return 0;
    return chance * scene.highlights.pickProbability(*entry) *
           highlightPdf(*step.surface, *entry, scene.shapes[step.surface->shape], step.from,
                        step.at, step.face);
}

/// After so many surfaces tried at one place the sampler's numbers repeat.
inline constexpr std::uint32_t kHighlightNumbers = 8;

/// Where next-event estimation by highlights starts.
struct HighlightVertex {
    DVec3 position{0.0};
    std::uint32_t shape = kNoShape;
    float drive = 0;
    float number = 0;  ///< for roulette, in [0, 1)
    int depth = 0;
    std::uint32_t branch = 0;
};

/// Draws highlights, at most one in each glossy surface, and calls take(surface, its number among
/// those tried, light, aim, density), where `density` is that of highlightDensity(). The surfaces'
/// chances lie one after the other on a line; those are tried that the teeth of a comb of width 1
/// fall on, so that their number varies little.
template <class Take>
void drawHighlights(const RenderScene& scene, const Sampler& sampler, const HighlightVertex& vertex,
                    WorkCounts& work, const Take& take) {
    const HighlightTable& table = scene.highlights;
    const bool one = table.lights.size() == 1;
    const HighlightLight& light = table.pick(
        one ? 0.0
            : static_cast<double>(
                  sampler.block(sampleBlock(SampleUse::Caustic, vertex.depth, vertex.branch, 32))
                      .x));
    auto tooth = static_cast<double>(vertex.number);
    if (table.mostTries(light, vertex.drive) <= tooth) return;  // No tooth falls on any.
    std::uint32_t tried = 0;
    for (const GlossySurface& surface : table.surfaces) {
        if (surface.shape == vertex.shape) continue;
        const double chance = table.chance(surface, light, vertex.position, vertex.drive);
        tooth -= chance;
        if (tooth >= 0) continue;
        tooth += 1;
        ++work[Work::Highlights];
        const std::uint32_t number = tried++ % kHighlightNumbers;
        const SampleBlock u = sampler.block(
            sampleBlock(SampleUse::Caustic, vertex.depth, vertex.branch, 33 + number));
        std::array<HighlightAim, kMaxAims> aims;
        const int count = aimAtHighlight(surface, light, scene.shapes[surface.shape],
                                         vertex.position, {u.x, u.y}, aims);
        for (const HighlightAim& aim : std::span(aims.data(), static_cast<std::size_t>(count)))
            if (const double density = chance * table.pickProbability(light) * aim.pdf;
                density > 0 && density < kInfinity)
                take(surface, number, light.light, aim, density);
    }
}

}  // namespace glint
