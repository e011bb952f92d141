#include "tracer/cli/environment_canvas.h"

namespace glint {

namespace {

float roundedTo11Bits(double value) {
    int exponent = 0;
    const double mantissa = std::frexp(value, &exponent);
    return static_cast<float>(std::ldexp(std::nearbyint(std::ldexp(mantissa, 11)), exponent - 11));
}

}  // namespace

DVec3 latLongDirection(double u, double v) {
    const double phi = (u - 0.5) * 2 * kPi, theta = v * kPi;
    return {std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)};
}

DVec2 latLongUv(const DVec3& d) {
    return {std::atan2(d.x, -d.z) / (2 * kPi) + 0.5, std::atan2(std::hypot(d.x, d.z), d.y) / kPi};
}

LatLongCanvas::LatLongCanvas(int width)
    : width_(width),
      radiance_(static_cast<std::size_t>(width) * static_cast<std::size_t>(width / 2)) {}

double LatLongCanvas::texelSolidAngle(int row) const {
    return 2 * kPi / width() *
           (std::cos(kPi * row / height()) - std::cos(kPi * (row + 1) / height()));
}

void LatLongCanvas::addDisc(const DVec3& centre, double angularRadius, const DVec3& radiance) {
    constexpr int kRings = 256, kSpokes = 512;
    const DVec3 w = glm::normalize(centre);
    const DVec3 u = glm::normalize(
                    glm::cross(std::abs(w.y) < 0.9 ? DVec3(0, 1, 0) : DVec3(1, 0, 0), w)),
                v = glm::cross(w, u);
    const double cap = 1 - std::cos(angularRadius), share = 2 * kPi * cap / (kRings * kSpokes);
    for (int ring = 0; ring < kRings; ++ring)
        for (int spoke = 0; spoke < kSpokes; ++spoke) {
            // Points of equal solid angle.
            const double cosine = 1 - cap * (ring + 0.5) / kRings,
                         sine = std::sqrt(1 - cosine * cosine);
            const double phi = 2 * kPi * (spoke + 0.5) / kSpokes;
            const DVec2 uv = latLongUv(w * cosine + (u * std::cos(phi) + v * std::sin(phi)) * sine);
            const int row = std::min(static_cast<int>(uv.y * height()), height() - 1);
            const int column = std::min(static_cast<int>(uv.x * width()), width() - 1);
            texel(row, column) += radiance * (share / texelSolidAngle(row));
        }
}

Image LatLongCanvas::image() const {
    Image image{width(), height(), {}};
    image.rgb.reserve(radiance_.size() * 3);
    for (const DVec3& c : radiance_)
        for (int k = 0; k < 3; ++k) image.rgb.push_back(roundedTo11Bits(c[k]));
    return image;
}

}  // namespace glint
