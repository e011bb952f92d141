#include "tracer/io/field_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glint {

namespace {

/// "1.5", as a person would write it.
std::string numberText(double value) { return formatJsonLine(Json(value)); }

std::string joined(const std::vector<std::string_view>& names) {
    std::string out;
    for (const std::string_view name : names) out += (out.empty() ? "" : ", ") + std::string(name);
    return out;
}

}  // namespace

std::string JsonPath::pointer() const {
    std::vector<const JsonPath*> steps;
    for (const JsonPath* at = this; at->parent; at = at->parent) steps.push_back(at);
    std::string out;
    for (auto step = steps.rbegin(); step != steps.rend(); ++step)
        out += "/" +
               ((*step)->key.data() ? escapedToken((*step)->key) : std::to_string((*step)->index));
    return out;
}

bool NameIndex::add(std::string_view name, std::uint32_t id) {
    names_.push_back(name);
    return ids_.emplace(name, id).second;
}

std::uint32_t NameIndex::find(std::string_view name) const {
    const auto found = ids_.find(name);
    return found == ids_.end() ? 0 : found->second;
}

void FieldReader::fail(const JsonPath& at, std::string message, std::string remedy) {
    errors_.push_back(
        {.message = std::move(message), .pointer = at.pointer(), .remedy = std::move(remedy)});
}

std::string FieldReader::suggestion(std::string_view wanted,
                                    const std::vector<std::string_view>& known) const {
    constexpr std::size_t kSuggested =
        20;  // Searching names for each of very many errors would take too long.
    constexpr std::size_t kListed = 16;
    const std::string nearest = errors_.size() < kSuggested ? nearestName(wanted, known) : "";
    if (!nearest.empty()) return "did you mean " + inQuotes(nearest) + "?";
    if (known.empty()) return "there is none";
    return known.size() <= kListed ? "known here: " + shortened(joined(known), 300)
                                   : "check the spelling";
}

bool FieldReader::checkKeys(const Json& json, const JsonPath& at,
                            const std::vector<std::string_view>& known) {
    if (!json.is_object()) {
        failType(at, json, "an object", "{...}");
        return false;
    }
    const std::size_t before = errors_.size();
    for (auto it = json.begin(); it != json.end(); ++it)
        if (std::find(known.begin(), known.end(), it.key()) == known.end())
            fail(at.child(std::string_view(it.key())), "unknown field " + inQuotes(it.key()),
                 suggestion(it.key(), known));
    return errors_.size() == before;
}

void FieldReader::failMissing(const JsonPath& at, std::string_view name) {
    fail(at, inQuotes(name) + " is missing", "add it");
}

void FieldReader::failType(const JsonPath& at, const Json& found, std::string_view wanted,
                           std::string_view example) {
    std::string what = found.type_name();
    if (found.is_array()) what = "array of " + std::to_string(found.size());
    fail(at,
         "expected " + std::string(wanted) + ", found " + (found.is_null() ? "" : "a") +
             (found.is_array() || found.is_object() ? "n "
              : found.is_null()                     ? ""
                                                    : " ") +
             what,
         "write it as " + std::string(example));
}

bool FieldReader::checkRange(const JsonPath& at, const FieldMeta& meta, double value) {
    const bool low = meta.exclusiveMin ? value <= meta.min : value < meta.min;
    if (!low && value <= meta.max) return true;
    std::string allowed = meta.exclusiveMin ? "above " : "at least ";
    allowed = meta.min > -kInfinity ? allowed + numberText(meta.min) : "";
    if (meta.max < kInfinity)
        allowed += (allowed.empty() ? "at most " : " and at most ") + numberText(meta.max);
    fail(at, numberText(value) + (low ? " is too small" : " is too large"),
         "use a number " + allowed);
    return false;
}

std::optional<double> FieldReader::number(const Json& json, const JsonPath& at) {
    if (json.is_number() && std::isfinite(json.get<double>())) return json.get<double>();
    failType(at, json, "a number", "1.5");
    return std::nullopt;
}

void FieldReader::read(const Json& json, const FieldMeta& meta, const JsonPath& at, double& out) {
    const auto value = number(json, at);
    if (value && checkRange(at, meta, *value)) out = *value;
}

void FieldReader::read(const Json& json, const FieldMeta& meta, const JsonPath& at, int& out) {
    const auto value = number(json, at);
    if (!value) return;
    if (*value != std::floor(*value))
        return fail(at, "expected a whole number, found " + numberText(*value), "round it");
    FieldMeta bounded = meta;
    bounded.min = std::max(meta.min, static_cast<double>(std::numeric_limits<int>::min()));
    bounded.max = std::min(meta.max, static_cast<double>(std::numeric_limits<int>::max()));
    if (checkRange(at, bounded, *value)) out = static_cast<int>(*value);
}

void FieldReader::read(const Json& json, const FieldMeta&, const JsonPath& at, bool& out) {
    if (json.is_boolean())
        out = json.get<bool>();
    else
        failType(at, json, "true or false", "true");
}

void FieldReader::read(const Json& json, const FieldMeta& meta, const JsonPath& at,
                       std::string& out) {
    if (!json.is_string())
        failType(at, json, "a text", "\"text\"");
    else if (meta.required && json.get_ref<const std::string&>().empty())
        fail(at, "is empty", "write some text");
    else
        out = json.get<std::string>();
}

template <std::size_t N>
bool FieldReader::readNumbers(const Json& json, const FieldMeta& meta, const JsonPath& at,
                              std::array<double, N>& out, std::string_view wanted,
                              std::string_view example) {
    if (!json.is_array() || json.size() != N) {
        failType(at, json, wanted, example);
        return false;
    }
    for (std::size_t i = 0; i < N; ++i) {
        const auto value = number(json[i], at.child(i));
        if (!value || !checkRange(at.child(i), meta, *value)) return false;
        out[i] = *value;
    }
    return true;
}

void FieldReader::read(const Json& json, const FieldMeta& meta, const JsonPath& at, Color& out) {
    FieldMeta bounded = meta;
    bounded.max = std::min(meta.max, kLargestColor);
    std::array<double, 3> v{};
    if (readNumbers(json, bounded, at, v, "a colour of three numbers", "[1, 0.5, 0]"))
        out = {v[0], v[1], v[2]};
}

void FieldReader::read(const Json& json, const FieldMeta& meta, const JsonPath& at, DVec2& out) {
    std::array<double, 2> v{};
    if (readNumbers(json, meta, at, v, "two numbers", "[1, 2]")) out = {v[0], v[1]};
}

void FieldReader::read(const Json& json, const FieldMeta& meta, const JsonPath& at, DVec3& out) {
    std::array<double, 3> v{};
    if (readNumbers(json, meta, at, v, "three numbers", "[1, 2, 3]")) out = {v[0], v[1], v[2]};
}

void FieldReader::read(const Json& json, const FieldMeta& meta, const JsonPath& at,
                       std::array<double, 12>& out) {
    std::array<double, 12> v{};
    if (readNumbers(json, meta, at, v, "twelve numbers",
                    "the three rows of a 3 x 4 matrix, one after the other"))
        out = v;
}

void FieldReader::read(const Json& json, const FieldMeta& meta, const JsonPath& at,
                       std::vector<Color>& out) {
    if (!json.is_array()) return failType(at, json, "a list of colours", "[[1, 1, 1], [0, 0, 0]]");
    out.assign(json.size(), {});
    for (std::size_t i = 0; i < json.size(); ++i) read(json[i], meta, at.child(i), out[i]);
}

std::uint32_t FieldReader::reference(const Json& json, const JsonPath& at, const NameIndex& names,
                                     std::string_view what) {
    if (!json.is_string()) {
        failType(at, json, "the name of a " + std::string(what), "\"name\"");
        return 0;
    }
    const std::string& name = json.get_ref<const std::string&>();
    const std::uint32_t id = names.find(name);
    if (id == 0)
        fail(at, "there is no " + std::string(what) + " " + inQuotes(name),
             suggestion(name, names.names()));
    return id;
}

void FieldReader::read(const Json& json, const FieldMeta&, const JsonPath& at, MaterialId& out) {
    out = {reference(json, at, names_.materials, "material")};
}

void FieldReader::read(const Json& json, const FieldMeta&, const JsonPath& at, GroupId& out) {
    out = {reference(json, at, names_.groups, "group")};
}

void FieldReader::read(const Json& json, const FieldMeta&, const JsonPath& at, CameraId& out) {
    out = {reference(json, at, names_.cameras, "camera")};
}

void FieldReader::read(const Json& json, const FieldMeta&, const JsonPath& at, MixPart& out) {
    if (json == "clear")
        out = {{}, true};
    else
        out = {{reference(json, at, names_.materials, "material")}, false};
}

void FieldReader::read(const Json& json, const FieldMeta&, const JsonPath& at, Transform& out) {
    readFields(json, at, out, {});
    if (json.is_object() && json.contains("matrix") && json.size() > 1)
        fail(at, "\"matrix\" stands beside other fields", "keep the matrix alone, or remove it");
}

void FieldReader::readTextureName(const Json& json, const JsonPath& at, TextureId& out) {
    if (!checkKeys(json, at, {"texture"})) return;
    const auto name = json.find("texture");
    if (name == json.end()) return failMissing(at, "texture");
    out = {reference(*name, at.child("texture"), names_.textures, "texture")};
}

std::optional<std::size_t> FieldReader::choice(const Json& json, const JsonPath& at,
                                               const std::vector<std::string_view>& known) {
    if (!json.is_string()) {
        failType(at, json, "one of " + joined(known), inQuotes(known.front()));
        return std::nullopt;
    }
    const std::string& name = json.get_ref<const std::string&>();
    const auto found = std::find(known.begin(), known.end(), name);
    if (found != known.end()) return static_cast<std::size_t>(found - known.begin());
    fail(at, inQuotes(name) + " is not known", suggestion(name, known));
    return std::nullopt;
}

std::optional<std::string> FieldReader::readKindName(const Json& json, const JsonPath& at,
                                                     const std::vector<std::string_view>& kinds) {
    if (!json.is_object()) {
        failType(at, json, "an object", "{\"type\": " + inQuotes(kinds.front()) + "}");
        return std::nullopt;
    }
    const auto type = json.find("type");
    if (type == json.end()) {
        fail(at, "\"type\" is missing", "add one of " + joined(kinds));
        return std::nullopt;
    }
    const auto chosen = choice(*type, at.child("type"), kinds);
    return chosen ? std::optional(std::string(kinds[*chosen])) : std::nullopt;
}

}  // namespace glint
