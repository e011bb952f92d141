#include "tests/bench/peers/peers.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "tests/bench/output.h"
#include "tests/bench/peers/renderers.h"
#include "tests/bench/peers/whitted.h"
#include "tests/bench/process.h"
#include "tests/bench/reference_cache.h"
#include "tests/bench/scene_list.h"
#include "tracer/io/scene_json.h"
#include "tracer/math/statistics.h"

namespace glint::bench {

namespace {

namespace fs = std::filesystem;

/// References are means of this many renders, from whose spread their own uncertainty is known.
constexpr int kReferenceRenders = 4;
constexpr int kReferenceSeed = 1000;

/// One renderer on one scene, and what was measured of it.
struct Contender {
    std::string name;
    std::unique_ptr<Renderer> renderer;
    int spp = 0;
    Reference reference;
    std::vector<double> wall, cpu, relMse;

    [[nodiscard]] std::vector<double> efficiency(const std::vector<double>& seconds) const {
        const double error = meanInterval(relMse).mean;
        std::vector<double> out;
        for (const double s : seconds) out.push_back(1 / (error * s));
        return out;
    }
};

/// Samples a pixel, a power of two, that take about `seconds` of processor time.
Result<int> samplesFor(Renderer& renderer, double seconds) {
    for (int spp = 4;; spp *= 4) {
        const Result<TimedPicture> trial = renderer.render(spp, 1);
        if (!trial) return trial.error();
        const double took = trial.value().cpuSeconds;
        if (took < 0.1 * seconds && spp < (1 << 20)) continue;
        const double wanted = spp * seconds / std::max(took, 1e-6);
        return 1 << std::clamp(static_cast<int>(std::lround(std::log2(wanted))), 0, 20);
    }
}

Result<Reference> makeReference(Renderer& renderer, int spp) {
    ReferenceSum sum;
    for (int i = 0; i < kReferenceRenders; ++i) {
        const Result<TimedPicture> picture = renderer.render(spp, kReferenceSeed + i);
        if (!picture) return picture.error();
        sum.add(picture.value().image);
    }
    return sum.reference();
}

/// Measures one scene with all its renderers in turn.
class SceneComparison {
  public:
    SceneComparison(const PeersOptions& options, PeerScene scene)
        : options_(options), scene_(std::move(scene)) {}

    template <class Any>
    Status add(const std::string& name, Result<std::unique_ptr<Any>> renderer) {
        if (!renderer) return renderer.error();
        contenders_.push_back({name, std::move(renderer).value(), 0, {}, {}, {}, {}});
        return Done{};
    }

    Status measure() {
        for (Contender& c : contenders_) {
            Result<int> spp = samplesFor(*c.renderer, options_.seconds);
            if (!spp) return spp.error();
            c.spp = spp.value();
            const int referenceSpp =
                1 << static_cast<int>(
                    std::ceil(std::log2(c.spp * options_.referenceFactor / kReferenceRenders)));
            const ReferenceCache cache(options_.cache);
            const std::string key =
                format("%s-%s-%s%s-%dspp", scene_.name.c_str(), sceneHash(scene_.scene).c_str(),
                       c.name.c_str(), scene_.exact ? "-exact" : "", referenceSpp);
            Result<Reference> reference =
                cache.get(key, [&] { return makeReference(*c.renderer, referenceSpp); });
            if (!reference) return reference.error();
            c.reference = std::move(reference).value();
        }
        for (int run = 0; run < options_.runs; ++run)
            for (std::size_t i = 0; i < contenders_.size(); ++i) {
                // Every other time in the opposite order, so that a drift of the machine favours
                // nobody.
                Contender& c = contenders_[run % 2 ? contenders_.size() - 1 - i : i];
                Result<TimedPicture> picture = c.renderer->render(c.spp, run + 1);
                if (!picture) return picture.error();
                c.wall.push_back(picture.value().wallSeconds);
                c.cpu.push_back(picture.value().cpuSeconds);
                c.relMse.push_back(pictureErrors(picture.value().image, c.reference).relMse);
            }
        return Done{};
    }

    [[nodiscard]] const PeerScene& scene() const { return scene_; }
    [[nodiscard]] const std::vector<Contender>& contenders() const { return contenders_; }

  private:
    const PeersOptions& options_;
    PeerScene scene_;
    std::vector<Contender> contenders_;
};

/// What one comparison of Glint with one peer says.
struct Verdict {
    bool noisy = false;  ///< both are; else there is no efficiency
    Ratio wall, cpu;     ///< of efficiency
    PictureDifference difference;
};

Verdict judge(const Contender& glint, const Contender& peer) {
    Verdict out;
    out.noisy = meanInterval(glint.relMse).mean > 0 && meanInterval(peer.relMse).mean > 0;
    if (out.noisy) {
        out.wall = pairedRatio(glint.efficiency(glint.wall), peer.efficiency(peer.wall));
        out.cpu = pairedRatio(glint.efficiency(glint.cpu), peer.efficiency(peer.cpu));
    }
    out.difference = pictureDifference(peer.reference, glint.reference);
    return out;
}

Json toJson(const Ratio& ratio) {
    return {{"value", ratio.value}, {"low", ratio.low}, {"high", ratio.high}};
}

Json toJson(const Contender& c) {
    return {{"spp", c.spp},
            {"setup_seconds", c.renderer->setupSeconds()},
            {"wall_seconds", c.wall},
            {"cpu_seconds", c.cpu},
            {"rel_mse", c.relMse},
            {"efficiency_wall", median(c.efficiency(c.wall))},
            {"efficiency_cpu", median(c.efficiency(c.cpu))},
            {"notes", c.renderer->notes()}};
}

Status savePictures(const std::string& folder, const SceneComparison& comparison) {
    if (folder.empty()) return Done{};
    for (const Contender& c : comparison.contenders()) {
        const fs::path file = fs::path(folder) / (comparison.scene().name + "-" + c.name + ".exr");
        if (Status saved = saveLinear(file, c.reference.mean, {}); !saved) return saved;
    }
    return Done{};
}

class PeersBench {
  public:
    explicit PeersBench(const PeersOptions& options) : options_(options) {}

    int run() {
        if (!canWrite(options_.json) || !canWrite(options_.plot)) return kCannotWrite;
        std::error_code failed;
        folder_ = fs::temp_directory_path() / format("glint-peers-%d", static_cast<int>(getpid()));
        fs::create_directories(folder_, failed);
        if (!options_.pictures.empty()) fs::create_directories(options_.pictures, failed);
        cycles_ = present("blender", "Blender, for scenes of the path integrator");
        povray_ = present("povray", "POV-Ray, for scenes of the classic integrator");
        const int code = compareAll();
        fs::remove_all(folder_, failed);
        if (code != kOk) return code;
        summarize();
        const LogPlot plot{"Classic pictures: error over time", "processor time [s]", "relMSE",
                           whitted_.curves};
        return writeJson(options_.json, json_) && writeText(options_.plot, svgOf(plot))
                   ? kOk
                   : kCannotWrite;
    }

  private:
    int compareAll() {
        std::printf(
            "Efficiency is 1 / (relMSE x time); ratios above 1 are in Glint's favour. At %d pixels "
            "wide, %d threads, %d runs of about %g s of\n"
            "processor time each in turn, against references of %g times the samples: at least "
            "%.0f s if none is kept in %s.\n\n",
            options_.width, options_.threads, options_.runs, options_.seconds,
            options_.referenceFactor,
            static_cast<double>(options_.files.size()) * options_.seconds *
                (options_.referenceFactor + options_.runs),
            options_.cache.c_str());
        for (const std::string& file : options_.files) {
            Result<PeerScene> loaded =
                loadPeerScene(file, options_.width, options_.threads, folder_);
            if (!loaded) return complain(loaded.error(), kBadScene);
            PeerScene scene = std::move(loaded).value();
            scene.exact = options_.exact;
            const bool classic = scene.scene.render.integrator == Integrator::Classic;
            if (!(classic ? povray_ : cycles_)) continue;
            if (const int code = classic ? compareWithPovray(options_, scene, whitted_)
                                         : compareWithCycles(scene);
                code != kOk)
                return code;
        }
        return kOk;
    }

    int compareWithCycles(const PeerScene& scene) {
        SceneComparison comparison(options_, scene);
        if (Status added = comparison.add("glint", startGlint(scene)); !added)
            return complain(added.error(), kBadScene);
        if (Status added = comparison.add("cycles", startCycles(scene)); !added)
            return complain(added.error(), kFailed);
        if (Status measured = comparison.measure(); !measured)
            return complain(measured.error(), kFailed);
        if (Status saved = savePictures(options_.pictures, comparison); !saved)
            return complain(saved.error(), kCannotWrite);
        report(comparison);
        return kOk;
    }

    static bool present(const std::string& program, const char* what) {
        const bool found = !findProgram(program).empty();
        if (!found)
            std::fprintf(stderr,
                         "glint-bench: not installed, so skipped: %s (apt-get install %s)\n", what,
                         program.c_str());
        return found;
    }

    void report(const SceneComparison& comparison) {
        const Contender &glint = comparison.contenders()[0], &peer = comparison.contenders()[1];
        const Verdict verdict = judge(glint, peer);
        const auto side = [](const Contender& c) {
            return format("%s: %d spp, setup %.2f s, %.2f s (processor %.2f s), relMSE %.2e",
                          c.name.c_str(), c.spp, c.renderer->setupSeconds(), median(c.wall),
                          median(c.cpu), meanInterval(c.relMse).mean);
        };
        std::printf("%s\n  %s\n  %s\n", comparison.scene().name.c_str(), side(glint).c_str(),
                    side(peer).c_str());
        if (verdict.noisy)
            std::printf(
                "  efficiency ratio %.2f (95 %% %.2f to %.2f), by processor time %.2f (95 %% %.2f "
                "to %.2f)\n",
                verdict.wall.value, verdict.wall.low, verdict.wall.high, verdict.cpu.value,
                verdict.cpu.low, verdict.cpu.high);
        else
            std::printf("  no efficiency: a picture without noise\n");
        std::printf("  pictures: mean %+.2f %%, rms %.2f %% (noise %.2f %%)\n",
                    100 * (verdict.difference.meanRatio - 1), 100 * verdict.difference.rms,
                    100 * verdict.difference.rmsNoise);
        for (const std::string& note : peer.renderer->notes())
            std::printf("  note: %s\n", note.c_str());
        std::fflush(stdout);
        if (verdict.noisy) {
            wall_.push_back(verdict.wall.value);
            cpu_.push_back(verdict.cpu.value);
            names_.push_back(comparison.scene().name);
        }
        json_["scenes"].push_back({{"scene", comparison.scene().name},
                                   {"glint", toJson(glint)},
                                   {"cycles", toJson(peer)},
                                   {"efficiency_ratio_wall", toJson(verdict.wall)},
                                   {"efficiency_ratio_cpu", toJson(verdict.cpu)},
                                   {"picture_mean_ratio", verdict.difference.meanRatio},
                                   {"picture_rms_difference", verdict.difference.rms},
                                   {"picture_rms_noise", verdict.difference.rmsNoise}});
    }

    void summarize() {
        whitted_.summarize(json_);
        if (cpu_.empty()) return;
        const auto worst =
            static_cast<std::size_t>(std::min_element(cpu_.begin(), cpu_.end()) - cpu_.begin());
        std::printf(
            "\nefficiency ratio to Cycles: geometric mean %.2f, by processor time %.2f; worst %.2f "
            "(%s)\n",
            geometricMean(wall_), geometricMean(cpu_), cpu_[worst], names_[worst].c_str());
        json_["geometric_mean_wall"] = geometricMean(wall_);
        json_["geometric_mean_cpu"] = geometricMean(cpu_);
    }

    const PeersOptions& options_;
    fs::path folder_;
    std::vector<double> wall_, cpu_;
    std::vector<std::string> names_;
    WhittedFigures whitted_;
    bool cycles_ = false, povray_ = false;
    Json json_;
};

}  // namespace

Command peersCommand(CLI::App& root) {
    auto options = std::make_shared<PeersOptions>();
    CLI::App* app =
        root.add_subcommand("peers",
                            "Efficiency against Blender's Cycles (scenes of the classic "
                            "integrator: POV-Ray), and whether the pictures agree");
    addSceneFiles(*app, options->files, "tests/bench/scenes and scenes/demo",
                  {"tests/bench/scenes/path", "tests/bench/scenes/classic", "scenes/demo"});
    app->add_option("--width", options->width, "Pixels across; the shape stays")
        ->check(CLI::Range(8, 8192))
        ->capture_default_str();
    app->add_option("--threads", options->threads, "Threads of each renderer")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
    app->add_option("--runs", options->runs, "Renders of each, in turn, each with its own seed")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app->add_option("--seconds", options->seconds, "Processor time of one render, about")
        ->check(CLI::Range(0.01, 3600.0))
        ->capture_default_str();
    app->add_option("--reference", options->referenceFactor,
                    "Samples of the references, in multiples of a render's")
        ->check(CLI::Range(1.0, 1e6))
        ->capture_default_str();
    app->add_flag("--exact", options->exact,
                  "Set Cycles up for the same picture (emissive meshes, energy kept between "
                  "microfacets), not for speed");
    app->add_option("--cache", options->cache, "Folder where references are kept")
        ->capture_default_str();
    app->add_option("--pictures", options->pictures,
                    "Folder for the references as EXR, to look at");
    app->add_option("--plot", options->plot, "Write the curves of classic scenes to this SVG file");
    app->add_option("--json", options->json, "Write the figures to this file as JSON");
    return {app, [options] { return PeersBench(*options).run(); }};
}

}  // namespace glint::bench
