#include "tests/bench/rays.h"

#include <embree3/rtcore.h>

#include <cstdio>
#include <functional>
#include <vector>

#include "tests/bench/clock.h"
#include "tests/bench/output.h"
#include "tests/bench/packet_balls.h"
#include "tests/bench/shape_field.h"
#include "tests/support/scalar_lists.h"
#include "tracer/math/statistics.h"
#include "tracer/math/transform.h"

namespace glint::bench {

namespace {

constexpr int kSide = 128;
constexpr std::size_t kRays =
    kSide * kSide;        ///< a set; small enough to stay in the cache beside the shapes
constexpr int kRuns = 7;  ///< interleaved; the median counts
constexpr double kSecondsARun = 0.05;

/// What is asked of the shapes: closest hits of rays from a camera or from anywhere, or whether
/// anything is in the way.
struct RaySet {
    const char* name;
    std::vector<BenchRay> rays;
    bool shadow, coherent;
};

/// Embree's sphere points with the places and sizes of the shapes.
class EmbreePoints {
  public:
    explicit EmbreePoints(const std::vector<ShapeInstance>& shapes)
        : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
        const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_SPHERE_POINT);
        auto* points = static_cast<float*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                    4 * sizeof(float), shapes.size()));
        for (const ShapeInstance& shape : shapes) {
            for (int axis = 0; axis < 3; ++axis) *points++ = static_cast<float>(shape.center[axis]);
            *points++ =
                static_cast<float>(std::cbrt(std::abs(glm::determinant(shape.worldFromLocal))));
        }
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
    }
    ~EmbreePoints() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    EmbreePoints(const EmbreePoints&) = delete;
    EmbreePoints& operator=(const EmbreePoints&) = delete;

    [[nodiscard]] bool closest(const BenchRay& r) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit query;
        query.ray = makeRay(r, std::numeric_limits<float>::infinity());
        query.hit.geomID = query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene_, &context, &query);
        return query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }
    [[nodiscard]] bool occluded(const BenchRay& r) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRay query = makeRay(r, static_cast<float>(r.tMax));
        rtcOccluded1(scene_, &context, &query);
        return query.tfar < 0;
    }

  private:
    static RTCRay makeRay(const BenchRay& r, float far) {
        const Vec3 o = toFloat(r.ray.origin), d = toFloat(r.ray.direction);
        RTCRay out{};
        out.org_x = o.x, out.org_y = o.y, out.org_z = o.z;
        out.dir_x = d.x, out.dir_y = d.y, out.dir_z = d.z;
        out.tfar = far;
        out.mask = ~0u;
        return out;
    }
    RTCDevice device_;
    RTCScene scene_;
};

/// One way to ask, and what it took.
struct Contender {
    std::string name;
    std::function<std::size_t()>
        traceAll;  ///< traces each ray once; answers with the number of hits
    std::vector<double> raysASecond = {};
    std::size_t hits = 0;

    [[nodiscard]] double median() const { return glint::median(raysASecond); }
    void run() {
        const Stopwatch watch;
        std::size_t rounds = 0;
        double seconds = 0;
        for (; seconds < kSecondsARun; ++rounds) {
            hits = traceAll();
            seconds = watch.threadSeconds();
        }
        raysASecond.push_back(static_cast<double>(rounds * kRays) / seconds);
    }
};

template <class Trace>
Contender contender(std::string name, const std::vector<BenchRay>& rays, Trace trace) {
    return {std::move(name), [&rays, trace] {
                std::size_t hits = 0;
                for (const BenchRay& r : rays) hits += trace(r) ? 1 : 0;
                return hits;
            }};
}

void report(const std::string& what, std::size_t count, std::vector<Contender>& contenders,
            Json& rows) {
    for (int run = 0; run < kRuns; ++run)
        for (Contender& c : contenders) c.run();
    Json row{{"shapes", what}, {"count", count}};
    std::printf("%-16s %8zu", what.c_str(), count);
    for (const Contender& c : contenders) {
        std::printf("  %s %7.2f M/s", c.name.c_str(), c.median() * 1e-6);
        row[c.name] = {{"raysPerSecond", c.median()},
                       {"hitShare", static_cast<double>(c.hits) / kRays}};
    }
    const double ratio = contenders[0].median() /
                         contenders[1].median();  // Glint to Embree: their order in measure().
    std::printf("  ratio to embree %5.2f  hits %4.1f %%\n", ratio,
                100.0 * static_cast<double>(contenders[0].hits) / kRays);
    std::fflush(stdout);
    row["ratioToEmbree"] = ratio;
    rows.push_back(std::move(row));
}

/// Tile by tile of a camera's rays, as a render does it: the shapes that a tile can see are looked
/// for first.
std::size_t traceTiles(const ShapeLists& lists, const std::vector<BenchRay>& rays, WorkCounts& work,
                       FewShapes& few) {
    const CameraModel camera = fieldCamera(kSide);
    const MediaStack media;
    std::size_t hits = 0, next = 0;
    for (int top = 0; top < kSide; top += kBenchTile)
        for (int left = 0; left < kSide; left += kBenchTile) {
            const auto bundle = camera.bundle(left, top, left + kBenchTile, top + kBenchTile);
            const FewShapes* seen = bundle && lists.cull(*bundle, few) ? &few : nullptr;
            for (const std::size_t end = next + kBenchTile * kBenchTile; next < end; ++next)
                hits += lists.closest(rays[next].ray, media, kInfinity, work, seen).found() ? 1 : 0;
        }
    return hits;
}

void measure(FieldOf kind, std::size_t count, const std::vector<RaySet>& sets, Json& rows) {
    const std::vector<ShapeInstance> shapes = makeShapes(count, kind);
    const ShapeLists lists(shapes);
    const test::ScalarLists scalar(shapes);
    const EmbreePoints embree(shapes);
    const MediaStack media;
    WorkCounts work;
    FewShapes few;
    for (const RaySet& set : sets) {
        const bool shadow = set.shadow;
        const Contender single =
            contender(set.coherent ? "single" : "glint", set.rays, [&, shadow](const BenchRay& r) {
                return shadow ? lists.occluded(r.ray, media, r.tMax, kNoShape, work)
                              : lists.closest(r.ray, media, kInfinity, work).found();
            });
        const Contender tiles{"glint", [&] { return traceTiles(lists, set.rays, work, few); }};
        std::vector<Contender> contenders{
            set.coherent ? tiles : single,
            contender("embree", set.rays, [&, shadow](const BenchRay& r) {
                return shadow ? embree.occluded(r) : embree.closest(r);
            })};
        if (set.coherent) contenders.push_back(single);
        if (count <= 1000)
            contenders.push_back(contender("double", set.rays, [&, shadow](const BenchRay& r) {
                return shadow ? scalar.occluded(r.ray, media, r.tMax, kNoShape)
                              : scalar.closest(r.ray, media).found();
            }));
        const PacketBalls packets(shapes);
        if (kind == FieldOf::Balls && count <= kFlatShapes && set.coherent &&
            PacketBalls::isSupported())
            contenders.push_back({"packets", [&] { return packets.hits(set.rays); }});
        report(std::string(kind == FieldOf::Balls ? "balls " : "mixed ") + set.name, count,
               contenders, rows);
    }
}

/// Nanoseconds of a ray at one torus: rays that meet its bounding ball, and rays that miss it
/// (NUMERICS P2).
void measureTorus(Json& json) {
    ShapeInstance torus;
    torus.shape = CanonicalTorus{0.25};
    torus.worldFromLocal = torus.localFromWorld = DMat3(1.0);
    const ShapeLists lists({torus});
    const MediaStack media;
    WorkCounts work;
    Random random;
    std::vector<BenchRay> meeting, missing;
    while (meeting.size() < kRays || missing.size() < kRays) {
        const BenchRay r{{random.point(), random.direction()}, kInfinity};
        const double along = glm::dot(-r.ray.origin, r.ray.direction),
                     nearest = glm::length(r.ray.origin + std::max(along, 0.0) * r.ray.direction);
        std::vector<BenchRay>& to = nearest < 1.25 ? meeting : missing;
        if (to.size() < kRays) to.push_back(r);
    }
    const auto nanoseconds = [&](const std::vector<BenchRay>& rays) {
        Contender c = contender("torus", rays, [&](const BenchRay& r) {
            return lists.closest(r.ray, media, kInfinity, work).found();
        });
        for (int run = 0; run < kRuns; ++run) c.run();
        return 1e9 / c.median();
    };
    const double meets = nanoseconds(meeting), misses = nanoseconds(missing);
    // Among many, whose bounds are tested eight at a time.
    constexpr std::size_t kTori = 64;
    std::vector<ShapeInstance> many(kTori, torus);
    for (std::size_t i = 0; i < kTori; ++i)
        many[i].center = 20.0 * kHalfSize * DVec3(i % 4, 4 + i / 16, i / 4 % 4);
    const ShapeLists list(many);
    Contender c = contender("tori", missing, [&](const BenchRay& r) {
        return list.closest({r.ray.origin, {0, -1, 0}}, media, kInfinity, work).found();
    });
    for (int run = 0; run < kRuns; ++run) c.run();
    const double shareOfMany = 1e9 / c.median() / kTori;
    std::printf(
        "one torus: %.0f ns a ray that meets its bounding ball, %.1f ns a ray that misses it, %.2f "
        "ns each of %zu that it misses\n",
        meets, misses, shareOfMany, kTori);
    json = {{"ns_meeting", meets}, {"ns_missing", misses}, {"ns_missing_among_many", shareOfMany}};
}

int runRays(const std::string& jsonFile) {
    if (!canWrite(jsonFile)) return kCannotWrite;
    std::printf("One thread, the same rays for both, %d runs in turn: about two minutes.\n", kRuns);
    const std::vector<RaySet> sets{{"primary", cameraRays(kSide), false, true},
                                   {"incoherent", incoherentRays(kRays), false, false},
                                   {"shadow", incoherentRays(kRays), true, false}};
    Json json{{"rows", Json::array()}};
    for (const FieldOf kind : {FieldOf::Balls, FieldOf::Mixed})
        for (const std::size_t count : {1, 2, 3, 4, 8, 16, 64, 128, 129, 1000, 100000})
            measure(kind, count, sets, json["rows"]);
    measureTorus(json["torus"]);
    return writeJson(jsonFile, json) ? kOk : kCannotWrite;
}

}  // namespace

Command raysCommand(CLI::App& root) {
    CLI::App* app =
        root.add_subcommand("rays", "Rays a second on one thread against Embree's sphere points");
    auto json = std::make_shared<std::string>();
    app->add_option("--json", *json, "Write the figures to this file as JSON");
    return {app, [json] { return runRays(*json); }};
}

}  // namespace glint::bench
