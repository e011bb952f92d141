#include "tests/bench/scale.h"

#include <cmath>
#include <cstdio>
#include <memory>
#include <thread>

#include "tests/bench/clock.h"
#include "tests/bench/output.h"
#include "tests/bench/shape_field.h"
#include "tracer/compile/compiler.h"
#include "tracer/compile/view.h"
#include "tracer/io/svg_plot.h"
#include "tracer/math/statistics.h"
#include "tracer/render/render.h"

namespace glint::bench {

namespace {

struct ScaleOptions {
    std::size_t mostShapes = 10'000'000;
    int mostLights = 1000;
    int runs = 5;
    std::string json, plot;
};

constexpr std::size_t kRays = 1u << 14;
constexpr double kSecondsARun = 0.1;

/// Seconds of one ray, the median of `runs` runs.
template <class Trace>
double secondsARay(int runs, const std::vector<BenchRay>& rays, Trace&& trace) {
    std::vector<double> seconds;
    for (int run = 0; run < runs; ++run) {
        const Stopwatch watch;
        std::size_t traced = 0;
        double taken = 0;
        for (; taken < kSecondsARun; taken = watch.threadSeconds()) {
            for (const BenchRay& r : rays) trace(r);
            traced += rays.size();
        }
        seconds.push_back(taken / static_cast<double>(traced));
    }
    return median(seconds);
}

/// One number of shapes.
struct ShapePoint {
    double count = 0, nanoseconds = 0, nodes = 0, buildSeconds = 0, moveSeconds = 0,
           hierarchyBytes = 0, shapeBytes = 0;  ///< of one ray; bytes a shape
};

ShapePoint measureShapes(const ScaleOptions& options, std::size_t count, FieldOf kind,
                         const std::vector<BenchRay>& rays) {
    std::vector<ShapeInstance> shapes = makeShapes(count, kind);
    const Stopwatch watch;
    const ShapeLists lists(shapes);
    ShapePoint out;
    out.buildSeconds = watch.wallSeconds();
    const MediaStack media;
    WorkCounts work;
    for (const BenchRay& r : rays) static_cast<void>(lists.closest(r.ray, media, kInfinity, work));
    const auto n = static_cast<double>(count);
    out.count = n;
    out.nodes = static_cast<double>(work[Work::NodeVisits]) / static_cast<double>(rays.size());
    double sum = 0;  // Keeps the answers from being optimised away.
    out.nanoseconds = 1e9 * secondsARay(options.runs, rays, [&](const BenchRay& r) {
                          sum += lists.closest(r.ray, media, kInfinity, work).found();
                      });
    const std::vector<ShapeInstance> before = shapes;
    shapes.front().center.x += 0.01 * kHalfSize;
    const Stopwatch moved;
    static_cast<void>(lists.moved(before, shapes));
    out.moveSeconds = moved.wallSeconds();
    const ShapeLists::Memory memory = lists.memory();
    out.hierarchyBytes = static_cast<double>(memory.hierarchy) / n;
    out.shapeBytes = static_cast<double>(memory.shapes) / n;
    return out;
}

/// How much faster than a logarithm node visits grow from `from` to `to`: 1 is as a logarithm.
double beyondLogarithm(const ShapePoint& from, const ShapePoint& to) {
    return to.nodes / from.nodes / (std::log(to.count) / std::log(from.count));
}

class ScaleBench {
  public:
    explicit ScaleBench(const ScaleOptions& options) : options_(options) {}

    int run() {
        if (!canWrite(options_.json) || !canWrite(options_.plot)) return kCannotWrite;
        std::printf(
            "Shapes up to %zu (about a minute and 250 bytes a shape at ten million), lights up to "
            "%d, threads up to %u.\n\n",
            options_.mostShapes, options_.mostLights, std::thread::hardware_concurrency());
        shapes(FieldOf::Balls, "balls");
        shapes(FieldOf::Mixed, "mixed");
        edits();
        lights();
        threads();
        return writeJson(options_.json, json_) && writeText(options_.plot, svgOf(plot_))
                   ? kOk
                   : kCannotWrite;
    }

  private:
    void shapes(FieldOf kind, const char* name) {
        const std::vector<BenchRay> rays = incoherentRays(kRays);
        Table table({std::string(name), "ns a ray", "nodes a ray", "build [s]", "one moves [s]",
                     "hierarchy [B/shape]", "shape [B/shape]"});
        std::vector<ShapePoint> points;
        PlotCurve curve{std::string(name) + " [ns a ray]", {}};
        for (std::size_t count = 10; count <= options_.mostShapes; count *= 10) {
            const ShapePoint p = measureShapes(options_, count, kind, rays);
            points.push_back(p);
            curve.points.push_back({p.count, p.nanoseconds, 0});
            table.add({format("%zu", count), format("%.0f", p.nanoseconds), format("%.2f", p.nodes),
                       format("%.4f", p.buildSeconds), format("%.4f", p.moveSeconds),
                       format("%.1f", p.hierarchyBytes), format("%.1f", p.shapeBytes)});
            json_["shapes"][name].push_back({{"count", p.count},
                                             {"ns_per_ray", p.nanoseconds},
                                             {"nodes_per_ray", p.nodes},
                                             {"build_seconds", p.buildSeconds},
                                             {"move_seconds", p.moveSeconds},
                                             {"hierarchy_bytes", p.hierarchyBytes},
                                             {"shape_bytes", p.shapeBytes}});
        }
        plot_.curves.push_back(std::move(curve));
        std::printf("%s", table.markdown().c_str());
        growth(name, points);
    }

    /// From a thousand shapes up.
    void growth(const char* name, const std::vector<ShapePoint>& points) {
        std::vector<double> counts, times;
        for (const ShapePoint& p : points)
            if (p.count >= 1000) {
                counts.push_back(p.count);
                times.push_back(p.nanoseconds);
            }
        if (counts.size() < 2) return void(std::printf("\n"));
        const ShapePoint &from = points[points.size() - counts.size()], &to = points.back();
        const PowerLaw law = fitPowerLaw(counts, times);
        std::printf(
            "from %.0f to %.0f: time x %.2f, as count^%.3f; node visits x %.2f, which is %.2f "
            "times a logarithm's growth\n\n",
            from.count, to.count, to.nanoseconds / from.nanoseconds, law.slope,
            to.nodes / from.nodes, beyondLogarithm(from, to));
        json_["growth"][name] = {{"from", from.count},
                                 {"to", to.count},
                                 {"time_factor", to.nanoseconds / from.nanoseconds},
                                 {"time_exponent", law.slope},
                                 {"node_factor", to.nodes / from.nodes},
                                 {"node_factor_over_logarithm", beyondLogarithm(from, to)}};
    }

    /// A floor and balls under a grid of lamps of one total power.
    static Scene lampScene(int lamps) {
        Scene scene;
        scene.film.width = 96;
        scene.film.height = 54;
        scene.render.maxDepth = 4;
        scene.camera.position = {0, 6, 14};
        scene.camera.target = {0, 0.5, 0};
        const MaterialId clay = scene.materials.add({"Clay", Diffuse{}});
        const auto add = [&](const Shape& shape, MaterialId material, const DVec3& at,
                             const Color& emission) {
            Object object;
            object.name = "Object " + std::to_string(scene.objects.size() + 1);
            object.shape = shape;
            object.material = material;
            object.emission = emission;
            object.transform.translate = at;
            scene.objects.add(std::move(object));
        };
        add(Plane{}, clay, {0, 0, 0}, {});
        for (int i = 0; i < 16; ++i)
            add(Sphere{0.5}, clay, {2.0 * (i % 4) - 3, 0.5, 2.0 * (i / 4) - 3}, {});
        const int side = static_cast<int>(std::ceil(std::sqrt(lamps)));
        const double radius = 0.05, power = 3000.0 / lamps;
        for (int i = 0; i < lamps; ++i)
            add(Sphere{radius}, {},
                {10.0 * (i % side + 0.5) / side - 5, 3, 10.0 * (i / side + 0.5) / side - 5},
                {power, power, power});
        return scene;
    }

    /// Processor seconds of one sample of every pixel, and the error.
    struct LightPoint {
        double seconds = 0, error = 0;
    };
    LightPoint renderScene(const Scene& scene, int threads,
                           double Rendering::*passed = nullptr) const {
        AssetCache assets;
        const Result<Compiled> compiled = compile(scene, {}, assets);
        std::vector<double> seconds;
        double error = 0;
        for (int run = 0; run < options_.runs; ++run) {
            const Stopwatch watch;
            const Rendering rendering = render(compiled.value().scene, {.threads = threads});
            seconds.push_back(passed ? rendering.*passed : watch.processSeconds());
            error = rendering.error;
        }
        return {median(seconds), error};
    }

    /// What it takes to compile a scene again after one of its objects or its camera has moved.
    void edits() {
        Table table(
            {"objects", "compiled at first [ms]", "one moved [ms]", "the camera moved [ms]"});
        for (const int objects : {100, 1000, 10000}) {
            Scene scene = lampScene(4);
            const ObjectId last = scene.objects.ids().back();
            const MaterialId clay = scene.materials.ids().front();
            for (int i = 0; i < objects; ++i) {
                Object object{
                    .name = "Grain " + std::to_string(i), .shape = Sphere{0.01}, .material = clay};
                object.transform.translate = {0.1 * (i % 100) - 5, 0.01, 0.1 * (i / 100) - 5};
                scene.objects.add(std::move(object));
            }
            AssetCache assets;
            std::vector<double> first, moved, seen;
            for (int run = 0; run < options_.runs; ++run) {
                const Stopwatch anew;
                auto compiled = compile(scene, {}, assets).value().scene;
                first.push_back(1e3 * anew.wallSeconds());
                Object lamp = scene.objects.at(last);
                lamp.transform.translate.y += 0.01;
                scene.objects.set(last, lamp);
                const Stopwatch again;
                compiled = compile(scene, {}, assets, compiled).value().scene;
                moved.push_back(1e3 * again.wallSeconds());
                scene.camera.position.x += 0.01;
                const Stopwatch view;
                compiled = withView(*compiled, scene).value();
                seen.push_back(1e3 * view.wallSeconds());
            }
            table.add({format("%d", objects), format("%.2f", median(first)),
                       format("%.2f", median(moved)), format("%.3f", median(seen))});
            json_["edits"].push_back({{"objects", objects},
                                      {"first_ms", median(first)},
                                      {"moved_ms", median(moved)},
                                      {"view_ms", median(seen)}});
        }
        std::printf("%s\n", table.markdown().c_str());
    }

    void lights() {
        Table table({"lights", "processor us a sample", "error of the picture %"});
        std::vector<double> counts, times;
        for (int lamps = 1; lamps <= options_.mostLights; lamps *= 10) {
            Scene scene = lampScene(lamps);
            scene.render.spp = 16;
            const LightPoint p = renderScene(scene, 1);
            const double microseconds =
                1e6 * p.seconds / (scene.film.width * scene.film.height * scene.render.spp);
            counts.push_back(lamps);
            times.push_back(microseconds);
            table.add(
                {format("%d", lamps), format("%.2f", microseconds), format("%.2f", 100 * p.error)});
            json_["lights"].push_back(
                {{"count", lamps}, {"us_per_sample", microseconds}, {"error", p.error}});
        }
        std::printf("%s", table.markdown().c_str());
        if (counts.size() < 2) return;
        const PowerLaw law = fitPowerLaw(counts, times);
        std::printf("time of a sample as lights^%.3f\n\n", law.slope);
        json_["growth"]["lights"] = law.slope;
    }

    void threads() {
        Table table({"threads", "s", "speed-up"});
        Scene scene = lampScene(4);
        scene.film.width = 320;
        scene.film.height = 180;
        scene.render.spp = 16;
        double single = 0;
        const int most = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
        for (int count = 1; count <= most; ++count) {
            const double seconds = renderScene(scene, count, &Rendering::seconds).seconds;
            if (count == 1) single = seconds;
            table.add(
                {format("%d", count), format("%.3f", seconds), format("%.2f", single / seconds)});
            json_["threads"].push_back(
                {{"count", count}, {"seconds", seconds}, {"speed_up", single / seconds}});
        }
        std::printf("%s", table.markdown().c_str());
    }

    const ScaleOptions& options_;
    Json json_;
    LogPlot plot_{"Closest hit over the number of shapes, one thread", "shapes", "ns", {}};
};

}  // namespace

Command scaleCommand(CLI::App& root) {
    auto options = std::make_shared<ScaleOptions>();
    CLI::App* app = root.add_subcommand(
        "scale",
        "Growth of time, node visits and memory with shapes and lights; threads (minutes)");
    app->add_option("--shapes", options->mostShapes, "Most shapes")
        ->check(CLI::Range(10, 100'000'000))
        ->capture_default_str();
    app->add_option("--lights", options->mostLights, "Most lights")
        ->check(CLI::Range(1, 100'000))
        ->capture_default_str();
    app->add_option("--runs", options->runs, "Runs of each; the median counts")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app->add_option("--plot", options->plot, "Write the curves to this SVG file");
    app->add_option("--json", options->json, "Write the figures to this file as JSON");
    return {app, [options] { return ScaleBench(*options).run(); }};
}

}  // namespace glint::bench
