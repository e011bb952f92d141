// Identities within a scene document. An id is never used again; 0 means "none". Files refer by
// name instead.
#pragma once

#include <compare>
#include <cstdint>
#include <string>

namespace glint {

template <class Tag>
struct Id {
    std::uint32_t value = 0;
    explicit operator bool() const { return value != 0; }
    auto operator<=>(const Id&) const = default;  // NOLINT(modernize-use-nullptr): false alarm
};

using ObjectId = Id<struct ObjectTag>;
using GroupId = Id<struct GroupTag>;
using MaterialId = Id<struct MaterialTag>;
using TextureId = Id<struct TextureTag>;
using LightId = Id<struct LightTag>;
using CameraId = Id<struct CameraTag>;

/// A material's colour or number: a constant, or a texture that replaces it.
template <class T>
struct Textured {
    T value{};
    TextureId texture{};

    constexpr Textured() = default;
    constexpr Textured(T v) : value(v) {}
    bool operator==(const Textured&) const = default;
};

/// A part of a mix: another material, or "clear" (the ray goes straight on).
struct MixPart {
    MaterialId material{};
    bool clear = false;
    bool operator==(const MixPart&) const = default;
};

}  // namespace glint
