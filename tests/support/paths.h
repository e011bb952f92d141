// Where the tests find the scenes, the resources and the command-line program. The only file that
// knows is paths.cpp.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace glint::test {

/// A file or folder of the source tree, as inSource("scenes/report.json").
[[nodiscard]] std::filesystem::path inSource(std::string_view relative);

/// The built glint-render.
[[nodiscard]] std::string renderProgram();

}  // namespace glint::test
