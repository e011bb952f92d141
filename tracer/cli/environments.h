// The environment pictures that come with Glint (resources/env), computed rather than photographed.
#pragma once

#include <span>
#include <string_view>

#include "tracer/io/image_file.h"

namespace glint {

/// Made with these widths they are the files in resources/env.
inline constexpr int kEnvironmentWidth = 1024;

/// A picture that can be made. Linear Rec.709, deterministic on every processor and for any number
/// of threads.
struct EnvironmentRecipe {
    std::string_view name;         ///< file name without its ending
    std::string_view description;  ///< one line
    Image (*make)(int width);      ///< the height is half the width
};

/// In the order in which a person should see them.
[[nodiscard]] std::span<const EnvironmentRecipe> environmentRecipes();

/// A dark photo studio with softboxes.
[[nodiscard]] Image makeStudio(int width);
/// Clear afternoon with some thin clouds.
[[nodiscard]] Image makeSky(int width);
/// The sun close above the horizon.
[[nodiscard]] Image makeSunset(int width);
/// Even clouds, no sun.
[[nodiscard]] Image makeOvercast(int width);
/// A living room lit by its windows and a lamp.
[[nodiscard]] Image makeRoom(int width);

}  // namespace glint
