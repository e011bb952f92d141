// glint-numeric-table: throws the same rays at balls by Glint's method and by those of others, and
// prints the errors as the Markdown table of tests/numeric/README.md. Takes the number of rays a
// row (default 200000).
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <vector>

#include "tests/numeric/table/rivals.h"
#include "tests/support/hit_check.h"

namespace glint {
namespace {

using namespace test;

struct Column {
    const char* name;
    double (*t)(const DVec3& origin, const DVec3& direction, const DVec3& center, double radius);
    std::vector<double> errors;  ///< of the common hits, in float ulps of t
    std::uint64_t wrong = 0;     ///< hits that are misses, and misses that are hits
    double off = 0;              ///< largest distance of a hit from the surface, over the radius
};

double ours(const DVec3& origin, const DVec3& direction, const DVec3& center, double radius) {
    return CanonicalSphere{}
        .first((origin - center) / radius, direction / radius, Start::Elsewhere)
        .t;
}

/// Hits as they are used: Glint puts them back onto the surface in the ball's own space, the others
/// take o + t d.
double distanceOff(const Column& column, const Ray& ray, const DVec3& center, double radius,
                   double t) {
    const DVec3 local = (ray.origin - center) / radius + t * (ray.direction / radius);
    if (column.t == ours)
        return residual(CanonicalSphere{}, VecOf<Float128>(CanonicalSphere{}.project(local, 0)), 0);
    if (column.t == rivals::naive<double>) return std::abs(glm::length(local) - 1);
    const Vec3 p = Vec3(ray.origin) + static_cast<float>(t) * Vec3(ray.direction);
    return std::abs(glm::length(DVec3(p) - center) / radius - 1);
}

void printRow(double distance, double low, double high, std::uint64_t count) {
    Column columns[] = {{"Glint", ours, {}},
                        {"double b²−4ac", rivals::naive<double>, {}},
                        {"RTG 7 float", rivals::gems7, {}},
                        {"perpendicular float", rivals::perpendicular, {}},
                        {"float b²−4ac", rivals::naive<float>, {}}};
    Random random(41);
    for (std::uint64_t i = 0; i < count; ++i) {
        // Numbers that floats hold exactly, so that nobody is blamed for rounding its input.
        const double radius = 1;
        const DVec3 away = random.direction(),
                    side = glm::normalize(glm::cross(away, random.direction()));
        const double sine = std::min(1.0, random.uniform(low, high) / distance),
                     cosine = std::sqrt(1 - sine * sine);
        const Ray ray{toDouble(toFloat(distance * away)),
                      toDouble(toFloat(sine * side - cosine * away))};
        const DVec3 center(0.0);
        const ShapeInstance ball = makeInstance(CanonicalSphere{}, DMat3(radius), center);
        const auto exact = firstReference(ball.shape, localLine<Float128>(ball, ray));
        for (Column& column : columns) {
            const double t = column.t(ray.origin, ray.direction, center, radius);
            if ((t < kInfinity) != exact.has_value()) {
                ++column.wrong;
            } else if (exact) {
                column.errors.push_back(static_cast<double>(absolute(Float128(t) - *exact)) /
                                        std::max(floatUlp(static_cast<double>(*exact)), 0x1p-24));
                column.off = std::max(column.off, distanceOff(column, ray, center, radius, t));
            }
        }
    }
    std::printf("| %g | %g–%g |", distance, low, high);
    for (Column& column : columns) {
        std::sort(column.errors.begin(), column.errors.end());
        const double tail =
            column.errors.empty() ? 0 : column.errors[column.errors.size() * 999 / 1000];
        std::printf(" %.2g · %.2g %% · %.0e |", tail,
                    100.0 * static_cast<double>(column.wrong) / static_cast<double>(count),
                    column.off);
    }
    std::printf("\n");
}

}  // namespace
}  // namespace glint

int main(int argc, char** argv) {
    const std::uint64_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 200000;
    std::printf(
        "| D/r | b/r | Glint | double b²−4ac | RTG 7 float | perpendicular float | float b²−4ac "
        "|\n|---|---|---|---|---|---|---|\n");
    for (const double distance : {1.0001, 1.5, 3.0, 1e2, 1e4, 1e6}) {
        glint::printRow(distance, 0, 0.99, count);
        glint::printRow(distance, 0.999, 1.0, count);
    }
    return 0;
}
