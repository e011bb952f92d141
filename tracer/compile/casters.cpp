#include "tracer/compile/casters.h"

#include <algorithm>

#include "tracer/compile/quad_light.h"
#include "tracer/compile/render_scene.h"

namespace glint {

namespace {

/// Environments whose light is spread over more than this [sr] make no caustics worth a ray.
constexpr double kWidestSky = 1;

/// What the delta leaves alone of a material do at 45 degrees to light that comes through vacuum;
/// nothing if it has other leaves.
struct Deltas {
    float reflectance = 0;
    bool refracts = false;
};
Deltas deltasOf(const CompiledMaterial& material) {
    const Vec3 wo(std::sqrt(0.5f), 0, std::sqrt(0.5f));
    Deltas out;
    for (const WeightedLeaf& weighted : material.leaves)
        std::visit(
            [&]<class Leaf>(const Leaf& leaf) {
                if constexpr (Leaf::kDelta) {
                    DeltaBranch found[kMaxBranches];
                    const int count = leaf.branches(wo, 1 / material.medium.ior, found);
                    for (int i = 0; i < count; ++i) {
                        if (sameSide(wo, found[i].wi))
                            out.reflectance += maxComponent(weighted.weight * found[i].weight);
                        else if (!found[i].straight)
                            out.refracts = true;
                    }
                }
            },
            weighted.leaf);
    return out;
}

/// Another dielectric reaches into this one. What only touches shares nothing.
bool isShared(const std::vector<ShapeInstance>& shapes, std::uint32_t one) {
    constexpr double kTouch = 1e-6;
    const DVec3 half = shapes[one].halfSize();
    for (std::uint32_t i = 0; i < shapes.size(); ++i) {
        if (i == one || !shapes[i].dielectric) continue;
        if (std::holds_alternative<CanonicalPlane>(shapes[i].shape)) return true;
        const DVec3 apart = absolute(shapes[i].center - shapes[one].center) - shapes[i].halfSize();
        if (maxComponent(apart - (1 - kTouch) * half) < 0) return true;
    }
    return false;
}

/// A dielectric plane is left alone: it fills half of space.
bool isFlat(const ShapeInstance& shape) {
    return std::holds_alternative<CanonicalBox>(shape.shape) ||
           std::holds_alternative<CanonicalQuad>(shape.shape) ||
           std::holds_alternative<CanonicalDisk>(shape.shape) ||
           (std::holds_alternative<CanonicalPlane>(shape.shape) && !shape.dielectric);
}
double reachOf(const ShapeInstance& shape) {
    const DMat3& m = shape.worldFromLocal;
    if (std::holds_alternative<CanonicalPlane>(shape.shape)) return kInfinity;
    const double flat = glm::dot(m[0], m[0]) + glm::dot(m[2], m[2]);
    return std::sqrt(std::holds_alternative<CanonicalBox>(shape.shape) ? flat + glm::dot(m[1], m[1])
                                                                       : flat);
}

bool isTarget(const CompiledLight& light, const std::vector<ShapeInstance>& shapes,
              const std::vector<CompiledMaterial>& materials, double farSolidAngle) {
    switch (light.kind) {
        case LightKind::Point:
        case LightKind::Spot:
            return false;
        case LightKind::Sun:
            return !light.isDelta();
        case LightKind::Environment:
            return farSolidAngle < kWidestSky;
        case LightKind::Area:
            break;
    }
    const ShapeInstance& shape = shapes[light.shape];
    if (!isBlack(materials[shape.material].straight) || shape.dielectric) return false;
    return ballRadius(shape) > 0 || std::holds_alternative<CanonicalQuad>(shape.shape) ||
           std::holds_alternative<CanonicalDisk>(shape.shape);
}

/// 1 - cos of the half angle, at the lamp's centre, of the cap that the caster can see; 0: too
/// near.
double capHeight(const Caster& caster, const ShapeInstance& lamp, double radius) {
    const double distance = glm::length(lamp.center - caster.center);
    return distance > radius + caster.radius ? 1 - (radius - caster.radius) / distance : 0;
}

}  // namespace

CasterFace faceOf(const ShapeInstance& shape, int face) {
    const bool box = std::holds_alternative<CanonicalBox>(shape.shape);
    DVec3 local(0.0);
    local[box ? face / 2 : 1] = box && face % 2 == 0 ? -1 : 1;
    return {box ? shape.center + shape.worldFromLocal * local : shape.center,
            glm::normalize(local * shape.localFromWorld)};  // (M^-1)^T n
}

double CasterTable::pickProbability(std::uint32_t light) const {
    const auto it = std::lower_bound(lights.begin(), lights.end(), light);
    if (it == lights.end() || *it != light) return 0;
    return byPower.probability(static_cast<std::size_t>(it - lights.begin()));
}

CasterTable makeCasters(const std::vector<ShapeInstance>& shapes,
                        const std::vector<CompiledMaterial>& materials, const LightTable& lights) {
    CasterTable out;
    if (lights.environment.map) out.farSolidAngle = lights.environment.map->brightSolidAngle();
    std::vector<double> powers;
    for (std::uint32_t i = 0; i < lights.lights.size(); ++i) {
        const CompiledLight& light = lights.lights[i];
        if (!(light.power > 0) || !isTarget(light, shapes, materials, out.farSolidAngle)) continue;
        out.lights.push_back(i);
        powers.push_back(light.power);
    }
    if (out.lights.empty()) return {};
    out.byPower = DiscreteChoice(powers);
    for (std::uint32_t i = 0; i < shapes.size(); ++i) {
        const bool flat = isFlat(shapes[i]);
        const double radius = flat ? reachOf(shapes[i]) : ballRadius(shapes[i]);
        if (!(radius > 0)) continue;
        const CompiledMaterial& material = materials[shapes[i].material];
        const Deltas deltas = deltasOf(material);
        const bool refracts = shapes[i].dielectric && deltas.refracts && material.medium.ior > 1 &&
                              !std::holds_alternative<CanonicalPlane>(shapes[i].shape);
        if ((deltas.reflectance > 0 || refracts) && !(shapes[i].dielectric && isShared(shapes, i)))
            out.casters.push_back({flat ? Caster::Kind::Faces : Caster::Kind::Ball, i,
                                   shapes[i].center, radius,
                                   static_cast<double>(material.medium.ior),
                                   std::min(1.0f, 3 * deltas.reflectance), refracts});
    }
    if (out.casters.empty()) return {};
    std::stable_sort(out.casters.begin(), out.casters.end(),
                     [](const Caster& a, const Caster& b) { return a.radius > b.radius; });
    if (out.casters.size() > CasterTable::kMostCasters)
        out.casters.resize(CasterTable::kMostCasters);
    out.casterOf.assign(shapes.size(), ~0u);
    for (std::uint32_t i = 0; i < out.casters.size(); ++i) out.casterOf[out.casters[i].shape] = i;
    return out;
}

CasterTarget sampleTarget(const Caster& caster, const CompiledLight& light,
                          const LightTable& lights, const std::vector<ShapeInstance>& shapes,
                          const DVec2& u) {
    if (light.kind == LightKind::Environment) {
        const EnvironmentSample s = lights.environment.map->sample(Vec2(u));
        return {lights.environment.worldFromMap(s.direction), DVec3(0.0),
                lights.environment.scale * s.radiance, s.pdf};
    }
    if (light.kind == LightKind::Sun) {
        const DirectionSample s = uniformCone(light.direction, light.sin2Angle, u);
        return {s.direction, DVec3(0.0), light.emission, s.pdf};
    }
    const ShapeInstance& shape = shapes[light.shape];
    CasterTarget out{shape.center, DVec3(0.0), light.emission,
                     targetPdf(caster, light, lights, shapes, DVec3(0.0))};
    if (!(out.pdf > 0)) return {};
    if (const double radius = ballRadius(shape); radius > 0) {
        const double down = u.x * capHeight(caster, shape, radius),
                     across = std::sqrt(std::max(0.0, down * (2 - down)));
        out.normal = Frame(glm::normalize(caster.center - shape.center))
                         .toWorld(DVec3(across * cosSinTurn(u.y), 1 - down));
        out.position += radius * out.normal;
        return out;
    }
    const DVec2 place =
        std::holds_alternative<CanonicalQuad>(shape.shape) ? 2.0 * u - 1.0 : concentricDisk(u);
    out.normal = glm::normalize(DVec3(0, 1, 0) * shape.localFromWorld);  // (M^-1)^T n
    out.position += place.x * shape.worldFromLocal[0] + place.y * shape.worldFromLocal[2];
    return out;
}

double targetPdf(const Caster& caster, const CompiledLight& light, const LightTable& lights,
                 const std::vector<ShapeInstance>& shapes, const DVec3& wi) {
    if (light.kind == LightKind::Environment)
        return lights.environment.map->pdf(lights.environment.mapFromWorld(wi));
    if (light.kind == LightKind::Sun) return 1 / coneSolidAngle(light.sin2Angle);
    const ShapeInstance& shape = shapes[light.shape];
    if (const double radius = ballRadius(shape); radius > 0) {
        const double height = capHeight(caster, shape, radius);
        return height > 0 ? 1 / (2 * kPi * radius * radius * height) : 0;
    }
    return 1 / flatArea(shape);
}

double targetSolidAngle(const Caster& caster, const CompiledLight& light, const CasterTable& table,
                        const std::vector<ShapeInstance>& shapes) {
    if (light.kind == LightKind::Environment) return table.farSolidAngle;
    if (light.kind == LightKind::Sun) return coneSolidAngle(light.sin2Angle);
    if (caster.radius == kInfinity) return 0;
    const ShapeInstance& shape = shapes[light.shape];
    const DVec3 apart = shape.center - caster.center;
    const double radius = ballRadius(shape),
                 area = radius > 0 ? kPi * radius * radius : flatArea(shape);
    return area / glm::dot(apart, apart);
}

}  // namespace glint
