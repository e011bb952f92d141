// LightTable: everything that emits, with next-event sampling and its density. Start at
// sampleLight().
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "tracer/color/rgb.h"
#include "tracer/compile/light_choice.h"
#include "tracer/compile/quad_light.h"
#include "tracer/lights/environment_map.h"
#include "tracer/scene/ids.h"

namespace glint {

enum class LightKind { Point, Spot, Sun, Area, Environment };

/// One light in render space.
struct CompiledLight {
    LightKind kind = LightKind::Point;
    DVec3 position{0.0};        ///< Point, Spot
    DVec3 direction{0, -1, 0};  ///< Spot: of the axis; Sun: towards the sun; unit
    DVec3 intensity{0.0};  ///< Point, Spot; in double: a scene of another size has powers of its
                           ///< size in it, which no float holds
    Rgb emission{0.0f};    ///< radiance (Sun with a disc, Area), irradiance (Sun of angle 0)
    float cosInner = 1, cosOuter = 1;  ///< Spot: full inside cosInner, none outside cosOuter
    double sin2Angle = 0;            ///< Sun: sin^2 of half the disc's angle; 0: a single direction
    std::uint32_t shape = kNoShape;  ///< Area
    std::optional<LampRectangle> rectangle;  ///< Area: if it is one
    double radius = 0;      ///< Area: of a ball that is no dielectric, whose boundary is met by the
                            ///< media's rules; 0: anything else
    bool twoSided = false;  ///< Area
    double power = 0;       ///< W up to a common factor
    std::uint8_t group = 0;  ///< whose sum its light goes to, see scene/light_groups.h
    LightId id;              ///< of the scene's entry, if it is one

    /// Sun: the unit vector `towards` meets the disc.
    [[nodiscard]] bool discHolds(const DVec3& towards) const {
        const DVec3 sine = glm::cross(towards, direction);
        return glm::dot(towards, direction) > 0 && glm::dot(sine, sine) <= sin2Angle;
    }
    /// Only next-event estimation can find it.
    [[nodiscard]] bool isDelta() const {
        return kind == LightKind::Point || kind == LightKind::Spot ||
               (kind == LightKind::Sun && sin2Angle == 0);
    }
};

/// Light arriving at a point from one direction.
struct LightSample {
    DVec3 wi{0.0};  ///< unit, towards the light
    double distance = kInfinity;
    Rgb radiance{0.0f};              ///< for delta lights: irradiance on a facing surface
    double pdf = 0;                  ///< per solid angle; 1 for delta lights; 0: no light
    std::uint32_t shape = kNoShape;  ///< the light's own shape, which must not shadow it
};

/// The document's environment: scale times a picture, or scale alone.
struct CompiledEnvironment {
    Rgb scale{0.0f};
    std::shared_ptr<const EnvironmentMap> map;
    double sinRotation = 0, cosRotation = 1;
    bool visibleToCamera = true;
    std::uint8_t group = 0;  ///< as CompiledLight::group

    [[nodiscard]] DVec3 mapFromWorld(const DVec3& d) const {
        return {cosRotation * d.x - sinRotation * d.z, d.y, sinRotation * d.x + cosRotation * d.z};
    }
    [[nodiscard]] DVec3 worldFromMap(const DVec3& d) const {
        return {cosRotation * d.x + sinRotation * d.z, d.y, -sinRotation * d.x + cosRotation * d.z};
    }
    [[nodiscard]] Rgb radiance(const DVec3& direction) const {
        return map ? scale * map->radiance(mapFromWorld(direction)) : scale;
    }
    [[nodiscard]] bool isBlack() const { return glint::isBlack(scale); }
};

struct LightTable {
    std::vector<CompiledLight> lights;
    LightChoice choice;  ///< among `lights`
    CompiledEnvironment environment;
    std::uint32_t environmentLight =
        ~0u;  ///< index of the environment in `lights`; ~0: not sampled (constant or black)
    std::vector<std::uint32_t>
        sunDiscs;  ///< indices of suns with a disc, which rays into the sky can hit

    /// Makes `choice` and what of the lights' shapes sampling needs. Call when `lights` is
    /// complete.
    void finish(const std::vector<ShapeInstance>& shapes);

    [[nodiscard]] bool empty() const { return lights.empty(); }
};

/// Radius of a shape that is a ball in render space; 0 for any other.
[[nodiscard]] double ballRadius(const ShapeInstance& shape);

/// The share of a spot's intensity that goes into the unit direction `wi`, which is towards it.
[[nodiscard]] float spotShare(const CompiledLight& spot, const DVec3& wi);

/// Light at `from` from one that isDelta(). Inline: classic asks for every light at every hit.
[[nodiscard]] inline LightSample sampleDelta(const CompiledLight& light, const DVec3& from) {
    if (light.kind == LightKind::Sun) return {light.direction, kInfinity, light.emission, 1.0};
    const DVec3 to = light.position - from;
    const double distance2 = glm::dot(to, to);
    if (!(distance2 > 0)) return {};
    const double distance = std::sqrt(distance2), inverse = 1 / distance;
    const DVec3 wi = to * inverse;
    Rgb irradiance = toFloat(light.intensity * (inverse * inverse));
    if (light.kind == LightKind::Spot) irradiance *= spotShare(light, wi);
    return {wi, distance, irradiance, 1.0};
}

/// Light from `lights.lights[index]` at the start of `from` (its direction is not used); the media
/// are the ones `from` is in.
[[nodiscard]] LightSample sampleLight(const LightTable& lights,
                                      const std::vector<ShapeInstance>& shapes, std::uint32_t index,
                                      const Ray& from, const MediaStack& media, const DVec2& u);
/// What sampleLight() gives if it draws the direction of `ray`; black where that misses the light.
/// Density 0: it draws other directions only. Not for delta lights.
[[nodiscard]] LightSample lightAlong(const LightTable& lights,
                                     const std::vector<ShapeInstance>& shapes, std::uint32_t index,
                                     const Ray& ray, const MediaStack& media);
/// The density with which sampleLight() would have drawn the direction `wi`, which reaches the
/// light.
[[nodiscard]] double lightPdf(const LightTable& lights, const std::vector<ShapeInstance>& shapes,
                              std::uint32_t index, const DVec3& from, const DVec3& wi);

}  // namespace glint
