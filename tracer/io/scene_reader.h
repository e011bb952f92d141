// A parsed scene file -> the document, by the field tables. Collects every error instead of
// stopping at the first. Rules that concern more than one field are in scene_check.h.
#pragma once

#include <vector>

#include "tracer/io/json_text.h"
#include "tracer/scene/scene.h"

namespace glint {

/// A scene as far as it could be read. Entries of lists have the ids 1, 2, 3 ... of their place in
/// the file; one with errors holds default values. Each error has the JSON pointer of the value at
/// fault, and no file or line.
struct SceneReading {
    Scene scene;
    std::vector<Error> errors;
};
[[nodiscard]] SceneReading readScene(const Json& root);

/// The document without the entries that `errors` point into: those of lists go, sections get their
/// defaults. What referred to a removed entry loses the reference, and an error that says so is
/// added.
[[nodiscard]] Scene withoutFaults(Scene scene, std::vector<Error>& errors);

}  // namespace glint
