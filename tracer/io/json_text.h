// JSON as text: strict parsing with places for errors, and the layout in which Glint writes. Knows
// nothing of scenes. Internal to io/: nothing outside it includes the JSON library.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "tracer/base/result.h"

namespace glint {

/// Keeps the order of keys.
using Json = nlohmann::ordered_json;

/// Deepest nesting that parseJson() accepts; everything that walks a Json may therefore recurse.
inline constexpr std::size_t kMaxJsonDepth = 128;

/// Error messages show at most this much of a pointer.
inline constexpr std::size_t kPointerShown = 200;

/// Parses RFC 8259 JSON (a UTF-8 byte order mark is skipped). Errors: syntax, invalid UTF-8,
/// numbers beyond a double, text after the end, a key twice in one object, nesting deeper than
/// kMaxJsonDepth. `file` only names it in errors.
[[nodiscard]] Result<Json> parseJson(std::string_view text, const std::string& file);

/// 1-based line and column (in characters) of a byte of `text`.
struct TextPlace {
    int line = 0, column = 0;
};
[[nodiscard]] TextPlace placeAt(std::string_view text, std::size_t offset);

/// Where the values at JSON pointers begin in `text`, in the order of `pointers`, found in one pass
/// over the text. For a value that is not there, the place of the innermost one that would hold it.
/// `text` must be valid JSON.
[[nodiscard]] std::vector<TextPlace> placesOf(std::string_view text,
                                              const std::vector<std::string>& pointers);

/// The text of a value: one line where that is short, else one entry a line, indented by two
/// spaces. Numbers are in the shortest form that reads back as the same double.
[[nodiscard]] std::string formatJson(const Json& json);
/// The same on one line, whatever its length.
[[nodiscard]] std::string formatJsonLine(const Json& json);

/// One reference token of a JSON pointer with ~ and / escaped (RFC 6901).
[[nodiscard]] std::string escapedToken(std::string_view token);
/// The tokens of a JSON pointer, unescaped; "/a/b" has two.
[[nodiscard]] std::vector<std::string> pointerTokens(std::string_view pointer);

/// `text` fit for an error message: control characters, also those that turn the direction of text,
/// as '?', at most `limit` bytes with "..." behind, never half a character.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t limit = 60);
/// shortened() in double quotes.
[[nodiscard]] std::string inQuotes(std::string_view text);

/// The name nearest to `wanted` by edits (letters put in, left out, changed or swapped; case is
/// ignored), if one is near enough to be a misspelling of it; else empty.
[[nodiscard]] std::string nearestName(std::string_view wanted,
                                      const std::vector<std::string_view>& names);

}  // namespace glint
