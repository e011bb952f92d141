// Document values that refer to nothing -> JSON: for the writer and for the defaults in the schema.
#pragma once

#include <array>
#include <concepts>
#include <string>
#include <vector>

#include "tracer/color/rgb.h"
#include "tracer/io/json_text.h"

namespace glint {

[[nodiscard]] inline Json toJson(double value) { return value; }
[[nodiscard]] inline Json toJson(int value) { return value; }
[[nodiscard]] inline Json toJson(bool value) { return value; }
[[nodiscard]] inline Json toJson(const std::string& value) { return value; }
[[nodiscard]] inline Json toJson(const Color& c) { return Json::array({c.r, c.g, c.b}); }
[[nodiscard]] inline Json toJson(const DVec2& v) { return Json::array({v.x, v.y}); }
[[nodiscard]] inline Json toJson(const DVec3& v) { return Json::array({v.x, v.y, v.z}); }
[[nodiscard]] inline Json toJson(const std::array<double, 12>& m) { return Json(m); }

[[nodiscard]] inline Json toJson(const std::vector<Color>& colors) {
    Json out = Json::array();
    for (const Color& color : colors) out.push_back(toJson(color));
    return out;
}

template <class E>
requires std::is_enum_v<E>
[[nodiscard]] Json toJson(E value) {
    return std::string(enumNames(value)[static_cast<std::size_t>(value)]);
}

}  // namespace glint
