#include "tracer/cli/verify.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <string>

#include "tracer/cli/progress.h"
#include "tracer/compile/compiler.h"
#include "tracer/io/image_file.h"
#include "tracer/io/rendering_file.h"
#include "tracer/io/scene_json.h"

namespace glint {

namespace {

void say(const std::string& text) { std::fprintf(stderr, "glint-render: %s\n", text.c_str()); }

ExitCode fail(const Error& error, ExitCode code) {
    say(error.text());
    return code;
}

/// Where two pictures of the same size differ.
struct Difference {
    std::size_t pixels = 0, first = 0;
    std::string channel;  ///< of the largest difference
    double largest = 0;
};

/// Bits, not values: -0 is not 0, and a number that is none equals itself.
Difference compare(const RawImage& a, const RawImage& b) {
    Difference out;
    std::vector<bool> differs(static_cast<std::size_t>(a.width) *
                              static_cast<std::size_t>(a.height));
    for (const auto& [name, values] : a.channels) {
        const std::vector<float>& others = b.channels.at(name);
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (std::memcmp(&values[i], &others[i], sizeof(float)) == 0) continue;
            differs[i] = true;
            const double size =
                std::abs(static_cast<double>(values[i]) - static_cast<double>(others[i]));
            if (out.channel.empty() || size > out.largest) out.channel = name, out.largest = size;
        }
    }
    out.pixels = static_cast<std::size_t>(std::count(differs.begin(), differs.end(), true));
    out.first =
        static_cast<std::size_t>(std::find(differs.begin(), differs.end(), true) - differs.begin());
    return out;
}

bool sameShape(const RawImage& a, const RawImage& b) {
    const auto sameName = [](const auto& x, const auto& y) { return x.first == y.first; };
    return a.width == b.width && a.height == b.height &&
           std::equal(a.channels.begin(), a.channels.end(), b.channels.begin(), b.channels.end(),
                      sameName);
}

/// The scene as the picture was taken of it; an error if it is another one.
Result<Scene> sceneOf(const Options& options, const PictureRecipe& recipe) {
    auto loaded = loadScene(options.scene);
    if (!loaded) return loaded.error();
    if (const std::string hash = sceneHash(worldOf(loaded.value())); hash != recipe.sceneHash)
        return Error{.message = "shows another scene: its hash is " + recipe.sceneHash +
                                ", that of " + options.scene.string() + " is " + hash,
                     .file = options.verify.string(),
                     .remedy = "name the scene as it was when the picture was made"};
    auto scene = withPictureSettings(std::move(loaded).value(), recipe.settings);
    if (!scene) return scene;
    Scene out = std::move(scene).value();
    out.render.spp = recipe.spp;
    out.render.timeSeconds = out.render.errorPercent = 0;
    return out;
}

/// The new rendering as it stands in a file like the picture.
Result<RawImage> throughFile(const Options& options, const Scene& scene, const Rendering& rendering,
                             const PictureOptions& picture) {
    const auto file =
        std::filesystem::temp_directory_path() /
        ("glint-verify-" + std::to_string(::getpid()) + options.verify.extension().string());
    if (const Status saved = saveRendering(file, scene, rendering, picture); !saved)
        return saved.error();
    auto raw = loadRaw(file);
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
    return raw;
}

ExitCode report(const Options& options, const RawImage& picture, const RawImage& again,
                const PictureRecipe& recipe, const std::string& how) {
    const std::string name = options.verify.string();
    if (!sameShape(picture, again)) {
        say(name +
            " has another size or other channels than its metadata says: it was changed since");
        return ExitCode::Different;
    }
    const Difference difference = compare(picture, again);
    const std::string what = std::to_string(picture.width) + " x " +
                             std::to_string(picture.height) + " pixels, " +
                             std::to_string(recipe.spp) + " samples, " + how;
    if (difference.pixels == 0) {
        say(name + " is bit for bit what " + options.scene.string() + " gives: " + what);
        return ExitCode::Done;
    }
    const auto width = static_cast<std::size_t>(picture.width);
    std::array<char, 32> size{};
    std::snprintf(size.data(), size.size(), "%.3g", difference.largest);
    say(name + " differs from what " + options.scene.string() + " gives, in " +
        std::to_string(difference.pixels) + " of " + what + "; the first at " +
        std::to_string(difference.first % width) + "," + std::to_string(difference.first / width) +
        ", the largest difference " + size.data() + " in channel " + difference.channel +
        (recipe.version == GLINT_VERSION
             ? ""
             : "; it was made by version " + recipe.version + ", this is " GLINT_VERSION));
    return ExitCode::Different;
}

std::string joined(const std::vector<std::string>& names) {
    std::string out;
    for (const std::string& name : names) out += (out.empty() ? "" : ", ") + name;
    return out.empty() ? "none" : out;
}

}  // namespace

ExitCode verifyPicture(const Options& options, const std::atomic<bool>& stop) {
    const auto picture = loadRaw(options.verify);
    if (!picture) return fail(picture.error(), ExitCode::Scene);
    const auto recipe = recipeOf(picture.value().metadata, options.verify);
    if (!recipe) return fail(recipe.error(), ExitCode::Scene);
    if (!recipe.value().even)
        return fail({.message = "was cut short or sampled by its error: its pixels have different "
                                "numbers of samples, so it cannot be made again",
                     .file = options.verify.string(),
                     .remedy = "render by a number of samples"},
                    ExitCode::Scene);
    const auto scene = sceneOf(options, recipe.value());
    if (!scene)
        return fail(scene.error(),
                    scene.error().file == options.verify ? ExitCode::Different : ExitCode::Scene);

    AssetCache assets;
    const PictureOptions& how = recipe.value().options;
    const auto compiled =
        compile(sceneFor(scene.value(), how), options.scene.parent_path(), assets);
    if (!compiled) return fail(compiled.error(), ExitCode::Scene);
    ProgressBar bar(options.quiet ? ProgressBar::Mode::Off : ProgressBar::Mode::Automatic);
    RenderRequest request = requestFor(how);
    request.threads = options.threads;
    request.stop = &stop;
    request.progress = [&](const RenderProgress& progress) { bar.show(progress); };
    const Rendering rendering = render(compiled.value().scene, request);
    bar.clear();
    if (rendering.interrupted) {
        say("interrupted; nothing was compared");
        return ExitCode::Interrupted;
    }
    const auto again = throughFile(options, scene.value(), rendering, how);
    if (!again) return fail(again.error(), ExitCode::Output);
    std::string detail = "kernel " + kernelName(*compiled.value().scene) +
                         ", features: " + joined(featureNames(*compiled.value().scene));
    if (how.crop)
        detail += ", crop " + std::to_string(how.crop->x) + "," + std::to_string(how.crop->y) +
                  "," + std::to_string(how.crop->width) + "," + std::to_string(how.crop->height);
    if (how.layers) detail += ", with layers";
    if (how.transparent) detail += ", transparent";
    return report(options, picture.value(), again.value(), recipe.value(), detail);
}

}  // namespace glint
