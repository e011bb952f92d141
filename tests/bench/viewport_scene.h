// Random edits as a person makes them, and a scene with many shapes to make them in.
#pragma once

#include <array>
#include <random>
#include <string>

#include "tracer/scene/scene.h"

namespace glint::bench {

enum class EditKind { Camera, Material, Light, Transform };
inline constexpr std::array kEditKinds = {EditKind::Camera, EditKind::Material, EditKind::Light,
                                          EditKind::Transform};
[[nodiscard]] std::string nameOf(EditKind kind);

/// One edit. Where the scene has nothing of the kind the camera moves instead.
void editScene(Scene& scene, EditKind kind, std::mt19937& random);

/// Another colour; false if the material has none.
bool recolor(Material& material, std::mt19937& random);

/// Balls and boxes of eight materials in a grid on a plane, under a sky and three lamps.
[[nodiscard]] Scene manyShapes(int count);

}  // namespace glint::bench
