// Reading one JSON value into one document value by the field tables: types, ranges, unknown and
// missing fields, references by name. Overloads of read(), one for each type that a field may have.
// Whole scenes: scene_reader.h.
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "tracer/io/json_text.h"
#include "tracer/scene/scene.h"

namespace glint {

/// The way to a value from the root, on the stack of the readers; becomes a JSON pointer only in an
/// error.
struct JsonPath {
    const JsonPath* parent = nullptr;
    std::string_view key;   ///< in an object
    std::size_t index = 0;  ///< in an array, where key is empty

    [[nodiscard]] JsonPath child(std::string_view name) const { return {this, name, 0}; }
    [[nodiscard]] JsonPath child(std::size_t i) const { return {this, {}, i}; }
    [[nodiscard]] std::string pointer() const;
};

/// The names of one section of the file. They point into the JSON value.
class NameIndex {
  public:
    /// False if the name is taken already.
    bool add(std::string_view name, std::uint32_t id);
    /// The id of a name; 0 if there is none.
    [[nodiscard]] std::uint32_t find(std::string_view name) const;
    [[nodiscard]] const std::vector<std::string_view>& names() const { return names_; }

  private:
    std::unordered_map<std::string_view, std::uint32_t> ids_;
    std::vector<std::string_view> names_;
};

struct SceneNames {
    NameIndex objects, groups, materials, textures, lights, cameras;
};

template <class T>
concept HasFields = requires {
    T::fields();
};

/// The largest colour component a file may hold: the tracer computes with floats, whose largest
/// is 3.4e38.
inline constexpr double kLargestColor = 1e30;

class FieldReader {
  public:
    explicit FieldReader(const SceneNames& names) : names_(names) {}

    [[nodiscard]] std::vector<Error>& errors() { return errors_; }
    void fail(const JsonPath& at, std::string message, std::string remedy);
    /// Remedy for a name that is not known: the nearest one, or all of a short list.
    [[nodiscard]] std::string suggestion(std::string_view wanted,
                                         const std::vector<std::string_view>& known) const;

    /// False, with an error, unless the value is an object whose keys are all among `known`.
    bool checkKeys(const Json& json, const JsonPath& at,
                   const std::vector<std::string_view>& known);

    void read(const Json& json, const FieldMeta& meta, const JsonPath& at, double& out);
    void read(const Json& json, const FieldMeta& meta, const JsonPath& at, int& out);
    void read(const Json& json, const FieldMeta& meta, const JsonPath& at, bool& out);
    void read(const Json& json, const FieldMeta& meta, const JsonPath& at, std::string& out);
    void read(const Json& json, const FieldMeta& meta, const JsonPath& at, Color& out);
    void read(const Json& json, const FieldMeta& meta, const JsonPath& at, DVec2& out);
    void read(const Json& json, const FieldMeta& meta, const JsonPath& at, DVec3& out);
    void read(const Json& json, const FieldMeta& meta, const JsonPath& at,
              std::array<double, 12>& out);
    void read(const Json& json, const FieldMeta& meta, const JsonPath& at, std::vector<Color>& out);
    void read(const Json& json, const FieldMeta& meta, const JsonPath& at, MaterialId& out);
    void read(const Json& json, const FieldMeta& meta, const JsonPath& at, GroupId& out);
    void read(const Json& json, const FieldMeta& meta, const JsonPath& at, CameraId& out);
    void read(const Json& json, const FieldMeta& meta, const JsonPath& at, MixPart& out);
    void read(const Json& json, const FieldMeta& meta, const JsonPath& at, Transform& out);

    void read(const Json& json, const FieldMeta&, const JsonPath& at, Shape& out) {
        readKind<AllShapes>(json, at, out, {});
    }

    template <class E>
    requires std::is_enum_v<E>
    void read(const Json& json, const FieldMeta&, const JsonPath& at, E& out) {
        const auto names = enumNames(E{});
        const std::vector<std::string_view> known(names.begin(), names.end());
        if (const auto chosen = choice(json, at, known)) out = static_cast<E>(*chosen);
    }

    template <class T>
    void read(const Json& json, const FieldMeta& meta, const JsonPath& at, std::optional<T>& out) {
        T value{};
        read(json, meta, at, value);
        out = std::move(value);
    }

    template <class T>
    void read(const Json& json, const FieldMeta& meta, const JsonPath& at, Textured<T>& out) {
        if (json.is_object())
            readTextureName(json, at, out.texture);
        else
            read(json, meta, at, out.value);
    }

    template <HasFields T>
    void read(const Json& json, const FieldMeta&, const JsonPath& at, T& out) {
        readFields(json, at, out, {});
    }

    /// Reads a struct by its table. `known`: other keys of the same object, which the caller reads
    /// itself.
    template <HasFields T>
    void readFields(const Json& json, const JsonPath& at, T& out,
                    std::vector<std::string_view> known) {
        forEachField(
            out, [&](std::string_view name, const FieldMeta&, auto&) { known.push_back(name); });
        if (!checkKeys(json, at, known)) return;
        forEachField(out, [&](std::string_view name, const FieldMeta& meta, auto& member) {
            readMember(json, at, name, meta, member);
        });
    }

    /// Reads {"type": kind, fields...} into the alternative of that kind.
    template <class List>
    void readKind(const Json& json, const JsonPath& at, typename List::Variant& out,
                  std::vector<std::string_view> known) {
        const auto kind = readKindName(json, at, {List::kinds.begin(), List::kinds.end()});
        if (!kind) return;
        known.push_back("type");
        List::withKind(*kind, [&](auto value) {
            readFields(json, at, value, known);
            out = std::move(value);
        });
    }

    /// Reads the member `name` of an object if it is there.
    template <class T>
    void readMember(const Json& json, const JsonPath& at, std::string_view name,
                    const FieldMeta& meta, T& out) {
        const auto found = json.is_object() ? json.find(name) : json.end();
        if (found != json.end())
            read(*found, meta, at.child(name), out);
        else if (meta.required && json.is_object())
            failMissing(at, name);
    }

  private:
    void failMissing(const JsonPath& at, std::string_view name);
    void failType(const JsonPath& at, const Json& found, std::string_view wanted,
                  std::string_view example);
    bool checkRange(const JsonPath& at, const FieldMeta& meta, double value);
    std::optional<double> number(const Json& json, const JsonPath& at);
    std::optional<std::size_t> choice(const Json& json, const JsonPath& at,
                                      const std::vector<std::string_view>& known);
    std::optional<std::string> readKindName(const Json& json, const JsonPath& at,
                                            const std::vector<std::string_view>& kinds);
    template <std::size_t N>
    bool readNumbers(const Json& json, const FieldMeta& meta, const JsonPath& at,
                     std::array<double, N>& out, std::string_view wanted, std::string_view example);
    std::uint32_t reference(const Json& json, const JsonPath& at, const NameIndex& names,
                            std::string_view what);
    void readTextureName(const Json& json, const JsonPath& at, TextureId& out);

    const SceneNames& names_;
    std::vector<Error> errors_;
};

}  // namespace glint
