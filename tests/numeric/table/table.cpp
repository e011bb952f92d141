// glint-numeric-table: the tables of tests/numeric/README.md. The same rays by Glint's method and
// by those of others (rivals.h): errors of hits on balls, and rays that meet the ball that they
// leave. Prints them; with the README's path and a record of the full tests (FullRun in
// support/rays.h), writes them and the counts into the README instead.
#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <thread>
#include <vector>

#include "tests/numeric/table/rivals.h"
#include "tests/support/hit_check.h"
#include "tests/support/world.h"

namespace glint {
namespace {

using namespace test;

constexpr std::uint64_t kRays = 200000;  ///< a row

[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...) {
    char text[512];
    va_list arguments;
    va_start(arguments, pattern);
    std::vsnprintf(text, sizeof text, pattern, arguments);
    va_end(arguments);
    return text;
}

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

std::string hitRow(double distance, double low, double high) {
    Column columns[] = {{"Glint", ours, {}},
                        {"double b²−4ac", rivals::naive<double>, {}},
                        {"RTG 7 float", rivals::gems7, {}},
                        {"perpendicular float", rivals::perpendicular, {}},
                        {"float b²−4ac", rivals::naive<float>, {}}};
    Random random(41);
    for (std::uint64_t i = 0; i < kRays; ++i) {
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
    std::string row = format("| %g | %g–%g |", distance, low, high);
    for (Column& column : columns) {
        std::sort(column.errors.begin(), column.errors.end());
        const double tail =
            column.errors.empty() ? 0 : column.errors[column.errors.size() * 999 / 1000];
        row += format(" %.2g · %.2g %% · %.0e |", tail,
                      100.0 * static_cast<double>(column.wrong) / static_cast<double>(kRays),
                      column.off);
    }
    return row + "\n";
}

std::string hitTable() {
    std::string table =
        "| D/r | b/r | Glint | double b²−4ac | RTG 7 float | perpendicular float | float b²−4ac "
        "|\n|---|---|---|---|---|---|---|\n";
    for (const double distance : {1.0001, 1.5, 3.0, 1e2, 1e4, 1e6})
        table += hitRow(distance, 0, 0.99) + hitRow(distance, 0.999, 1.0);
    return table;
}

/// Rays that leave a ball and meet it again, and how far off the surface they start, over the
/// radius.
struct Spawns {
    std::uint64_t rays = 0, again = 0;
    double off = 0;
    void add(bool met, double distance) { ++rays, again += met ? 1 : 0, off += distance; }
    [[nodiscard]] std::string cell() const {
        const auto n = static_cast<double>(rays);
        return format(" %.2g %% · %.0e |", 100 * static_cast<double>(again) / n, off / n);
    }
};

std::string spawnRow(double radius, double away) {
    Random random(43);
    const DVec3 center = away * radius * glm::normalize(DVec3(0.6, 0.5, -0.7));
    const World world({makeInstance(CanonicalSphere{}, DMat3(radius), center)});
    const auto offSurface = [&](const DVec3& p) {
        return std::abs(glm::length(p - center) / radius - 1);
    };
    Spawns ours, none, epsilon, gems;
    while (ours.rays < kRays) {
        const Ray ray = rayTo(center + 4 * radius * random.direction(),
                              center + 0.9 * radius * random.direction());
        const ShapeHit hit = world.scene.lists->closest(ray, {});
        const double t = rivals::gems7(ray.origin, ray.direction, center, radius);
        if (!hit.found() || !(t < kInfinity)) continue;
        const SurfacePoint point = world.point(ray, hit);
        const Vec3 up = randomUp(random);
        const Ray out = point.ray(up);
        ours.add(world.scene.lists->closest(out, {}).found(), offSurface(out.origin));
        // The others: point, normal and direction in float, and a hit is any t above 0.
        const Vec3 p = Vec3(ray.origin) + static_cast<float>(t) * Vec3(ray.direction),
                   n = glm::normalize(p - Vec3(center)),
                   d(Frame(glm::normalize(DVec3(n))).toWorld(up));
        const auto leave = [&](Spawns& spawns, const Vec3& from) {
            spawns.add(rivals::anyHit(from, d, center, radius), offSurface(DVec3(from)));
        };
        leave(none, p);
        leave(epsilon, p + 1e-4f * d);
        leave(gems, rivals::gems6(p, n));
    }
    return format("| %g m | %g |", radius, away) + ours.cell() + gems.cell() + epsilon.cell() +
           none.cell() + "\n";
}

std::string spawnTable() {
    std::string table =
        "| radius | centre, in radii | Glint | RTG 6 | 1e-4 along the ray | nothing "
        "|\n|---|---|---|---|---|---|\n";
    for (const double radius : {1e-3, 1.0, 1e3})
        for (const double away : {0.0, 1e3, 1e5}) table += spawnRow(radius, away);
    return table;
}

/// What each full test shows, by the number of NUMERICS' table T.
const std::map<std::string, const char*> kTests = {
    {"SphereFull.HitsAgreeWithQuadPrecisionAtEveryDistance", "T1"},
    {"SphereFull.GrazingHitsAgreeWithQuadPrecision", "T2"},
    {"ShapesFull.GrazingHitsOfCurvedSidesAgreeWithQuadPrecision", "T2"},
    {"ShapesFull.HitsArePutBackOntoTheSurface", "T3"},
    {"ShapesFull.HitsUnderAffineTransformsAgreeWithQuadPrecision", "T4"},
    {"ShapesFull.NeedlesAndSliversAgreeWithQuadPrecision", "T4"},
    {"TorusFull.HitsAgreeWithQuadPrecision", "T5"},
    {"TorusFull.RaysFromItsSurfaceFindTheNextCrossing", "T5"},
    {"AcneFull.RaysThatStartOnASurfaceNeverMeetItThere", "T6"},
    {"ContactFull.NothingLeaksThroughTheGapBetweenBalls", "T7"},
    {"ContactFull.ConcentricShellsAHairApartKeepTheirOrder", "T7"},
    {"ContactFull.ShadowBesideABallOnAFloorIsExact", "T7"},
    {"LeaksFull.NoRayGetsOutOfAClosedShape", "T8"},
    {"LeaksFull.InsideAndOutsideOfGlassNeverFlip", "T8"},
    {"ScaleFull.APowerOfTwoLeavesEveryBit", "T11"},
    {"ScaleFull.LightAgreesInOtherSizesAndPlaces", "T11"},
    {"ShapeListsFull.AnswerAsTheLoopForAHundredMillionRays", "T12"},
    {"AnyHitFull.ListsBruteForceAndShadowsAgree", "T13"},
    {"SolidAngleFull.SamplesMatchDensities", "T19"},
    {"SolidAngleFull.DirectionsAreDistributedAsStated", "T19"},
    {"MediaWalkFull.NeverFlipsInsideAndOutsideInAHundredMillionCrossings", "T22"}};

std::string countTable(const std::string& recordPath) {
    std::map<std::string, std::string>
        rows;  // By test, so that a later run replaces an earlier one.
    std::map<std::string, double> durations;
    std::set<double> shares;
    std::ifstream record(recordPath);
    std::string line;
    while (std::getline(record, line)) {
        std::istringstream fields(line);
        std::string name, checks, failures, worst, outcome;
        double seconds = 0, share = 1;
        fields >> name >> checks >> failures >> worst >> outcome >> seconds >> share;
        const auto known = kTests.find(name);
        if (known == kTests.end()) continue;
        rows[known->second + name] =
            format("| %s | `%s` | %.3g | %s | %s | %.0f |\n", known->second, name.c_str(),
                   std::stod(checks), failures.c_str(), outcome.c_str(), seconds);
        durations[name] = seconds;
        shares.insert(share);
    }
    double together = 0;
    for (const auto& [name, seconds] : durations) together += seconds;
    std::string table = format("%s counts, %.0f s together on %u processors.\n\n",
                               shares == std::set{1.0} ? "Full" : "Parts of the full", together,
                               std::thread::hardware_concurrency());
    table += "| | Test | Checks | Failures | Outcome | Seconds |\n|---|---|---|---|---|---|\n";
    for (const auto& [name, row] : rows) table += row;
    for (const auto& [name, number] : kTests)
        if (!durations.contains(name))
            table += format("| %s | `%s` | – | – | not run | – |\n", number, name.c_str());
    return table;
}

/// Puts the table between the README's lines `<!-- name -->` and `<!-- end of name -->`.
bool place(std::string& text, const std::string& name, const std::string& table) {
    const std::string first = "<!-- " + name + " -->\n", last = "<!-- end of " + name + " -->";
    const auto begin = text.find(first), end = text.find(last);
    if (begin == std::string::npos || end == std::string::npos) return false;
    text.replace(begin + first.size(), end - begin - first.size(), "\n" + table + "\n");
    return true;
}

int writeReadme(const std::string& path, const std::string& record) {
    std::ostringstream whole;
    whole << std::ifstream(path).rdbuf();
    std::string text = whole.str();
    if (!place(text, "hits", hitTable()) || !place(text, "spawns", spawnTable()) ||
        !place(text, "counts", countTable(record))) {
        std::fprintf(stderr, "%s: has no places for the tables\n", path.c_str());
        return 1;
    }
    return (std::ofstream(path) << text) ? 0 : 1;
}

}  // namespace
}  // namespace glint

int main(int argc, char** argv) {
    if (argc == 3) return glint::writeReadme(argv[1], argv[2]);
    if (argc != 1) {
        std::fprintf(stderr, "usage: %s [README RECORD]\n", argv[0]);
        return 1;
    }
    std::printf("%s\n%s", glint::hitTable().c_str(), glint::spawnTable().c_str());
    return 0;
}
