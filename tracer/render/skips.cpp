#include "tracer/render/skips.h"

#include <algorithm>

#include "tracer/compile/render_scene.h"

namespace glint {

namespace {

template <Feature kFeature>
bool lacks(const RenderScene& scene) {
    return !has(scene.features, kFeature);
}

bool hasNoFilter(const RenderScene& scene) { return scene.lists->blockCounts().total() == 0; }

bool absorbsNothing(const RenderScene& scene) {
    return std::ranges::none_of(scene.shapes, [&](const ShapeInstance& shape) {
        return shape.dielectric && !isBlack(scene.materials[shape.material].medium.absorption);
    });
}

constexpr Skip kSkips[] = {
    {"no shapes: no lists", Work::ShapeTests,
     [](const RenderScene& s) { return s.shapes.empty(); }},
    {"no shapes: no balls", Work::BallTests, [](const RenderScene& s) { return s.shapes.empty(); }},
    {"few shapes: no hierarchy", Work::NodeVisits,
     [](const RenderScene& s) { return !s.lists->hasHierarchy(); }},
    {"no balls to filter", Work::BallBlocks,
     [](const RenderScene& s) { return hasNoFilter(s) || s.lists->blockCounts().balls == 0; }},
    {"only balls to filter: no boxes", Work::BoxBlocks,
     [](const RenderScene& s) { return hasNoFilter(s) || s.lists->blockCounts().boxes == 0; }},
    {"no turned shapes: no matrices", Work::MatrixTests,
     [](const RenderScene& s) { return !s.lists->hasMatrices(); }},
    {"no sky: lost rays end at nothing", Work::SkyLookups, lacks<Feature::Sky>},
    {"no environment picture: no look-ups", Work::MapLookups,
     [](const RenderScene& s) { return s.lights.environment.map == nullptr; }},
    {"no emissive shapes: hits are not asked for light", Work::EmissionTests,
     lacks<Feature::AreaLights>},
    {"no lights: no light samples", Work::LightSamples,
     [](const RenderScene& s) { return s.lights.empty(); }},
    {"no smooth surfaces: no light samples", Work::LightSamples,
     [](const RenderScene& s) {
         return s.settings.integrator == Integrator::Path && lacks<Feature::Smooth>(s);
     }},
    {"one light: no choice", Work::LightChoices,
     [](const RenderScene& s) { return s.lights.lights.size() <= 1; }},
    {"only point-like lights: no shared weights", Work::MisWeights,
     [](const RenderScene& s) {
         return lacks<Feature::AreaLights>(s) && lacks<Feature::SampledSky>(s);
     }},
    {"light that cannot count: no shadow ray", Work::BlackShadowRays,
     [](const RenderScene&) { return true; }},
    {"opaque surfaces: shadow rays end at any hit", Work::ShadowSteps,
     [](const RenderScene& s) {
         return s.clearShadows || (lacks<Feature::Straight>(s) && !s.settings.transparentShadows);
     }},
    {"no media: none tracked", Work::MediaSteps, lacks<Feature::Media>},
    {"clear media: no exponentials", Work::Exponentials, absorbsNothing},
    {"no rough surfaces: no lobes", Work::RoughLobes, lacks<Feature::Rough>},
    {"no delta surfaces: no branches", Work::DeltaLists,
     [](const RenderScene& s) {
         return s.settings.integrator == Integrator::Path && lacks<Feature::Delta>(s);
     }},
    {"one bounce: no roulette", Work::Roulettes,
     [](const RenderScene& s) { return s.settings.maxDepth <= 1; }},
    {"pinhole: no lens samples", Work::LensSamples, lacks<Feature::Lens>},
    {"no perfect balls under small lights: no connections", Work::Connections,
     lacks<Feature::Casters>},
    {"no glossy surfaces under small lights: no highlights", Work::Highlights,
     lacks<Feature::Highlights>},
};

}  // namespace

std::span<const Skip> allSkips() { return kSkips; }

std::vector<std::string> skipNames(const RenderScene& scene) {
    std::vector<std::string> names;
    for (const Skip& skip : kSkips)
        if (skip.holds(scene)) names.emplace_back(skip.name);
    return names;
}

}  // namespace glint
