#include "tests/bench/peers/whitted.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/bench/command.h"
#include "tests/bench/peers/povray.h"
#include "tests/bench/peers/renderers.h"
#include "tracer/io/scene_json.h"
#include "tracer/math/statistics.h"

namespace glint::bench {

namespace {

/// Classic pictures take little time: so many times the width makes it measurable.
constexpr int kWidthFactor = 3;
constexpr int kReferenceScale =
    2;  ///< POV-Ray's reference is rendered so many times as wide, with 9 x 9 samples, and averaged
constexpr double kReferenceBailout = 1e-4;
constexpr int kReferenceSpp = 128, kReferenceRenders = 4;

constexpr double kFineBailout = 1e-3;
constexpr std::array<PovrayQuality, 17> kQualities = {{{1, 2, 0},
                                                       {1, 3, 0},
                                                       {1, 4, 0},
                                                       {1, 6, 0},
                                                       {1, 9, 0},
                                                       {1, 3, 0.3},
                                                       {1, 4, 0.1},
                                                       {2, 2, 0.1},
                                                       {2, 3, 0.1},
                                                       {2, 2, 0.03},
                                                       {2, 3, 0.03},
                                                       {2, 3, 0.01},
                                                       {2, 4, 0.01},
                                                       {1, 4, 0, kFineBailout},
                                                       {1, 9, 0, kFineBailout},
                                                       {2, 3, 0.01, kFineBailout},
                                                       {2, 4, 0.01, kFineBailout}}};

/// Errors in percent at which Glint stops.
constexpr std::array kErrors{8.0, 5.6, 4.0, 2.8, 2.0, 1.4, 1.0, 0.7, 0.5, 0.35, 0.25, 0.18};

/// One setting of one renderer.
struct Setting {
    std::string name;
    std::vector<double> wall, cpu;
    double relMse = 0;
};

Image averaged(const Image& image, int scale) {
    Image out{image.width / scale, image.height / scale, {}};
    out.rgb.resize(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height) * 3);
    for (int y = 0; y < out.height * scale; ++y)
        for (int x = 0; x < out.width * scale; ++x)
            for (int c = 0; c < 3; ++c)
                out.rgb[static_cast<std::size_t>((y / scale * out.width + x / scale) * 3 + c)] +=
                    image.rgb[static_cast<std::size_t>((y * image.width + x) * 3 + c)] /
                    static_cast<float>(scale * scale);
    return out;
}

/// The time at which a curve of falling errors reaches `error`, straight in double logarithmic
/// scale; beyond its ends, of its end.
double timeAt(const std::vector<Setting>& curve, double error,
              std::vector<double> Setting::*seconds) {
    const auto time = [&](const Setting& s) { return median(s.*seconds); };
    if (error >= curve.front().relMse) return time(curve.front());
    for (std::size_t i = 1; i < curve.size(); ++i)
        if (error >= curve[i].relMse) {
            const double share = std::log(error / curve[i - 1].relMse) /
                                 std::log(curve[i].relMse / curve[i - 1].relMse);
            return time(curve[i - 1]) * std::pow(time(curve[i]) / time(curve[i - 1]), share);
        }
    return time(curve.back());
}

class WhittedComparison {
  public:
    WhittedComparison(const PeersOptions& options, PeerScene scene)
        : options_(options), scene_(std::move(scene)) {}

    Status measure() {
        Result<Povray> povray = Povray::prepare(scene_);
        if (!povray) return povray.error();
        notes_ = povray.value().notes();
        Result<std::unique_ptr<GlintRenderer>> glint = startGlint(scene_);
        if (!glint) return glint.error();
        if (Status made = makeReferences(povray.value(), *glint.value()); !made) return made;
        for (int run = 0; run < options_.runs; ++run) {
            for (std::size_t i = 0; i < kQualities.size(); ++i) {
                const PovrayQuality& q = kQualities[i];
                Result<TimedPicture> picture = povray.value().render(q);
                if (!picture) return picture.error();
                add(povray_, i,
                    format("+AM%d +R%d +A%g%s", q.method, q.depth, q.threshold,
                           q.bailout <= kFineBailout ? " fine" : ""),
                    picture.value(), povrayReference_);
            }
            for (std::size_t i = 0; i < kErrors.size(); ++i) {
                Result<TimedPicture> picture = glint.value()->renderTo(kErrors[i], 1);
                if (!picture) return picture.error();
                add(glint_, i, format("%g %%", kErrors[i]), picture.value(), glintReference_);
            }
        }
        return Done{};
    }

    /// Settings of POV-Ray that no other beats: in less time, with no more error.
    [[nodiscard]] std::vector<const Setting*> best() const {
        std::vector<const Setting*> out;
        for (const Setting& s : povray_)
            if (std::none_of(povray_.begin(), povray_.end(), [&](const Setting& other) {
                    return median(other.cpu) < median(s.cpu) && other.relMse <= s.relMse;
                }))
                out.push_back(&s);
        return out;
    }
    [[nodiscard]] double ratio(const Setting& of, std::vector<double> Setting::*seconds) const {
        return median(of.*seconds) / timeAt(glint_, of.relMse, seconds);
    }
    [[nodiscard]] PictureDifference difference() const {
        return pictureDifference(povrayReference_, glintReference_);
    }
    [[nodiscard]] const std::vector<Setting>& glint() const { return glint_; }
    [[nodiscard]] const std::vector<Setting>& povray() const { return povray_; }
    [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }
    [[nodiscard]] Status savePictures() const {
        if (options_.pictures.empty()) return Done{};
        const std::filesystem::path folder = options_.pictures;
        if (Status saved =
                saveLinear(folder / (scene_.name + "-povray.exr"), povrayReference_.mean, {});
            !saved)
            return saved;
        return saveLinear(folder / (scene_.name + "-glint.exr"), glintReference_.mean, {});
    }

  private:
    Status makeReferences(const Povray& povray, Renderer& glint) {
        const ReferenceCache cache(options_.cache);
        const std::string key = scene_.name + '-' + sceneHash(scene_.scene);
        const auto fromPovray = [&]() -> Result<Reference> {
            Result<TimedPicture> picture =
                povray.render({1, 9, 0, kReferenceBailout}, kReferenceScale);
            if (!picture) return picture.error();
            Image mean = averaged(picture.value().image, kReferenceScale);
            std::vector<float> certain(mean.rgb.size());
            return Reference{std::move(mean), std::move(certain)};
        };
        const auto fromGlint = [&]() -> Result<Reference> {
            ReferenceSum sum;
            for (int i = 0; i < kReferenceRenders; ++i) {
                Result<TimedPicture> picture = glint.render(kReferenceSpp, 1000 + i);
                if (!picture) return picture.error();
                sum.add(picture.value().image);
            }
            return sum.reference();
        };
        for (auto& [name, make, to] :
             {std::tuple{"povray-exact", std::function<Result<Reference>()>(fromPovray),
                         &povrayReference_},
              std::tuple{"classic", std::function<Result<Reference>()>(fromGlint),
                         &glintReference_}}) {
            Result<Reference> reference = cache.get(key + '-' + name, make);
            if (!reference) return reference.error();
            *to = std::move(reference).value();
        }
        return Done{};
    }

    static void add(std::vector<Setting>& settings, std::size_t index, const std::string& name,
                    const TimedPicture& picture, const Reference& reference) {
        if (index == settings.size())
            settings.push_back({name, {}, {}, pictureErrors(picture.image, reference).relMse});
        settings[index].wall.push_back(picture.wallSeconds);
        settings[index].cpu.push_back(picture.cpuSeconds);
    }

    const PeersOptions& options_;
    PeerScene scene_;
    Reference povrayReference_, glintReference_;
    std::vector<Setting> povray_, glint_;
    std::vector<std::string> notes_;
};

PlotCurve curveOf(std::string name, std::vector<const Setting*> settings) {
    std::sort(settings.begin(), settings.end(),
              [](const Setting* a, const Setting* b) { return median(a->cpu) < median(b->cpu); });
    PlotCurve out{std::move(name), {}};
    for (const Setting* s : settings) out.points.push_back({median(s->cpu), s->relMse, 0});
    return out;
}

Json toJson(const std::vector<Setting>& settings) {
    Json out = Json::array();
    for (const Setting& s : settings)
        out.push_back({{"setting", s.name},
                       {"wall_seconds", s.wall},
                       {"cpu_seconds", s.cpu},
                       {"rel_mse", s.relMse}});
    return out;
}

}  // namespace

int compareWithPovray(const PeersOptions& options, const PeerScene& scene,
                      WhittedFigures& figures) {
    PeerScene large = scene;
    large.scene.film.width *= kWidthFactor;
    large.scene.film.height *= kWidthFactor;
    WhittedComparison comparison(options, large);
    if (Status measured = comparison.measure(); !measured)
        return complain(measured.error(), kFailed);
    if (Status saved = comparison.savePictures(); !saved)
        return complain(saved.error(), kCannotWrite);
    const PictureDifference difference = comparison.difference();
    std::printf("%s (classic, %d x %d): POV-Ray's time over Glint's at the same error\n",
                scene.name.c_str(), large.scene.film.width, large.scene.film.height);
    std::vector<double> wall, cpu;
    for (const Setting* s : comparison.best()) {
        wall.push_back(comparison.ratio(*s, &Setting::wall));
        cpu.push_back(comparison.ratio(*s, &Setting::cpu));
        std::printf(
            "  %-20s relMSE %.2e  %.3f s (processor %.3f s): ratio %.2f, by processor time %.2f\n",
            s->name.c_str(), s->relMse, median(s->wall), median(s->cpu), wall.back(), cpu.back());
    }
    for (const Setting& s : comparison.glint())
        std::printf("  Glint to %-11s relMSE %.2e  %.3f s (processor %.3f s)\n", s.name.c_str(),
                    s.relMse, median(s.wall), median(s.cpu));
    std::printf(
        "  geometric mean %.2f, by processor time %.2f; pictures: mean %+.2f %%, rms %.2f %%\n",
        geometricMean(wall), geometricMean(cpu), 100 * (difference.meanRatio - 1),
        100 * difference.rms);
    for (const std::string& note : comparison.notes()) std::printf("  note: %s\n", note.c_str());
    std::fflush(stdout);
    std::vector<const Setting*> glint;
    for (const Setting& s : comparison.glint()) glint.push_back(&s);
    figures.curves.push_back(curveOf(scene.name + ": Glint", glint));
    figures.curves.push_back(curveOf(scene.name + ": POV-Ray", comparison.best()));
    figures.curves.back().dashed = true;
    figures.names.push_back(scene.name);
    figures.wall.push_back(geometricMean(wall));
    figures.cpu.push_back(geometricMean(cpu));
    figures.scenes.push_back({{"scene", scene.name},
                              {"povray", toJson(comparison.povray())},
                              {"glint", toJson(comparison.glint())},
                              {"time_ratio_wall", figures.wall.back()},
                              {"time_ratio_cpu", figures.cpu.back()},
                              {"picture_mean_ratio", difference.meanRatio},
                              {"picture_rms_difference", difference.rms},
                              {"notes", comparison.notes()}});
    return kOk;
}

void WhittedFigures::summarize(Json& json) const {
    if (names.empty()) return;
    const auto worst =
        static_cast<std::size_t>(std::min_element(cpu.begin(), cpu.end()) - cpu.begin());
    std::printf(
        "\ntime ratio to POV-Ray at the same error: geometric mean %.2f, by processor time %.2f; "
        "worst %.2f (%s)\n",
        geometricMean(wall), geometricMean(cpu), cpu[worst], names[worst].c_str());
    json["povray"] = {{"scenes", scenes},
                      {"geometric_mean_wall", geometricMean(wall)},
                      {"geometric_mean_cpu", geometricMean(cpu)}};
}

}  // namespace glint::bench
