#include "tests/bench/viewport.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <random>
#include <thread>
#include <vector>

#include "tests/bench/clock.h"
#include "tests/bench/output.h"
#include "tests/bench/viewport_scene.h"
#include "tracer/io/scene_json.h"
#include "tracer/render/session.h"

namespace glint::bench {

namespace {

struct ViewportOptions {
    std::vector<std::string> files;
    int edits = 1000, width = 1280, height = 720, threads = 0, shapes = 1000, seed = 1;
    double dragSeconds = 5;
    std::string json;
};

struct Latencies {
    std::vector<double> stopped, first, full, publish;  ///< milliseconds
};

struct Percentiles {
    double p50 = 0, p95 = 0, p99 = 0, p999 = 0;
};
Percentiles percentilesOf(std::vector<double> values) {
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    const auto at = [&](double share) {
        return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) +
                                               0.5)];
    };
    return {at(0.5), at(0.95), at(0.99), at(0.999)};
}

void sleepMs(double ms) {
    std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(ms));
}

/// A viewport without a window: it publishes edits and takes frames as one would.
class Viewport {
  public:
    Viewport(Scene scene, std::filesystem::path folder, const ViewportOptions& options)
        : scene_(std::move(scene)),
          folder_(std::move(folder)),
          random_(static_cast<unsigned>(options.seed)),
          threads_(options.threads),
          session_(options.threads) {
        ViewSettings view;
        view.width = options.width;
        view.height = options.height;
        session_.publish(view);
        publish();
        waitFor([](const SessionFrame& f) { return f.spp > 0; });
    }

    /// Random edits of one kind. Each is followed by a wait until it shows and a random time more,
    /// so that the next one meets the render in every state; every tenth waits until all pixels
    /// have a sample.
    void edit(EditKind kind, int count, Latencies& out) {
        std::uniform_real_distribution<double> pause(0, 60);
        for (int i = 0; i < count; ++i) {
            editScene(scene_, kind, random_);
            const Stopwatch watch;
            const std::uint64_t revision = publish();
            out.publish.push_back(1e3 * watch.wallSeconds());
            const EditLatency shown =
                waitFor([&](const SessionFrame& f) { return f.revision == revision; });
            out.stopped.push_back(1e3 * shown.stopped);
            out.first.push_back(1e3 * shown.firstPicture);
            if (i % 10 != 0) {
                sleepMs(pause(random_));
                continue;
            }
            const EditLatency whole = waitFor([&](const SessionFrame& f) {
                return f.revision == revision && f.latency.fullResolution >= 0;
            });
            out.full.push_back(1e3 * whole.fullResolution);
        }
    }

    /// The camera moves at 60 edits a second for some time, as in a drag: how many edits were seen,
    /// and the longest time without a new picture.
    struct Drag {
        int edits = 0, pictures = 0;
        double longestGapMs = 0;
    };
    Drag drag(double seconds) {
        Drag out;
        const Stopwatch watch;
        double lastPicture = 0, next = 0;
        for (std::uint64_t last = 0; watch.wallSeconds() < seconds;) {
            if (watch.wallSeconds() >= next) {
                editScene(scene_, EditKind::Camera, random_);
                publish();
                ++out.edits;
                next += 1.0 / 60;
            }
            if (const SessionFrame* frame = session_.take(); frame && frame->revision != last) {
                last = frame->revision;
                ++out.pictures;
                out.longestGapMs =
                    std::max(out.longestGapMs, 1e3 * (watch.wallSeconds() - lastPicture));
                lastPicture = watch.wallSeconds();
            }
            sleepMs(0.5);
        }
        return out;
    }

    /// The share of pixels that a new colour of one material makes anew, by material.
    std::vector<std::pair<std::string, double>> retracedShares(Integrator integrator) {
        scene_.render.integrator = integrator;
        scene_.render.errorPercent = scene_.render.timeSeconds = 0;
        std::vector<std::pair<std::string, double>> out;
        for (const MaterialId id : scene_.materials.ids()) {
            const std::uint64_t whole = publish();
            waitFor([&](const SessionFrame& f) { return f.revision == whole && f.spp > 0; });
            Material material = scene_.materials.at(id);
            if (!recolor(material, random_)) continue;
            scene_.materials.set(id, material);
            const std::uint64_t revision = publish();
            double share = 0;
            waitFor([&](const SessionFrame& f) {
                return share = f.retracedShare, f.revision == revision;
            });
            out.emplace_back(material.name, share);
        }
        return out;
    }

  private:
    std::uint64_t publish() { return session_.publish(scene_, folder_); }

    template <class Wanted>
    EditLatency waitFor(Wanted wanted) {
        while (true) {
            if (const SessionFrame* frame = session_.take(); frame && wanted(*frame))
                return frame->latency;
            sleepMs(0.2);
        }
    }

    Scene scene_;
    std::filesystem::path folder_;
    std::mt19937 random_;
    int threads_;
    Session session_;
};

void report(const std::string& scene, const std::string& kind, const Latencies& times, Table& table,
            Json& json) {
    const auto add = [&](const char* what, const std::vector<double>& values) {
        const Percentiles p = percentilesOf(values);
        table.add({scene, kind, what, std::to_string(values.size()), format("%.2f", p.p50),
                   format("%.2f", p.p95), format("%.2f", p.p99)});
        json.push_back({{"scene", scene},
                        {"edit", kind},
                        {"what", what},
                        {"count", values.size()},
                        {"p50_ms", p.p50},
                        {"p95_ms", p.p95},
                        {"p99_ms", p.p99}});
    };
    add("stopped", times.stopped);
    add("first picture", times.first);
    add("full resolution", times.full);
    add("publish", times.publish);
}

void append(std::vector<double>& to, const std::vector<double>& from) {
    to.insert(to.end(), from.begin(), from.end());
}

void measure(const std::string& name, const Scene& scene, const std::filesystem::path& folder,
             const ViewportOptions& options, Table& table, Json& json) {
    Viewport viewport(scene, folder, options);
    Latencies all;
    for (const EditKind kind : kEditKinds) {
        Latencies times;
        viewport.edit(kind, options.edits / static_cast<int>(kEditKinds.size()), times);
        report(name, nameOf(kind), times, table, json["latencies"]);
        append(all.stopped, times.stopped);
        append(all.first, times.first);
        append(all.full, times.full);
        append(all.publish, times.publish);
    }
    report(name, "all", all, table, json["latencies"]);
    const Viewport::Drag drag = viewport.drag(options.dragSeconds);
    std::printf(
        "%s: a drag of %d edits showed %d pictures, the longest time without a new one %.1f ms\n",
        name.c_str(), drag.edits, drag.pictures, drag.longestGapMs);
    json["drags"].push_back({{"scene", name},
                             {"edits", drag.edits},
                             {"pictures", drag.pictures},
                             {"longest_gap_ms", drag.longestGapMs}});
    for (const auto& [integrator, word] :
         {std::pair{Integrator::Classic, "classic"}, std::pair{Integrator::Path, "path"}}) {
        if (scene.objects.size() > 100) break;  // Its materials cover all of it.
        for (const auto& [material, share] : viewport.retracedShares(integrator)) {
            std::printf("%s: a colour of %s in %s makes %.1f %% of the pixels anew\n", name.c_str(),
                        material.c_str(), word, 100 * share);
            json["retraced"].push_back(
                {{"scene", name}, {"material", material}, {"integrator", word}, {"share", share}});
        }
    }
}

int runViewport(ViewportOptions options) {
    if (options.threads == 0)
        options.threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    if (!canWrite(options.json)) return kCannotWrite;
    Table table({"scene", "edit", "until", "count", "p50 ms", "p95 ms", "p99 ms"});
    Json json = {{"width", options.width},     {"height", options.height},
                 {"threads", options.threads}, {"latencies", Json::array()},
                 {"drags", Json::array()},     {"retraced", Json::array()}};
    for (const std::string& file : options.files) {
        auto loaded = loadScene(file);
        if (!loaded.ok()) return complain(loaded.error(), kBadScene);
        measure(std::filesystem::path(file).stem().string(), loaded.value(),
                std::filesystem::path(file).parent_path(), options, table, json);
    }
    if (options.shapes > 0)
        measure(std::to_string(options.shapes) + " shapes", manyShapes(options.shapes), {}, options,
                table, json);
    std::printf("%s", table.markdown().c_str());
    return writeJson(options.json, json) ? kOk : kCannotWrite;
}

}  // namespace

Command viewportCommand(CLI::App& root) {
    auto options = std::make_shared<ViewportOptions>();
    CLI::App* app = root.add_subcommand("viewport",
                                        "How soon edits of camera, materials, lights and objects "
                                        "show in the living render, and what of it is kept");
    app->add_option("FILES", options->files, "Scene files")->check(CLI::ExistingFile);
    app->add_option("--edits", options->edits, "Random edits of each scene, a quarter of each kind")
        ->check(CLI::Range(4, 1000000));
    app->add_option("--shapes", options->shapes, "Shapes of the generated scene; 0: none")
        ->check(CLI::Range(0, 1000000));
    app->add_option("--drag", options->dragSeconds, "Seconds of a drag with 60 edits a second")
        ->check(CLI::Range(0.1, 3600.0));
    app->add_option("--width", options->width, "Of the picture")->check(CLI::Range(16, 8192));
    app->add_option("--height", options->height, "Of the picture")->check(CLI::Range(16, 8192));
    app->add_option("--threads", options->threads, "Workers; 0 is one a processor")
        ->check(CLI::Range(0, 4096));
    app->add_option("--seed", options->seed, "Of the random edits");
    app->add_option("--json", options->json, "Write the figures to this file as JSON");
    return {app, [options] { return runViewport(*options); }};
}

}  // namespace glint::bench
