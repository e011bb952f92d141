// Scene files: JSON <-> document, by the field tables of the document's structs. The format is a
// contract: a field is never dropped, also if nothing renders it yet. Start at parseScene() and
// formatScene().
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tracer/base/result.h"
#include "tracer/scene/scene.h"

namespace glint {

/// A scene read from a file with bad entries: what could be kept, and why each other entry was left
/// out.
struct PartialScene {
    Scene scene;
    std::vector<Error> leftOut;
};

/// Reads a scene file. Errors (the first one found): cannot be read, invalid JSON, duplicate key,
/// unknown field or name (with the closest known one), wrong type or range, missing or duplicate
/// names, cycles; each with line and pointer.
[[nodiscard]] Result<Scene> loadScene(const std::filesystem::path& path);
/// The same for text; `file` only names it in errors.
[[nodiscard]] Result<Scene> parseScene(std::string_view text, const std::string& file);
/// For the editor: fails only where the JSON itself is invalid; entries with errors are left out
/// and listed.
[[nodiscard]] Result<PartialScene> loadSceneInPart(const std::filesystem::path& path);

/// The file's text: keys in the order of the field tables, values equal to their default left out,
/// shortest round-trip numbers. parseScene(formatScene(s)) == s for a scene without problems
/// (scene_check.h) whose ids have no gaps; reading gives ids anew: 1, 2, 3 ... in the order of the
/// file. `editor` is kept as JSON on one line.
[[nodiscard]] std::string formatScene(const Scene& scene);
/// Writes the file whole or not at all (write to a sibling, then rename).
[[nodiscard]] Status saveScene(const Scene& scene, const std::filesystem::path& path);

/// A stable 64-bit hash of formatScene(), as 16 hexadecimal digits: tells which scene a picture
/// shows.
[[nodiscard]] std::string sceneHash(const Scene& scene);

/// How a picture of the scene is taken: view camera, film, display and render, as a scene file on
/// one line without anything else.
[[nodiscard]] std::string pictureSettings(const Scene& scene);
/// The scene with such settings in the place of its own.
[[nodiscard]] Result<Scene> withPictureSettings(Scene scene, std::string_view settings);

/// The scene with the value at a JSON pointer replaced, as for `--set /render/spp=64`. Within lists
/// of named things an index or the name may stand: /objects/Ball/shape/radius. `value` is JSON, or
/// else taken as a string. Ids are given anew.
[[nodiscard]] Result<Scene> withSetting(const Scene& scene, std::string_view pointer,
                                        std::string_view value);

/// JSON text of single things, for the clipboard and the like: a small scene file with the objects
/// and what they refer to (materials, textures, groups), lights and cameras.
[[nodiscard]] std::string formatObjects(const Scene& scene, const std::vector<ObjectId>& objects,
                                        const std::vector<LightId>& lights = {},
                                        const std::vector<CameraId>& cameras = {});
/// The scene with such a text's things added under free names; also gives what is new. A
/// material, texture or group that the scene has already, with the same name and content, is used
/// again. The text's other sections are not used.
struct PastedObjects {
    Scene scene;
    std::vector<ObjectId> added;
    std::vector<LightId> lights;
    std::vector<CameraId> cameras;
};
[[nodiscard]] Result<PastedObjects> pasteObjects(const Scene& scene, std::string_view text);

/// JSON Schema (draft 2020-12) of the format, generated from the field tables.
[[nodiscard]] std::string sceneSchema();

}  // namespace glint
