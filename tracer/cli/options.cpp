#include "tracer/cli/options.h"

#include <CLI/CLI.hpp>
#include <array>
#include <charconv>

#include "tracer/cli/exit_code.h"
#include "tracer/io/scene_json.h"

namespace glint {

namespace {

/// Whole numbers between `separator`s, as many as asked for; throws the parser's error otherwise.
template <std::size_t N>
std::array<int, N> integers(const std::string& text, char separator, const char* form) {
    std::array<int, N> out{};
    const char *at = text.data(), *end = text.data() + text.size();
    for (std::size_t i = 0; i < N; ++i) {
        const auto parsed = std::from_chars(at, end, out[i]);
        const bool last = i + 1 == N;
        const bool good =
            parsed.ec == std::errc{} &&
            (last ? parsed.ptr == end : parsed.ptr != end && *parsed.ptr == separator);
        if (!good) throw CLI::ValidationError("\"" + text + "\" is not of the form " + form);
        at = parsed.ptr + (last ? 0 : 1);
    }
    return out;
}

std::pair<std::string, std::string> setting(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || text.front() != '/')
        throw CLI::ValidationError("\"" + text + "\" is not of the form /POINTER=VALUE");
    return {text.substr(0, equals), text.substr(equals + 1)};
}

std::string endingsText() {
    std::string out;
    for (const std::string& ending : writableEndings()) out += (out.empty() ? "" : " ") + ending;
    return out;
}

void addPictureOptions(CLI::App& app, Options& options) {
    app.add_option("SCENE", options.scene, "Scene file (.json)")->type_name("");
    app.add_option("-o,--output", options.output, "Picture to write: " + endingsText())
        ->type_name("FILE");
    app.add_option_function<std::string>(
           "--size",
           [&](const std::string& text) {
               const auto size = integers<2>(text, 'x', "WIDTHxHEIGHT");
               options.size = {size[0], size[1]};
           },
           "Size of the picture")
        ->type_name("WxH");
    app.add_option("--spp", options.spp, "Samples a pixel")->type_name("N");
    app.add_option(
           "--error", options.errorPercent,
           "Error of the picture to stop at, in percent of its mean brightness; 0 is no limit")
        ->type_name("PERCENT");
    app.add_option("--time", options.timeSeconds, "Seconds to stop after; 0 is no limit")
        ->type_name("S");
    app.add_option_function<std::string>(
           "--integrator",
           [&](const std::string& name) {
               options.integrator = name == "path" ? Integrator::Path : Integrator::Classic;
           },
           "How light is computed")
        ->check(CLI::IsMember({"path", "classic"}))
        ->type_name("NAME");
    app.add_option("--seed", options.seed, "Other seeds give other noise")->type_name("N");
    app.add_option_function<std::string>(
           "--crop",
           [&](const std::string& text) {
               const auto r = integers<4>(text, ',', "X,Y,WIDTH,HEIGHT");
               options.picture.crop = PixelRect{r[0], r[1], r[2], r[3]};
           },
           "Render only this part; the rest stays black")
        ->type_name("X,Y,W,H");
    app.add_option_function<std::vector<std::string>>(
           "--set",
           [&](const std::vector<std::string>& texts) {
               for (const std::string& text : texts) options.settings.push_back(setting(text));
           },
           "Replace a value of the scene, as /render/max_depth=4 or /objects/Ball/shape/radius=2")
        ->type_name("POINTER=VALUE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    app.add_option("--exposure", options.exposureEv,
                   "Exposure of .png, .jpg and .tif instead of the scene's")
        ->type_name("EV");
}

void addProgramOptions(CLI::App& app, Options& options) {
    app.add_option("--threads", options.threads, "Threads to render with; 0 is one a processor")
        ->check(CLI::Range(0, 4096))
        ->type_name("N");
    app.add_option_function<std::string>(
           "--pixel",
           [&](const std::string& text) {
               const auto place = integers<3>(text, ',', "X,Y,SAMPLE");
               options.pixel = SamplePlace{place[0], place[1], place[2]};
           },
           "Print the paths of one sample and its value instead of rendering")
        ->type_name("X,Y,SAMPLE");
    app.add_flag("--layers", options.picture.layers,
                 "Write light, albedo, normal, depth, position, ids, sample count and error as "
                 "layers of the .exr");
    app.add_flag(
        "--filter", options.picture.filter,
        "Denoise for a preview: the layer filtered of an .exr beside the picture, else the "
        "picture itself, which then says so in its metadata");
    app.add_option("--stats", options.stats, "Write statistics as JSON")->type_name("FILE");
    app.add_flag("--quiet", options.quiet, "No progress and no summary");
    app.add_option("--bits", options.picture.bits,
                   "Bits a channel: 8 or 16 for .png and .tif, 16 or 32 for .exr")
        ->type_name("N");
    app.add_flag("--transparent", options.picture.transparent,
                 "An alpha channel instead of the environment behind the objects");
    app.add_option(
           "--verify", options.verify,
           "Render a picture that Glint wrote again from its metadata, and compare the bits")
        ->type_name("PICTURE");
    app.add_flag("--schema", options.schema, "Print the JSON Schema of scene files and end");
    app.set_version_flag("--version", std::string("glint-render ") + GLINT_VERSION);
    app.footer(
        "Exit codes: 0 done, 1 usage, 2 scene or asset wrong, 3 output cannot be written, 4 "
        "--verify "
        "found a difference, 130 interrupted.");
}

/// What the parser cannot know: which options need or exclude each other.
void checkTogether(const Options& options) {
    if (options.schema) return;
    if (options.scene.empty()) throw CLI::RequiredError("SCENE");
    if (options.pixel || !options.verify.empty()) return;
    if (options.output.empty()) throw CLI::RequiredError("-o FILE, --pixel or --verify");
    if (!isWritableFormat(options.output))
        throw CLI::ValidationError("cannot write \"" + options.output.string() +
                                   "\": its ending is none of " + endingsText());
    if (const Status good = checkPicture(options.output, options.picture); !good)
        throw CLI::ValidationError(good.error().text());
}

Error optionError(const char* option, std::string message, std::string remedy) {
    return {.message = std::string(option) + ": " + std::move(message),
            .remedy = std::move(remedy)};
}

std::string rangeText(const FieldMeta& meta) {
    std::array<char, 80> text{};
    if (meta.max < kInfinity)
        std::snprintf(text.data(), text.size(), "use a number from %.15g to %.15g", meta.min,
                      meta.max);
    else
        std::snprintf(text.data(), text.size(), "use a number of at least %.15g", meta.min);
    return text.data();
}

/// Puts an option's value into the field that it stands for, if it is in the field's range.
template <class Section, class Value>
std::optional<Error> put(const char* option, const std::optional<Value>& value, Section& section,
                         Value Section::*target) {
    if (!value) return std::nullopt;
    std::optional<Error> error;
    forEachField(section, [&](std::string_view, const FieldMeta& meta, auto& member) {
        using Member = std::remove_reference_t<decltype(member)>;
        if constexpr (std::is_arithmetic_v<Member> && std::is_same_v<Value, Member>) {
            const Member wanted = *value;
            if (&member == &(section.*target) && !(wanted >= meta.min && wanted <= meta.max))
                error = optionError(option, "is out of range", rangeText(meta));
        }
    });
    if (!error) section.*target = *value;
    return error;
}

/// The options that are fields of the scene.
std::optional<Error> putAll(Scene& scene, const Options& options) {
    const auto width = options.size ? std::optional(options.size->first) : std::nullopt;
    const auto height = options.size ? std::optional(options.size->second) : std::nullopt;
    if (auto error = put("--size", width, scene.film, &FilmSettings::width)) return error;
    if (auto error = put("--size", height, scene.film, &FilmSettings::height)) return error;
    if (auto error = put("--spp", options.spp, scene.render, &RenderSettings::spp)) return error;
    if (auto error = put("--time", options.timeSeconds, scene.render, &RenderSettings::timeSeconds))
        return error;
    if (auto error =
            put("--error", options.errorPercent, scene.render, &RenderSettings::errorPercent))
        return error;
    if (auto error = put("--seed", options.seed, scene.render, &RenderSettings::seed)) return error;
    if (auto error =
            put("--integrator", options.integrator, scene.render, &RenderSettings::integrator))
        return error;
    return put("--exposure", options.exposureEv, scene.display, &Display::exposureEv);
}

/// The rectangle and the sample asked for lie on the film.
std::optional<Error> checkPlaces(const FilmSettings& film, const Options& options) {
    const std::string size =
        "the film is " + std::to_string(film.width) + " x " + std::to_string(film.height);
    const auto& crop = options.picture.crop;
    if (crop && (crop->x < 0 || crop->y < 0 || crop->width < 1 || crop->height < 1 ||
                 crop->width > film.width - crop->x || crop->height > film.height - crop->y))
        return optionError("--crop", "reaches out of the picture", size);
    const auto& pixel = options.pixel;
    if (pixel && (pixel->x < 0 || pixel->y < 0 || pixel->x >= film.width ||
                  pixel->y >= film.height || pixel->sample < 0))
        return optionError("--pixel", "there is no such sample", size + ", samples count from 0");
    return std::nullopt;
}

}  // namespace

std::variant<Options, int> parseOptions(int argc, char** argv) {
    Options options;
    CLI::App app{"Renders a Glint scene to a picture.", "glint-render"};
    addPictureOptions(app, options);
    addProgramOptions(app, options);
    try {
        app.parse(argc, argv);
        checkTogether(options);
    } catch (const CLI::Success& request) {
        return app.exit(request);
    } catch (const CLI::ParseError& problem) {
        app.exit(problem);
        return static_cast<int>(ExitCode::Usage);
    }
    return options;
}

Result<Scene> withOptions(Scene scene, const Options& options) {
    for (const auto& [pointer, value] : options.settings) {
        auto changed = withSetting(scene, pointer, value);
        if (!changed) {
            Error error = changed.error();
            error.file = "--set " + pointer + "=" + value;
            return error;
        }
        scene = std::move(changed).value();
    }
    if (auto error = putAll(scene, options)) return *error;
    if (auto error = checkPlaces(scene.film, options)) return *error;
    return scene;
}

}  // namespace glint
