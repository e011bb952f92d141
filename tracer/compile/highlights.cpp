#include "tracer/compile/highlights.h"

#include <algorithm>
#include <numeric>

#include "tracer/compile/render_scene.h"
#include "tracer/math/chord_lobe.h"

namespace glint {

namespace {

/// Environments whose light is spread over more than this [sr] are found well enough by the
/// surfaces' own directions.
constexpr double kWidestSky = 1;

/// Of the narrowest lobe worth it, strength 0 if there is none.
Gloss glossOf(const CompiledMaterial& material) {
    Gloss out{Gloss::kWidest, 0};
    for (const WeightedLeaf& weighted : material.leaves)
        std::visit(
            [&]<class Leaf>(const Leaf& leaf) {
                if constexpr (requires { leaf.gloss(); })
                    if (const Gloss gloss = leaf.gloss(); gloss.alpha <= out.alpha)
                        out = {gloss.alpha, gloss.strength * maxComponent(weighted.weight)};
            },
            weighted.leaf);
    return out;
}

/// The ball or the cone around a light. False: its light does not come from about one place.
bool describe(const CompiledLight& light, const LightTable& lights,
              const std::vector<ShapeInstance>& shapes, HighlightLight& out) {
    switch (light.kind) {
        case LightKind::Point:
        case LightKind::Spot:
            out.center = {light.position, false};
            return true;
        case LightKind::Sun:
            out.center = {light.direction, true};
            out.radius = std::sqrt(light.sin2Angle);
            return true;
        case LightKind::Area:
            out.center = {shapes[light.shape].center, false};
            out.radius = maxComponent(shapes[light.shape].halfSize());
            return true;
        case LightKind::Environment:
            break;
    }
    const EnvironmentMap& map = *lights.environment.map;
    if (!(map.brightSolidAngle() < kWidestSky)) return false;
    const DVec3 mean = map.brightDirection();
    const double length = glm::length(mean);
    constexpr double kOnePlace = 0.5;  // Two suns on opposite sides have the mean 0.
    if (!(length > kOnePlace)) return false;
    out.center = {lights.environment.worldFromMap(mean / length), true};
    out.radius = std::sqrt(std::max(0.0, 2 - 2 * length));  // Root mean square of the distances.
    return true;
}

/// Of lobes around the mirrored light.
double width2(double alpha, double radius) { return 4 * alpha * alpha + radius * radius; }

/// Of the highlight about the mirrored light, roughly [sr].
double highlightSolidAngle(const GlossySurface& surface, const HighlightLight& light) {
    double radius = light.radius;
    if (!light.center.far)
        radius = surface.reach < kInfinity
                     ? radius / glm::length(light.center.place - surface.center)
                     : 0;
    return kPi * width2(surface.alpha, radius);
}
/// Wider highlights are found well enough by the surfaces' own directions [sr].
constexpr double kSharp = 0.03;

/// Highlights tried at a shape, in the mean over shapes (up to 64 of them), by a path that carries
/// half of the camera's light.
double usualTries(const HighlightTable& table, const std::vector<ShapeInstance>& shapes) {
    std::vector<double> worth(table.surfaces.size());  // In the mean over lights.
    for (std::size_t i = 0; i < table.worth.size(); ++i)
        worth[i % worth.size()] += table.byPower.probability(i / worth.size()) * table.worth[i];
    constexpr std::size_t kShapes = 64;
    const std::size_t stride = (shapes.size() + kShapes - 1) / kShapes;
    double tries = 0;
    int places = 0;
    for (std::size_t i = 0; i < shapes.size(); i += stride, ++places)
        for (std::size_t s = 0; s < worth.size(); ++s)
            if (table.surfaces[s].shape != i)
                tries +=
                    HighlightTable::chanceFrom(table.surfaces[s], 0.5 * worth[s], shapes[i].center);
    return tries / places;
}
/// Where fewer are tried, asking for them costs 4 to 11 % of the time and brings less; where more
/// are, they bring up to 48 % of it.
constexpr double kLeastTries = 0.01;

/// Eye and light as a flat face sees them: from the eye mirrored in it, the light's lobe.
struct FlatView {
    DVec3 normal{0.0}, mirrored{0.0};
    double height = 0;  ///< of the eye, with a sign
    ChordLobe lobe{DVec3(0, 0, 1), 1};
    bool valid = false;

    FlatView(const GlossySurface& surface, const HighlightLight& light, const ShapeInstance& shape,
             const DVec3& eye, int face) {
        bool closed = false;
        std::visit(
            [&](const auto& s) {
                closed = s.closed;
                const DVec3 local = s.project(DVec3(0.0), face);
                normal =
                    glm::normalize(s.normal(local, face) * shape.localFromWorld);  // (M^-1)^T n
                height = glm::dot(eye - (shape.center + shape.worldFromLocal * local), normal);
            },
            shape.shape);
        if (isOn(height, eye, shape.center) || (height < 0 && closed)) return;
        mirrored = eye - 2 * height * normal;
        if (light.center.far) {
            lobe = ChordLobe(light.center.place, width2(surface.alpha, light.radius));
        } else {
            const DVec3 to = light.center.place - mirrored;
            const double distance = glm::length(to),
                         above = glm::dot(to, normal) - height;  // of the light over the face
            if (!(above * height > 0)) return;
            // A turn at the face is a smaller one at the mirrored eye.
            lobe = ChordLobe(to / distance, width2(surface.alpha * above / (above + height),
                                                   light.radius / distance));
        }
        valid = true;
    }
};

/// What is mirrored in a curved face: a direction, or for near lights a place on the ball about the
/// shape that the light lies on.
struct CurvedView {
    double distance = 1;
    ChordLobe lobe{DVec3(0, 0, 1), 1};
    bool valid = false;

    CurvedView(const GlossySurface& surface, const HighlightLight& light,
               const ShapeInstance& shape) {
        const DVec3 to = light.center.far ? light.center.place : light.center.place - shape.center;
        distance = light.center.far ? 1 : glm::length(to);
        if (!light.center.far && !(distance > surface.reach)) return;
        lobe = ChordLobe(to / distance, width2(surface.alpha, light.radius / distance));
        valid = true;
    }
};

/// Density per solid angle at the eye with which a curved face mirrors a draw from `view` at `p`.
double curvedPdf(const CurvedView& view, bool far, const ShapeInstance& shape, int face,
                 const DVec3& eye, const DVec3& p, MirrorTarget& target) {
    const Reflected ray = reflectAt(shape, face, eye, p);
    if (far) {
        target = {ray.direction, true};
        return view.lobe.pdf(ray.direction) * ray.spread;
    }
    // On to the ball about the shape, from inside.
    const DVec3 from = p - shape.center;
    const double along = glm::dot(from, ray.direction);
    const double length = -along + std::sqrt(std::max(0.0, along * along - glm::dot(from, from) +
                                                               view.distance * view.distance));
    const DVec3 radial = (from + length * ray.direction) / view.distance;
    target = {shape.center + view.distance * radial, false};
    return view.lobe.pdf(radial) * ray.areaAt(length) /
           (view.distance * view.distance * glm::dot(radial, ray.direction));
}

}  // namespace

const HighlightLight* HighlightTable::findLight(std::uint32_t light) const {
    const auto it =
        std::lower_bound(lights.begin(), lights.end(), light,
                         [](const HighlightLight& a, std::uint32_t b) { return a.light < b; });
    return it != lights.end() && it->light == light ? &*it : nullptr;
}

HighlightTable makeHighlights(const std::vector<ShapeInstance>& shapes,
                              const std::vector<CompiledMaterial>& materials,
                              const LightTable& lights) {
    HighlightTable out;
    std::vector<double> powers;
    double allPower = 0;
    for (const CompiledLight& light : lights.lights) allPower += light.power;
    for (std::uint32_t i = 0; i < lights.lights.size(); ++i) {
        HighlightLight entry{i};
        if (!(lights.lights[i].power > 0) || !describe(lights.lights[i], lights, shapes, entry))
            continue;
        out.lights.push_back(entry);
        powers.push_back(lights.lights[i].power);
    }
    if (out.lights.empty()) return {};
    out.byPower = DiscreteChoice(powers);
    for (std::uint32_t i = 0; i < shapes.size(); ++i) {
        if (shapes[i].dielectric) continue;
        const Gloss gloss = glossOf(materials[shapes[i].material]);
        if (!(gloss.strength > 0)) continue;
        // Points of tori take long to find. Efficiency to that of 1: 1.6 torus_field, 0.85 to 1.05
        // columns; with a twelfth 1.9 and 0.7 to 0.9, for where a sun shines on them the light that
        // is not looked for makes bright specks.
        const float ease =
            std::holds_alternative<CanonicalTorus>(shapes[i].shape) ? 1.0f / 3 : 1.0f;
        out.surfaces.push_back({i, gloss.alpha, ease * gloss.strength, shapes[i].center,
                                glm::length(shapes[i].halfSize())});
    }
    if (out.surfaces.empty()) return {};
    std::stable_sort(
        out.surfaces.begin(), out.surfaces.end(),
        [](const GlossySurface& a, const GlossySurface& b) { return a.reach > b.reach; });
    if (out.surfaces.size() > HighlightTable::kMostSurfaces)
        out.surfaces.resize(HighlightTable::kMostSurfaces);
    out.surfaceOf.assign(shapes.size(), ~0u);
    for (std::uint32_t i = 0; i < out.surfaces.size(); ++i)
        out.surfaceOf[out.surfaces[i].shape] = i;
    for (const HighlightLight& light : out.lights) {
        // One of many lights makes few of the bright spots, and one light is looked for at a time.
        const double share = std::min(1.0, 2 * lights.lights[light.light].power / allPower);
        for (const GlossySurface& surface : out.surfaces)
            out.worth.push_back(share * static_cast<double>(surface.strength) *
                                std::min(1.0, kSharp / highlightSolidAngle(surface, light)));
        out.worthOfAll.push_back(
            std::accumulate(out.worth.end() - static_cast<std::ptrdiff_t>(out.surfaces.size()),
                            out.worth.end(), 0.0));
    }
    if (usualTries(out, shapes) < kLeastTries) return {};
    return out;
}

int aimAtHighlight(const GlossySurface& surface, const HighlightLight& light,
                   const ShapeInstance& shape, const DVec3& eye, const DVec2& u,
                   std::array<HighlightAim, kMaxAims>& out) {
    int count = 0;
    const CurvedView curved(surface, light, shape);
    for (int face = 0; face < faceCount(shape); ++face) {
        if (isFlat(shape, face)) {
            const FlatView view(surface, light, shape, eye, face);
            if (!view.valid) continue;
            const DirectionSample s = view.lobe.sample(u);
            const double across = glm::dot(s.direction, view.normal);
            if (across * view.height > 0)
                out[static_cast<std::size_t>(count++)] = {
                    view.mirrored + view.height / across * s.direction, face, s.pdf};
            continue;
        }
        if (!curved.valid) continue;
        const DVec3 direction = curved.lobe.sample(u).direction;
        const MirrorTarget target{
            light.center.far ? direction : shape.center + curved.distance * direction,
            light.center.far};
        std::array<DVec3, kMaxMirrorPoints> points;
        const int found = findMirrorPoints(shape, face, eye, target, points);
        for (int i = 0; i < found && count < static_cast<int>(kMaxAims); ++i) {
            MirrorTarget again;
            const DVec3& p = points[static_cast<std::size_t>(i)];
            out[static_cast<std::size_t>(count++)] = {
                p, face, curvedPdf(curved, target.far, shape, face, eye, p, again)};
        }
    }
    return count;
}

double highlightPdf(const GlossySurface& surface, const HighlightLight& light,
                    const ShapeInstance& shape, const DVec3& eye, const DVec3& p, int face) {
    if (isFlat(shape, face)) {
        const FlatView view(surface, light, shape, eye, face);
        return view.valid ? view.lobe.pdf(glm::normalize(p - view.mirrored)) : 0;
    }
    const CurvedView view(surface, light, shape);
    if (!view.valid) return 0;
    MirrorTarget target;
    const double pdf = curvedPdf(view, light.center.far, shape, face, eye, p, target);
    // Only what the search finds can be found.
    std::array<DVec3, kMaxMirrorPoints> points;
    const int found = findMirrorPoints(shape, face, eye, target, points);
    constexpr double kSame = 1e-6;  // local
    const auto isHere = [&](const DVec3& q) {
        return glm::length(shape.localVector(p - q)) < kSame;
    };
    return std::any_of(points.begin(), points.begin() + found, isHere) ? pdf : 0;
}

}  // namespace glint
