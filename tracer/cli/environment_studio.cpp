// A dark photo studio: softboxes and strips around the subject at the origin, a seamless backdrop,
// a satin floor.
#include <array>

#include "tracer/cli/environment_canvas.h"
#include "tracer/cli/environments.h"

namespace glint {

namespace {

constexpr double kFloor = -1.3;  // [m], below the eye of the picture

/// A lamp behind a rectangle of cloth that faces the subject.
struct Softbox {
    DVec3 centre;            ///< [m]
    DVec2 half;              ///< half width and height [m]
    double rollDegrees = 0;  ///< about the line to the subject
    DVec3 radiance{1.0};     ///< in the middle
    double corner = 0.06;    ///< radius of the corners [m]
    double soft = 0.03;      ///< width of the edge [m]
    double falloff = 0.35;   ///< how much darker the corners are than the middle
    double frame = 0.05;     ///< width of the black rim [m]
};

// Key left, fill right, one above, two rims at the back outside of the usual view, a strip above
// the camera, and two weak ones behind it. Warm lights face cool ones, so that glass shows both.
const std::array kSoftboxes = {
    Softbox{{-2.9, 2.0, 1.7}, {1.0, 1.35}, -6, {13.0, 11.9, 10.3}},
    Softbox{{3.3, 1.25, 1.5}, {0.55, 1.2}, 5, {4.0, 4.7, 5.9}},
    Softbox{{0.35, 3.7, -1.2}, {1.25, 0.7}, 0, {10.0, 10.0, 10.0}, 0.1, 0.06},
    Softbox{{3.1, 1.0, -2.5}, {0.16, 1.35}, 4, {13.0, 9.1, 5.6}, 0.03, 0.02, 0.2, 0.03},
    Softbox{{-3.5, 0.95, -2.2}, {0.2, 1.45}, -3, {5.2, 8.0, 12.5}, 0.03, 0.02, 0.2, 0.03},
    Softbox{{0.2, 3.4, 2.6}, {0.9, 0.13}, 0, {9.0, 9.2, 9.6}, 0.03, 0.02, 0.25, 0.03},
    Softbox{{1.3, 0.6, 5.2}, {1.9, 1.1}, 0, {1.15, 1.1, 1.05}, 0.1, 0.25, 0.5, 0.0},
    Softbox{{-1.7, -0.35, 3.9}, {0.35, 0.55}, 12, {2.0, 1.75, 1.45}, 0.05, 0.05, 0.3, 0.03},
};

/// Distance to a rectangle with round corners; negative inside.
double roundedBoxDistance(const DVec2& p, const DVec2& half, double radius) {
    const DVec2 q = glm::abs(p) - half + radius;
    return glm::length(glm::max(q, DVec2(0.0))) + std::min(std::max(q.x, q.y), 0.0) - radius;
}

struct Seen {
    DVec3 radiance{0.0};
    double cover = 0;  ///< share of the view that it fills
};

/// What a ray meets of the box; `blur` [m] widens its edge.
Seen look(const Softbox& box, const DVec3& from, const DVec3& d, double blur) {
    const DVec3 n = glm::normalize(-box.centre);
    const double facing = glm::dot(d, n);
    if (facing >= 0) return {};
    const double t = glm::dot(box.centre - from, n) / facing;
    if (t <= 0) return {};
    const DVec3 side = glm::normalize(glm::cross(DVec3(0, 1, 0), n)), up = glm::cross(n, side);
    const double roll = degreesToRadians(box.rollDegrees);
    const DVec3 p = from + d * t - box.centre;
    const DVec2 flat(glm::dot(p, side), glm::dot(p, up));
    const DVec2 at(std::cos(roll) * flat.x + std::sin(roll) * flat.y,
                   std::cos(roll) * flat.y - std::sin(roll) * flat.x);
    const double distance = roundedBoxDistance(at, box.half, box.corner), soft = box.soft + blur;
    const double lit = glm::smoothstep(soft, -soft, distance);
    const double whole = glm::smoothstep(soft, -soft, distance - box.frame);
    // The lamp behind the cloth makes the middle brighter.
    const DVec2 share = at / box.half;
    const double profile = 1 - box.falloff * (1 - std::exp(-glm::dot(share, share)));
    return {box.radiance * (profile * lit) + DVec3(0.012) * (whole - lit), whole};
}

DVec3 lightsOver(DVec3 background, const DVec3& from, const DVec3& d, double blur) {
    for (const Softbox& box : kSoftboxes) {
        const Seen seen = look(box, from, d, blur);
        background = background * (1 - seen.cover) + seen.radiance;
    }
    return background;
}

/// Cloth that hangs from the ceiling and runs out on the floor: lit low behind the subject, dark
/// above and around.
DVec3 backdrop(const DVec3& d) {
    const double away =
        std::acos(std::clamp(-d.z / std::max(1e-9, std::hypot(d.x, d.z)), -1.0, 1.0));
    const double height = std::asin(std::clamp(d.y, -1.0, 1.0));
    const double glow = std::exp(-std::pow(away / 0.85, 2) - std::pow((height - 0.02) / 0.42, 2));
    const double haze = std::exp(-std::pow(height / 0.5, 2));
    return DVec3(0.016, 0.018, 0.022) + DVec3(0.030, 0.034, 0.042) * haze +
           DVec3(0.30, 0.34, 0.40) * glow;
}

/// Satin floor: its own grey in a pool of light, and a blurred image of the lights above it.
DVec3 floorRadiance(const DVec3& d) {
    const DVec3 p = d * (kFloor / d.y);
    const double far2 = p.x * p.x + p.z * p.z;
    const DVec3 pool = DVec3(0.17, 0.165, 0.16) * std::exp(-far2 / 9);
    const DVec3 mirrored(d.x, -d.y, d.z);
    // Schlick's approximation of Fresnel's law for an index of 1.5.
    const double fresnel = 0.04 + 0.96 * std::pow(1 + d.y, 5);
    const DVec3 image = lightsOver(backdrop(mirrored), p, mirrored, 0.25);
    const DVec3 surface = glm::mix(pool + DVec3(0.02), image, 0.7 * fresnel);
    // Where the cloth bends up there is no edge.
    return glm::mix(backdrop(d), surface, glm::smoothstep(0.0, -0.22, d.y));
}

}  // namespace

Image makeStudio(int width) {
    LatLongCanvas canvas(width);
    canvas.paint(4, [](const DVec3& d) {
        return lightsOver(d.y < 0 ? floorRadiance(d) : backdrop(d), DVec3(0.0), d, 0);
    });
    return canvas.image();
}

}  // namespace glint
