// Turntable: a sequence of pictures from all around. Pure functions from the number of a frame.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>

#include "tracer/scene/scene.h"

namespace glint {

struct Turntable {
    int frames = 36;
    int axis = 1;          ///< 0 x, 1 y, 2 z: in world space, through the camera's target
    double degrees = 360;  ///< over the whole sequence; a full turn does not show its start twice
    bool operator==(const Turntable&) const = default;
};

/// The camera of frame 0, 1, ... frames - 1.
[[nodiscard]] Camera cameraOf(const Turntable& turntable, Camera camera, int frame);
/// "picture.png" -> "picture_0001.png" for frame 0: at least four digits, counted from 1.
[[nodiscard]] std::filesystem::path numbered(const std::filesystem::path& file, int frame);

}  // namespace glint
