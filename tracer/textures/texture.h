// Textures as the document holds them. Read, kept and written back; not traced yet (the compiler
// says so by name).
#pragma once

#include <array>
#include <string>
#include <vector>

#include "tracer/base/reflect.h"
#include "tracer/color/rgb.h"

namespace glint {

enum class TextureType { Image, Checker, Gradient, Noise };
[[nodiscard]] constexpr auto enumNames(TextureType) {
    return std::array<std::string_view, 4>{"image", "checker", "gradient", "noise"};
}
enum class ColorSpace { Auto, Srgb, Linear };
[[nodiscard]] constexpr auto enumNames(ColorSpace) {
    return std::array<std::string_view, 3>{"auto", "srgb", "linear"};
}
enum class TextureMapping { Uv, Triplanar };
[[nodiscard]] constexpr auto enumNames(TextureMapping) {
    return std::array<std::string_view, 2>{"uv", "triplanar"};
}

struct Texture {
    std::string name;
    TextureType type = TextureType::Image;
    std::string file;
    ColorSpace colorSpace = ColorSpace::Auto;
    TextureMapping mapping = TextureMapping::Uv;
    DVec2 scale{1, 1};
    std::vector<Color> colors;

    bool operator==(const Texture&) const = default;
    static constexpr auto fields() {
        return std::tuple{
            Field{"name", &Texture::name, {.required = true, .doc = "Unique name"}},
            Field{"type", &Texture::type, {.required = true, .doc = "Kind of texture"}},
            Field{"file", &Texture::file, {.doc = "Image file, relative to the scene"}},
            Field{"color_space", &Texture::colorSpace, {.doc = "How the file's numbers are meant"}},
            Field{"mapping", &Texture::mapping, {.doc = "How it lies on the surface"}},
            Field{"scale", &Texture::scale, {.doc = "Repetitions along u and v"}},
            Field{"colors",
                  &Texture::colors,
                  {.min = 0, .doc = "Colours of a checker, gradient or noise"}}};
    }
};

}  // namespace glint
