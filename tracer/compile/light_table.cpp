#include "tracer/compile/light_table.h"

#include <algorithm>

namespace glint {

namespace {

/// A ray that starts on the ball meets it again only on its way through. The density is that of
/// sphereDirectionPdf() at the same place, whichever side of the surface rounding has put it on.
LightSample sampleBall(const CompiledLight& light, const ShapeInstance& ball, const Ray& from,
                       const DVec2& u) {
    const DVec3 toCenter = ball.center - from.origin;
    const double r2 = light.radius * light.radius;
    const bool onIt = from.fromShape == light.shape,
               inside = onIt || glm::dot(toCenter, toCenter) <= r2;
    if (inside && !light.twoSided) return {};
    const DirectionSample s = sampleSphereDirection(toCenter, light.radius, u);
    const double along = glm::dot(toCenter, s.direction);
    const DVec3 across = toCenter - along * s.direction;
    const double half = std::sqrt(std::max(0.0, r2 - glm::dot(across, across)));
    const double distance = onIt ? 2 * along : inside ? along + half : along - half;
    if (!(distance > 0)) return {};
    return {s.direction, distance, light.emission, s.pdf, light.shape};
}

LightSample sampleRectangle(const CompiledLight& light, const Ray& from, const DVec2& u) {
    if (from.fromShape == light.shape) return {};
    const QuadLight quad(*light.rectangle, from.origin);
    if (!light.twoSided && !quad.seenFromFront()) return {};
    const QuadLight::Sample s = quad.sample(u);
    if (!(s.pdf > 0)) return {};
    return {s.direction, s.distance, light.emission, s.pdf, light.shape};
}

/// What comes along a ray that was drawn with density `pdf` from the first face of a lamp that it
/// meets.
LightSample meet(const CompiledLight& light, const ShapeInstance& shape, const Ray& ray,
                 const MediaStack& media, double pdf) {
    const Crossing hit = hitShape(shape, light.shape, ray, media);
    if (!hit.found()) return {};
    if (!light.twoSided) {
        const DVec3 localOrigin = shape.localPoint(ray.origin);
        const DVec3 localDirection = shape.localVector(ray.direction);
        const bool fromOutside = std::visit(
            [&](const auto& canonical) {
                const DVec3 p = canonical.project(localOrigin + hit.t * localDirection, hit.face);
                return glm::dot(canonical.normal(p, hit.face), localDirection) < 0;
            },
            shape.shape);
        if (!fromOutside) return {};
    }
    return {ray.direction, hit.t, light.emission, pdf, light.shape};
}

/// Any shape, by its own sampling.
LightSample sampleArea(const CompiledLight& light, const ShapeInstance& shape, const Ray& from,
                       const MediaStack& media, const DVec2& u) {
    const DVec3 localOrigin = shape.localPoint(from.origin);
    const Viewpoint view(localOrigin, shape.worldFromLocal);
    const DirectionSample s = std::visit(
        [&](const auto& canonical) { return canonical.sampleDirection(view, u); }, shape.shape);
    if (!(s.pdf > 0)) return {};
    Ray ray = from;
    ray.direction = glm::normalize(shape.worldFromLocal * s.direction);
    return meet(light, shape, ray, media, s.pdf);
}

/// Wider than the spot by what its cosines in float and the sums of angles may be wrong.
LightAim aimOfSpot(const CompiledLight& spot) {
    constexpr double kMargin = 1e-6;
    const double inner = std::acos(static_cast<double>(spot.cosInner)),
                 outer = std::acos(static_cast<double>(spot.cosOuter));
    return {spot.direction, inner, std::cos(outer - inner) - kMargin};
}

/// Where a light is, and about what irradiance it gives at 1 m, or at any distance if it is
/// infinitely far.
LightBounds boundsOf(const CompiledLight& light, const CompiledEnvironment& environment,
                     const std::vector<ShapeInstance>& shapes) {
    const double emission = static_cast<double>(luminance(light.emission));
    switch (light.kind) {
        case LightKind::Point:
            return {light.position, 0, luminance(light.intensity)};
        case LightKind::Spot:
            return {light.position, 0, luminance(light.intensity), aimOfSpot(light)};
        case LightKind::Sun:
            return {DVec3(0.0), kInfinity,
                    light.isDelta() ? emission : emission * kPi * light.sin2Angle,
                    LightAim(-light.direction, std::asin(std::sqrt(std::min(1.0, light.sin2Angle))),
                             0)};
        case LightKind::Environment:
            return {DVec3(0.0), kInfinity,
                    kPi * static_cast<double>(
                              luminance(environment.scale * environment.map->meanRadiance()))};
        case LightKind::Area:
            break;
    }
    const ShapeInstance& shape = shapes[light.shape];
    const DMat3& m = shape.worldFromLocal;
    if (const double area = flatArea(shape); area > 0 && !light.twoSided) {
        const DVec3 normal = glm::normalize(DVec3(0, 1, 0) * shape.localFromWorld);  // (M^-1)^T n
        return {shape.center, std::sqrt(glm::dot(m[0], m[0]) + glm::dot(m[2], m[2])),
                emission * area, LightAim(normal, 0, 0)};
    }
    const double reach =
        std::sqrt(glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]));
    return {shape.center, light.radius > 0 ? light.radius : reach, light.power / 4};
}

}  // namespace

float spotShare(const CompiledLight& spot, const DVec3& wi) {
    const float cosine = static_cast<float>(-glm::dot(wi, spot.direction));
    if (cosine <= spot.cosOuter) return 0;
    if (cosine >= spot.cosInner) return 1;
    const float x = (cosine - spot.cosOuter) / (spot.cosInner - spot.cosOuter);
    return x * x * (3 - 2 * x);
}

double ballRadius(const ShapeInstance& shape) {
    if (!std::holds_alternative<CanonicalSphere>(shape.shape)) return 0;
    const DMat3& m = shape.worldFromLocal;
    const double r2 = glm::dot(m[0], m[0]);
    const auto near = [r2](double x, double y) { return std::abs(x - y) <= 4e-16 * r2; };
    const bool isBall = near(glm::dot(m[1], m[1]), r2) && near(glm::dot(m[2], m[2]), r2) &&
                        near(glm::dot(m[0], m[1]), 0) && near(glm::dot(m[0], m[2]), 0) &&
                        near(glm::dot(m[1], m[2]), 0);
    return isBall ? std::sqrt(r2) : 0;
}

void LightTable::finish(const std::vector<ShapeInstance>& shapes) {
    std::vector<LightBounds> bounds;
    bounds.reserve(lights.size());
    for (CompiledLight& light : lights) {
        if (light.kind == LightKind::Area) {
            const ShapeInstance& shape = shapes[light.shape];
            light.radius = shape.dielectric ? 0 : ballRadius(shape);
            if (isRectangle(shape)) light.rectangle.emplace(shape);
        }
        bounds.push_back(boundsOf(light, environment, shapes));
    }
    choice = LightChoice(std::move(bounds));
}

LightSample sampleLight(const LightTable& lights, const std::vector<ShapeInstance>& shapes,
                        std::uint32_t index, const Ray& from, const MediaStack& media,
                        const DVec2& u) {
    const CompiledLight& light = lights.lights[index];
    switch (light.kind) {
        case LightKind::Point:
        case LightKind::Spot:
            return sampleDelta(light, from.origin);
        case LightKind::Sun: {
            if (light.isDelta()) return sampleDelta(light, from.origin);
            const DirectionSample s = uniformCone(light.direction, light.sin2Angle, u);
            return {s.direction, kInfinity, light.emission, s.pdf};
        }
        case LightKind::Area: {
            const ShapeInstance& shape = shapes[light.shape];
            if (light.radius > 0) return sampleBall(light, shape, from, u);
            if (light.rectangle) return sampleRectangle(light, from, u);
            return sampleArea(light, shape, from, media, u);
        }
        case LightKind::Environment: {
            const CompiledEnvironment& environment = lights.environment;
            const EnvironmentSample s = environment.map->sample(Vec2(u));
            if (!(s.pdf > 0)) return {};
            return {environment.worldFromMap(s.direction), kInfinity,
                    environment.scale * s.radiance, s.pdf};
        }
    }
    return {};
}

LightSample lightAlong(const LightTable& lights, const std::vector<ShapeInstance>& shapes,
                       std::uint32_t index, const Ray& ray, const MediaStack& media) {
    const CompiledLight& light = lights.lights[index];
    const double pdf = lightPdf(lights, shapes, index, ray.origin, ray.direction);
    switch (light.kind) {
        case LightKind::Area:
            return meet(light, shapes[light.shape], ray, media, pdf);
        case LightKind::Sun:
            return {ray.direction, kInfinity,
                    light.discHolds(ray.direction) ? light.emission : Rgb(0.0f), pdf};
        case LightKind::Environment:
            return {ray.direction, kInfinity, lights.environment.radiance(ray.direction), pdf};
        default:
            return {};
    }
}

double lightPdf(const LightTable& lights, const std::vector<ShapeInstance>& shapes,
                std::uint32_t index, const DVec3& from, const DVec3& wi) {
    const CompiledLight& light = lights.lights[index];
    switch (light.kind) {
        case LightKind::Point:
        case LightKind::Spot:
            return 0;
        case LightKind::Sun:
            return light.sin2Angle == 0 ? 0 : 1 / coneSolidAngle(light.sin2Angle);
        case LightKind::Environment:
            return lights.environment.map->pdf(lights.environment.mapFromWorld(wi));
        case LightKind::Area:
            break;
    }
    const ShapeInstance& shape = shapes[light.shape];
    if (light.radius > 0) return sphereDirectionPdf(shape.center - from, light.radius);
    if (light.rectangle) return QuadLight(*light.rectangle, from).pdf(wi);
    const Viewpoint view(shape.localPoint(from), shape.worldFromLocal);
    const DVec3 d = glm::normalize(shape.localVector(wi));
    return std::visit([&](const auto& canonical) { return canonical.pdfDirection(view, d); },
                      shape.shape);
}

}  // namespace glint
