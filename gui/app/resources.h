// Where the files that come with the program are: beside it after an install, else in the source
// tree.
#pragma once

#include <filesystem>

namespace glint {

/// Pictures of surroundings, demo scenes, scenes to start from.
[[nodiscard]] std::filesystem::path environmentFolder();
[[nodiscard]] std::filesystem::path demoFolder();
[[nodiscard]] std::filesystem::path templateFolder();

}  // namespace glint
