#include "tracer/io/scene_json.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "tracer/io/atomic_file.h"
#include "tracer/io/scene_check.h"
#include "tracer/io/scene_reader.h"
#include "tracer/io/scene_writer.h"

namespace glint {

namespace {

/// A larger file is refused before it is read: its JSON would take some ten times as much memory.
constexpr std::size_t kLargestFile = std::size_t{512} << 20U;

/// Puts file, line and column into errors that so far have pointers only.
void locate(std::vector<Error>& errors, std::string_view text, const std::string& file) {
    std::vector<std::string> pointers;
    for (const Error& error : errors) pointers.push_back(error.pointer);
    const std::vector<TextPlace> places = placesOf(text, pointers);
    for (std::size_t i = 0; i < errors.size(); ++i) {
        errors[i].file = file;
        errors[i].line = places[i].line;
        errors[i].column = places[i].column;
        errors[i].pointer = shortened(errors[i].pointer, kPointerShown);
    }
}

/// Reads all there is, and checks it as a whole.
SceneReading readChecked(const Json& root) {
    SceneReading out = readScene(root);
    const std::vector<Error> problems = sceneProblems(out.scene);
    out.errors.insert(out.errors.end(), problems.begin(), problems.end());
    return out;
}

Result<Json> parseSceneJson(std::string_view text, const std::string& file) {
    auto json = parseJson(text, file);
    if (json && !(json.value().is_object() && json.value().contains("glint")))
        return Error{.message = "is not a scene: it has no \"glint\"",
                     .file = file,
                     .line = 1,
                     .column = 1,
                     .remedy = "begin it with {\"glint\": 1"};
    return json;
}

/// The JSON library and the standard one may run out of memory; no exception leaves this file.
template <class T, class Run>
Result<T> guarded(const std::string& file, Run&& run) {
    try {
        return run();
    } catch (const std::exception& problem) {
        return Error{.message = std::string("could not be read: ") + problem.what(), .file = file};
    }
}

/// The element that a token names: by index or by its "name".
Json* element(Json& list, const std::string& token) {
    std::size_t index = 0;
    const auto parsed = std::from_chars(token.data(), token.data() + token.size(), index);
    if (parsed.ec == std::errc{} && parsed.ptr == token.data() + token.size())
        return index < list.size() ? &list[index] : nullptr;
    const auto found = std::find_if(list.begin(), list.end(), [&](const Json& entry) {
        return entry.is_object() && entry.contains("name") && entry["name"] == token;
    });
    return found == list.end() ? nullptr : &*found;
}

std::string nearestElement(const Json& list, const std::string& token) {
    std::vector<std::string_view> names;
    for (const Json& entry : list)
        if (entry.is_object() && entry.contains("name"))
            names.push_back(entry["name"].get_ref<const std::string&>());
    const std::string nearest = nearestName(token, names);
    return nearest.empty() ? "use an index or a name" : "did you mean " + inQuotes(nearest) + "?";
}

/// The place of a pointer in a scene's JSON, made where it is a field that is not there yet.
Result<Json*> resolve(Json& root, std::string_view pointer) {
    const auto wrong = [&](std::string message, std::string remedy) {
        return Error{.message = std::move(message),
                     .pointer = shortened(pointer, kPointerShown),
                     .remedy = std::move(remedy)};
    };
    const std::vector<std::string> tokens = pointerTokens(pointer);
    if (tokens.empty() || pointer.front() != '/')
        return wrong("is not a pointer to a value", "write it as /render/spp");
    Json* at = &root;
    for (const std::string& token : tokens) {
        if (at->is_array()) {
            Json* found = element(*at, token);
            if (!found) return wrong("there is no " + inQuotes(token), nearestElement(*at, token));
            at = found;
        } else if (at->is_object() || at->is_null()) {
            at = &(*at)[token];
        } else {
            return wrong("the value before " + inQuotes(token) + " has no fields",
                         "shorten the pointer");
        }
    }
    return at;
}

/// `value` as JSON, or else as a string.
Json settingValue(std::string_view value) {
    auto parsed = parseJson(value, "");
    return parsed ? std::move(parsed).value() : Json(std::string(value));
}

}  // namespace

Result<Scene> parseScene(std::string_view text, const std::string& file) {
    return guarded<Scene>(file, [&]() -> Result<Scene> {
        const auto json = parseSceneJson(text, file);
        if (!json) return json.error();
        SceneReading reading = readChecked(json.value());
        if (reading.errors.empty()) return std::move(reading.scene);
        std::vector<Error> first{reading.errors.front()};
        locate(first, text, file);
        return first.front();
    });
}

Result<Scene> loadScene(const std::filesystem::path& path) {
    const auto text = readWhole(path, kLargestFile);
    return text ? parseScene(text.value(), path.string()) : text.error();
}

Result<PartialScene> loadSceneInPart(const std::filesystem::path& path) {
    const std::string file = path.string();
    const auto text = readWhole(path, kLargestFile);
    if (!text) return text.error();
    return guarded<PartialScene>(file, [&]() -> Result<PartialScene> {
        const auto json = parseSceneJson(text.value(), file);
        if (!json) return json.error();
        SceneReading reading = readChecked(json.value());
        PartialScene out;
        out.scene = withoutFaults(std::move(reading.scene), reading.errors);
        out.leftOut = std::move(reading.errors);
        locate(out.leftOut, text.value(), file);
        return out;
    });
}

std::string formatScene(const Scene& scene) {
    return formatJson(sceneJson(scene, Defaults::LeftOut));
}

Status saveScene(const Scene& scene, const std::filesystem::path& path) {
    return writeWhole(path, formatScene(scene));
}

std::string sceneHash(const Scene& scene) {
    // FNV-1a, 64 bits.
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char c : formatScene(scene))
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    std::array<char, 17> digits{};
    std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(hash));
    return digits.data();
}

std::string pictureSettings(const Scene& scene) {
    Scene out;
    out.camera = scene.viewCamera();
    out.camera.name.clear();
    out.film = scene.film;
    out.display = scene.display;
    out.render = scene.render;
    return formatJsonLine(sceneJson(out, Defaults::LeftOut));
}

Result<Scene> withPictureSettings(Scene scene, std::string_view settings) {
    auto parsed = parseScene(settings, "the picture's settings");
    if (!parsed) return parsed.error();
    const Scene from = std::move(parsed).value();
    scene.camera = from.camera;
    scene.activeCamera = {};
    scene.film = from.film;
    scene.display = from.display;
    scene.render = from.render;
    return scene;
}

Result<Scene> withSetting(const Scene& scene, std::string_view pointer, std::string_view value) {
    return guarded<Scene>("", [&]() -> Result<Scene> {
        Json root = sceneJson(scene, Defaults::Written);
        const auto place = resolve(root, pointer);
        if (!place) return place.error();
        *place.value() = settingValue(value);
        SceneReading reading = readChecked(root);
        if (reading.errors.empty()) return std::move(reading.scene);
        Error error = reading.errors.front();
        error.pointer = shortened(error.pointer, kPointerShown);
        return error;
    });
}

}  // namespace glint
