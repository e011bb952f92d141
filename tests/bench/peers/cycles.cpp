#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/bench/clock.h"
#include "tests/bench/peers/renderers.h"
#include "tests/bench/process.h"
#include "tests/support/paths.h"
#include "tracer/io/scene_writer.h"

namespace glint::bench {

namespace {

using Json = nlohmann::ordered_json;

/// Before the number of seconds in Cycles' own log, from the first sample to the last.
constexpr std::string_view kRenderTime = "Render time (without synchronization): ";
constexpr std::string_view kAnswer = "GLINT ";

class CyclesRenderer final : public Renderer {
  public:
    CyclesRenderer(Process process, std::filesystem::path folder)
        : process_(std::move(process)), folder_(std::move(folder)) {}

    /// Waits until the scene is built, and finds what a call costs beside its samples.
    Status prepare() {
        const Stopwatch watch;
        Answer answer;
        if (Status built = await(answer); !built) return built.error();
        for (const auto& note : answer.json.at("notes")) notes_.push_back(note.get<std::string>());
        if (Status first = ask(1, 0, answer); !first)
            return first.error();  // Builds Cycles' own scene.
        setupSeconds_ = watch.wallSeconds();
        if (Status one = ask(1, 0, answer); !one) return one.error();
        callSeconds_ = answer.json.at("cpu").get<double>();
        return Done{};
    }

    Result<TimedPicture> render(int spp, int seed) override {
        Answer answer;
        if (Status asked = ask(spp, seed, answer); !asked) return asked.error();
        Result<std::shared_ptr<const Image>> image = loadImage(picture(), ColorSpace::Linear);
        if (!image) return image.error();
        // Processor time is known of whole calls only: what a call of one sample takes is taken
        // off, but for that sample.
        const double cpu = answer.json.at("cpu").get<double>();
        const double rendering = spp > 1 ? (cpu - callSeconds_) * spp / (spp - 1) : cpu;
        return TimedPicture{*image.value(), answer.renderSeconds, std::max(rendering, 0.0)};
    }
    [[nodiscard]] double setupSeconds() const override { return setupSeconds_; }
    [[nodiscard]] std::vector<std::string> notes() const override { return notes_; }

  private:
    struct Answer {
        Json json;
        double renderSeconds = 0;
    };

    [[nodiscard]] std::filesystem::path picture() const { return folder_ / "cycles.exr"; }

    Status ask(int spp, int seed, Answer& answer) {
        if (!process_.writeLine(
                Json{{"spp", spp}, {"seed", seed}, {"output", picture().string()}}.dump()))
            return failed("it has ended");
        return await(answer);
    }

    Status await(Answer& answer) {
        std::string tail;
        for (std::string line; process_.readLine(line);) {
            if (const std::size_t at = line.find(kRenderTime); at != std::string::npos)
                answer.renderSeconds = std::atof(line.c_str() + at + kRenderTime.size());
            if (line.starts_with(kAnswer)) {
                answer.json = Json::parse(line.substr(kAnswer.size()), nullptr, false);
                if (answer.json.is_object()) return Done{};
                return failed("it answers " + line);
            }
            if (line.find("Error") != std::string::npos || line.starts_with("  File"))
                tail += "\n  " + line;
        }
        return failed("it has ended" + tail);
    }

    static Error failed(const std::string& why) {
        return {"Blender does not render: " + why,     {}, 0, 0, {},
                "the bench is written for Blender 3.4"};
    }

    Process process_;
    std::filesystem::path folder_;
    std::vector<std::string> notes_;
    double setupSeconds_ = 0, callSeconds_ = 0;
};

}  // namespace

Result<std::unique_ptr<Renderer>> startCycles(const PeerScene& scene) {
    const std::filesystem::path file = scene.folder / "scene.json";
    std::ofstream out(file);
    out << sceneJson(scene.scene, Defaults::Written).dump(1) << '\n';
    if (!out.flush()) return Error{"cannot write", file.string(), 0, 0, {}, {}};
    Result<Process> process = Process::start(
        {"blender", "-b", "--factory-startup", "--debug-cycles", "--python-exit-code", "1",
         "--python", test::inSource("tests/bench/peers/cycles_scene.py").string(), "--",
         file.string(), std::to_string(scene.threads), scene.exact ? "exact" : "fast"});
    if (!process) return process.error();
    auto renderer = std::make_unique<CyclesRenderer>(std::move(process).value(), scene.folder);
    const Status ready = renderer->prepare();
    if (!ready) return ready.error();
    return std::unique_ptr<Renderer>(std::move(renderer));
}

}  // namespace glint::bench
