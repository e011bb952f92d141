#include "tests/bench/peers/povray.h"

#include <cstdlib>

#include "tests/bench/output.h"
#include "tests/bench/peers/povray_scene.h"
#include "tests/bench/process.h"

namespace glint::bench {

namespace {

/// The number that stands before `after` in the line that begins with `begin`: "Trace Time: 0 hours
/// ... (1.234 seconds)".
double numberBefore(const std::string& output, const std::string& begin, const std::string& after) {
    const std::size_t line = output.find(begin);
    if (line == std::string::npos) return -1;
    const std::size_t end = output.find(after, line);
    if (end == std::string::npos) return -1;
    const std::size_t start = output.find_last_of(" (", end - 1);
    return std::atof(output.c_str() + start + 1);
}

}  // namespace

Result<Povray> Povray::prepare(const PeerScene& scene) {
    Povray out;
    out.scene_ = scene;
    out.file_ = scene.folder / (scene.name + ".pov");
    PovrayScene written = povrayScene(scene.scene);
    if (!writeText(out.file_.string(), written.text))
        return Error{"cannot write", out.file_.string(), 0, 0, {}, {}};
    out.notes_ = std::move(written.notes);
    return out;
}

Result<TimedPicture> Povray::render(const PovrayQuality& quality, int scale) const {
    const std::filesystem::path picture = scene_.folder / (scene_.name + "-povray.exr");
    const FilmSettings& film = scene_.scene.film;
    const Result<Finished> run = runProgram(
        {"povray", "+I" + file_.string(), "+O" + picture.string(), "+FE", "-D", "-P",
         "+WT" + std::to_string(scene_.threads), "+W" + std::to_string(film.width * scale),
         "+H" + std::to_string(film.height * scale), "+AM" + std::to_string(quality.method),
         format("+A%.3f", quality.threshold), "+R" + std::to_string(quality.depth), "-J", "+Q9",
         "File_Gamma=1.0", format("Declare=Bailout=%.6f", quality.bailout)});
    if (!run) return run.error();
    const double wall = numberBefore(run.value().output, "Trace Time:", " seconds)"),
                 cpu = numberBefore(run.value().output, "Trace Time:", " CPU-seconds");
    if (run.value().exitCode != 0 || cpu < 0)
        return Error{
            "POV-Ray does not render: " +
                run.value().output.substr(run.value().output.size() -
                                          std::min<std::size_t>(600, run.value().output.size())),
            file_.string(),
            0,
            0,
            {},
            "the bench is written for POV-Ray 3.7"};
    Result<std::shared_ptr<const Image>> image = loadImage(picture, ColorSpace::Linear);
    if (!image) return image.error();
    return TimedPicture{*image.value(), wall, cpu};
}

}  // namespace glint::bench
