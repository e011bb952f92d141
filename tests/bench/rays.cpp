#include "tests/bench/rays.h"

#include <embree3/rtcore.h>

#include <cstdio>
#include <functional>
#include <random>
#include <vector>

#include "tests/bench/clock.h"
#include "tests/bench/output.h"
#include "tests/support/scalar_lists.h"
#include "tracer/math/transform.h"
#include "tracer/math/warp.h"
#include "tracer/math/statistics.h"

namespace glint::bench {

namespace {

constexpr double kHalfSize = 10;  ///< of the cube that shapes and rays are in [m]
constexpr std::size_t kRays =
    1u << 14;             ///< a set; small enough to stay in the cache beside the shapes
constexpr int kRuns = 7;  ///< interleaved; the median counts
constexpr double kSecondsARun = 0.05;

struct Random {
    std::mt19937_64 engine{7};
    double operator()(double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(engine);
    }
    DVec3 point() {
        return {(*this)(-kHalfSize, kHalfSize), (*this)(-kHalfSize, kHalfSize),
                (*this)(-kHalfSize, kHalfSize)};
    }
    DVec3 direction() { return uniformSphere({(*this)(0, 1), (*this)(0, 1)}); }
};

/// A shape of about a quarter of the mean distance between shapes, at a random place.
ShapeInstance instanceOf(const CanonicalShape& shape, std::size_t count, Random& random,
                         bool turned) {
    const double size =
        random(0.5, 1.5) * 0.25 * 2 * kHalfSize / std::cbrt(static_cast<double>(count));
    ShapeInstance out;
    out.shape = shape;
    out.center = random.point();
    DMat3 linear(size);
    if (turned) {
        linear = rotationFromDegrees({random(0, 360), random(0, 360), random(0, 360)});
        for (int axis = 0; axis < 3; ++axis) linear[axis] *= size * random(0.5, 1.5);
    }
    out.worldFromLocal = linear;
    out.localFromWorld = glm::inverse(linear);
    return out;
}

std::vector<ShapeInstance> makeShapes(std::size_t count, bool mixed) {
    const CanonicalShape kinds[] = {CanonicalSphere{},   CanonicalBox{},      CanonicalQuad{},
                                    CanonicalDisk{},     CanonicalCylinder{}, CanonicalCone{},
                                    CanonicalTorus{0.25}};
    Random random;
    std::vector<ShapeInstance> out;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t kind =
            mixed ? i % 8 : 0;  // Of eight: two spheres, one of them round, and one of each other.
        out.push_back(instanceOf(kinds[kind == 7 ? 0 : kind], count, random, mixed && kind != 7));
    }
    return out;
}

struct BenchRay {
    Ray ray;
    double tMax;
};
std::vector<BenchRay> makeRays() {
    Random random;
    random.engine.seed(11);
    std::vector<BenchRay> rays(kRays);
    for (BenchRay& r : rays) {
        r.ray.origin = random.point();
        r.ray.direction = random.direction();
        r.tMax = random(0, 2 * kHalfSize);
    }
    return rays;
}

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

void measure(const std::string& kind, std::size_t count, const std::vector<BenchRay>& rays,
             Json& rows) {
    const std::vector<ShapeInstance> shapes = makeShapes(count, kind == "mixed");
    const ShapeLists lists(shapes);
    const test::ScalarLists scalar(shapes);
    const EmbreePoints embree(shapes);
    const MediaStack media;
    std::vector<Contender> closest{
        contender("glint", rays,
                  [&](const BenchRay& r) { return lists.closest(r.ray, media).found(); }),
        contender("embree", rays, [&](const BenchRay& r) { return embree.closest(r); })};
    std::vector<Contender> occluded{
        contender(
            "glint", rays,
            [&](const BenchRay& r) { return lists.occluded(r.ray, media, r.tMax, kNoShape); }),
        contender("embree", rays, [&](const BenchRay& r) { return embree.occluded(r); })};
    if (count <= 1000) {
        closest.push_back(contender("double", rays, [&](const BenchRay& r) {
            return scalar.closest(r.ray, media).found();
        }));
        occluded.push_back(contender("double", rays, [&](const BenchRay& r) {
            return scalar.occluded(r.ray, media, r.tMax, kNoShape);
        }));
    }
    report(kind + " closest", count, closest, rows);
    report(kind + " occluded", count, occluded, rows);
}

int runRays(const std::string& jsonFile) {
    if (!canWrite(jsonFile)) return kCannotWrite;
    const std::vector<BenchRay> rays = makeRays();
    Json rows = Json::array();
    for (const char* kind : {"balls", "mixed"})
        for (const std::size_t count : {1u, 2u, 3u, 4u, 8u, 16u, 64u, 128u, 129u, 1000u, 100000u})
            measure(kind, count, rays, rows);
    return writeJson(jsonFile, rows) ? kOk : kCannotWrite;
}

}  // namespace

Command raysCommand(CLI::App& root) {
    CLI::App* app = root.add_subcommand("rays", "Rays a second on one thread against Embree's sphere points");
    auto json = std::make_shared<std::string>();
    app->add_option("--json", *json, "Write the figures to this file as JSON");
    return {app, [json] { return runRays(*json); }};
}

}  // namespace glint::bench
