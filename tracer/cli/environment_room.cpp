// A living room: daylight through windows, a sun patch on the boards, a warm lamp. Light on the
// surfaces is direct light in closed form (Lambert's formula for windows) plus an even share for
// what bounces.
#include <array>
#include <optional>

#include "tracer/cli/environment_canvas.h"
#include "tracer/cli/environments.h"
#include "tracer/cli/value_noise.h"

namespace glint {

namespace {

// The room about the eye [m].
const DVec3 kLow(-3.6, -1.3, -3.2), kHigh(3.6, 1.5, 3.2);
const DVec3 kTowardsSun = glm::normalize(DVec3(-0.80, 0.50, -0.28));
const DVec3 kSunIrradiance(8.5, 7.6, 6.2);
const DVec3 kWindowRadiance(3.4, 3.8, 4.3);  // mean over what is seen through one
const DVec3 kBounce(0.95, 0.85, 0.74);       // irradiance by reflected light
const DVec3 kLampPlace(1.75, 0.15, 2.45);
constexpr double kLampRadius = 0.17;
const DVec3 kLampRadiance(9.0, 5.6, 2.7);

enum class Wall { Left, Right, Floor, Ceiling, Front, Back };  // -x +x -y +y -z +z

struct Hit {
    Wall wall;
    DVec3 p, n;  ///< the normal points into the room
    DVec2 at;    ///< along and up the wall; (x, z) on floor and ceiling
};

struct Rectangle {
    DVec2 low, high;
    [[nodiscard]] bool holds(const DVec2& p) const {
        return p.x > low.x && p.y > low.y && p.x < high.x && p.y < high.y;
    }
    [[nodiscard]] Rectangle grown(double by) const { return {low - by, high + by}; }
};

struct Window {
    Wall wall;
    Rectangle glass;
};
const std::array kWindows = {Window{Wall::Left, {{-2.5, -0.55}, {-0.5, 1.15}}},
                             Window{Wall::Left, {{0.5, -0.55}, {2.5, 1.15}}},
                             Window{Wall::Front, {{0.75, -0.55}, {2.6, 1.15}}}};
constexpr double kFrame = 0.07, kBar = 0.025;  // frame around a window, half width of its bars [m]

Hit leaveRoom(const DVec3& d) {
    DVec3 t;
    for (int k = 0; k < 3; ++k) t[k] = (d[k] > 0 ? kHigh[k] : kLow[k]) / (d[k] == 0 ? 1e-12 : d[k]);
    const int axis = t.x < t.y ? (t.x < t.z ? 0 : 2) : (t.y < t.z ? 1 : 2);
    Hit hit{static_cast<Wall>((axis == 0   ? 0
                               : axis == 1 ? 2
                                           : 4) +
                              (d[axis] > 0)),
            d * t[axis],
            DVec3(0.0),
            {}};
    hit.n[axis] = d[axis] > 0 ? -1 : 1;
    hit.at = axis == 0   ? DVec2(hit.p.z, hit.p.y)
             : axis == 1 ? DVec2(hit.p.x, hit.p.z)
                         : DVec2(hit.p.x, hit.p.y);
    return hit;
}

/// Behind a bar that divides the window into two by three panes.
bool onBar(const Rectangle& glass, const DVec2& p) {
    const DVec2 share = (p - glass.low) / (glass.high - glass.low), size = glass.high - glass.low;
    const double upright = std::abs(share.x - 0.5) * size.x,
                 lying = std::abs(share.y - 0.66) * size.y;
    return std::min(upright, lying) < kBar;
}

/// Garden under a summer sky.
DVec3 outside(const DVec3& d) {
    const double azimuth = std::atan2(d.x, -d.z), elevation = std::asin(d.y);
    const double crowns = 0.05 + 0.22 * fractalNoise(DVec2(azimuth * 5 + 40, 0.5), 5);
    const double leaves = fractalNoise(DVec2(azimuth * 22, elevation * 22), 4);
    if (elevation < -0.03)
        return glm::mix(DVec3(0.55, 0.85, 0.25), DVec3(0.8, 1.05, 0.4), leaves) * 1.6;
    if (elevation < crowns)
        return glm::mix(DVec3(0.10, 0.20, 0.05), DVec3(0.75, 1.05, 0.32), leaves * leaves) * 1.7;
    const double clouds =
        glm::smoothstep(0.5, 0.75, fractalNoise(DVec2(d.x, d.z) / (d.y + 0.15) * 0.7, 5));
    const DVec3 blue =
        glm::mix(DVec3(6.2, 7.0, 7.8), DVec3(2.4, 4.0, 7.2), glm::smoothstep(0.0, 0.9, elevation));
    return glm::mix(blue, DVec3(9.0, 8.9, 8.7), 0.75 * clouds);
}

DVec3 pointOnWall(Wall wall, const DVec2& at) {
    return wall == Wall::Left ? DVec3(kLow.x, at.y, at.x) : DVec3(at.x, at.y, kLow.z);
}

/// Irradiance by a polygon of radiance 1 that lies wholly in front of the surface (Lambert 1760):
/// half the sum over edges of angle times cosine to the edge's plane.
double windowIrradiance(const Window& window, const Hit& hit) {
    if (window.wall == hit.wall) return 0;
    const auto& [low, high] = window.glass;
    const std::array corners = {low, DVec2(high.x, low.y), high, DVec2(low.x, high.y)};
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const DVec3 a = glm::normalize(pointOnWall(window.wall, corners[i]) - hit.p);
        const DVec3 b = glm::normalize(pointOnWall(window.wall, corners[(i + 1) % 4]) - hit.p);
        const DVec3 edge = glm::cross(a, b);
        const double sine = glm::length(edge);
        if (sine > 1e-12) sum += std::atan2(sine, glm::dot(a, b)) * glm::dot(edge / sine, hit.n);
    }
    return std::abs(sum) / 2;
}

/// The sun stands in one of the windows as seen from the point; its rim is blurred by the distance.
double sunVisible(const DVec3& p) {
    const double t = (kLow.x - p.x) / kTowardsSun.x;
    if (t <= 0) return 0;
    const DVec3 q = p + kTowardsSun * t;
    const double blur = 0.006 * t + 1e-6;
    double visible = 0;
    for (const Window& window : kWindows) {
        if (window.wall != Wall::Left || !window.glass.grown(blur).holds({q.z, q.y}) ||
            onBar(window.glass, {q.z, q.y}))
            continue;
        const DVec2 inside =
            glm::min(DVec2(q.z, q.y) - window.glass.low, window.glass.high - DVec2(q.z, q.y));
        visible += glm::smoothstep(-blur, blur, std::min(inside.x, inside.y));
    }
    return visible;
}

DVec3 irradiance(const Hit& hit) {
    // Corners get less of the light that bounces.
    const DVec3 gap = glm::min(hit.p - kLow, kHigh - hit.p) + 2.0 * absolute(hit.n);
    DVec3 sum = kBounce * (1 - 0.3 * std::exp(-gap.x / 0.5)) * (1 - 0.3 * std::exp(-gap.y / 0.5)) *
                (1 - 0.3 * std::exp(-gap.z / 0.5));
    for (const Window& window : kWindows) sum += kWindowRadiance * windowIrradiance(window, hit);
    sum += kSunIrradiance * (std::max(0.0, glm::dot(hit.n, kTowardsSun)) * sunVisible(hit.p));
    const DVec3 lamp = kLampPlace - hit.p;
    const double distance2 = glm::dot(lamp, lamp);
    return sum +
           kLampRadiance * (kPi * kLampRadius * kLampRadius * std::max(0.0, glm::dot(hit.n, lamp)) /
                            (distance2 * std::sqrt(distance2)));
}

/// Oak boards along x, and a rug with a border.
DVec3 floorAlbedo(const DVec2& p) {
    const Rectangle rug{{-1.5, -1.0}, {1.5, 1.0}};
    if (rug.holds(p)) {
        if (!rug.grown(-0.16).holds(p)) return {0.07, 0.08, 0.14};
        if (!rug.grown(-0.22).holds(p)) return {0.72, 0.62, 0.44};
        const double weave = fractalNoise(p * 9.0, 3);
        return glm::mix(DVec3(0.16, 0.06, 0.06), DVec3(0.26, 0.10, 0.08), weave);
    }
    const double row = std::floor(p.y / 0.14),
                 along = p.x / 1.4 + latticeValue(static_cast<std::int64_t>(row), 7);
    const double board = latticeValue(static_cast<std::int64_t>(row),
                                      static_cast<std::int64_t>(std::floor(along)) + 100);
    const double grain = fractalNoise(DVec2(p.x * 2.5, p.y * 40 + board * 50), 3);
    const bool gap = std::abs(p.y / 0.14 - std::round(p.y / 0.14)) < 0.02;
    return DVec3(0.44, 0.27, 0.14) *
           ((0.75 + 0.35 * board) * (0.8 + 0.4 * grain) * (gap ? 0.35 : 1.0));
}

/// Shelves full of books on the right wall.
std::optional<DVec3> bookshelfAlbedo(const DVec2& p) {
    const Rectangle shelf{{-1.7, -1.3}, {1.7, 1.0}};
    if (!shelf.holds(p)) return std::nullopt;
    const DVec3 wood(0.36, 0.21, 0.11);
    const double level = (p.y - shelf.low.y) / 0.46, within = level - std::floor(level);
    if (!shelf.grown(-0.05).holds(p) || within < 0.08 || std::abs(p.x) < 0.025) return wood;
    const auto row = static_cast<std::int64_t>(level),
               book = static_cast<std::int64_t>(std::floor(p.x / 0.055));
    const double tall = 0.62 + 0.3 * latticeValue(book, row + 50), hue = latticeValue(book, row);
    if (within > tall || hue < 0.08) return DVec3(0.05, 0.035, 0.025);
    constexpr std::array<std::array<double, 3>, 6> kCovers = {{{0.35, 0.05, 0.04},
                                                               {0.05, 0.10, 0.24},
                                                               {0.62, 0.55, 0.42},
                                                               {0.05, 0.17, 0.09},
                                                               {0.45, 0.25, 0.06},
                                                               {0.12, 0.11, 0.12}}};
    const auto& cover = kCovers[static_cast<std::size_t>(hue * 997) % kCovers.size()];
    const bool label = within > 0.4 && within < 0.48;
    return DVec3(cover[0], cover[1], cover[2]) * (label ? 1.9 : 1.0);
}

/// Pictures, a door and the skirting on plain plaster.
DVec3 wallAlbedo(const Hit& hit) {
    const DVec2 p = hit.at;
    const Rectangle picture = hit.wall == Wall::Front ? Rectangle{{-2.5, -0.15}, {-0.6, 0.95}}
                                                      : Rectangle{{-0.6, -0.1}, {0.5, 0.9}};
    const Rectangle door{{-2.7, -1.3}, {-1.75, 0.8}};
    if (hit.wall == Wall::Right)
        if (const auto shelf = bookshelfAlbedo(p)) return *shelf;
    if (hit.wall == Wall::Back && door.holds(p))
        return door.grown(-0.12).holds(p) ? DVec3(0.55, 0.52, 0.47) : DVec3(0.66, 0.63, 0.58);
    if ((hit.wall == Wall::Front || hit.wall == Wall::Back) && picture.holds(p)) {
        if (!picture.grown(-0.05).holds(p)) return DVec3(0.05, 0.04, 0.035);
        if (!picture.grown(-0.15).holds(p)) return DVec3(0.82, 0.8, 0.76);
        const double field = fractalNoise(p * 2.2 + DVec2(3, 8), 4) + 0.5 * (p.y - picture.low.y);
        return field > 0.85   ? DVec3(0.75, 0.5, 0.18)
               : field > 0.65 ? DVec3(0.62, 0.17, 0.08)
                              : DVec3(0.06, 0.14, 0.24);
    }
    if (p.y < kLow.y + 0.12) return DVec3(0.82, 0.8, 0.77);
    return DVec3(0.74, 0.70, 0.62);
}

DVec3 albedo(const Hit& hit) {
    switch (hit.wall) {
        case Wall::Floor:
            return floorAlbedo(hit.at);
        case Wall::Ceiling:
            return DVec3(0.84, 0.83, 0.80);
        default:
            return wallAlbedo(hit);
    }
}

bool meetsLamp(const DVec3& d) {
    const double along = glm::dot(kLampPlace, d);
    return along > 0 &&
           glm::dot(kLampPlace, kLampPlace) - along * along < kLampRadius * kLampRadius;
}

/// The rod that carries the lamp.
bool meetsRod(const DVec3& d) {
    const DVec2 flat = glm::normalize(DVec2(kLampPlace.x, kLampPlace.z)), ray(d.x, d.z);
    const double across = flat.x * ray.y - flat.y * ray.x, along = glm::dot(flat, ray);
    const double far = glm::length(DVec2(kLampPlace.x, kLampPlace.z));
    return along > 0 && std::abs(across / along) * far < 0.015 && d.y / along * far < kLampPlace.y;
}

DVec3 roomRadiance(const DVec3& d) {
    if (meetsLamp(d)) return kLampRadiance;
    if (meetsRod(d)) return DVec3(0.03);
    const Hit hit = leaveRoom(d);
    for (const Window& window : kWindows) {
        if (window.wall != hit.wall || !window.glass.grown(kFrame).holds(hit.at)) continue;
        if (window.glass.holds(hit.at) && !onBar(window.glass, hit.at)) return outside(d);
        return DVec3(0.8, 0.79, 0.76) * irradiance(hit) / kPi;
    }
    return albedo(hit) * irradiance(hit) / kPi;
}

}  // namespace

Image makeRoom(int width) {
    LatLongCanvas canvas(width);
    canvas.paint(4, roomRadiance);
    return canvas.image();
}

}  // namespace glint
