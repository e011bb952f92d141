// Writing JSON, and the small text tools of error messages.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "tracer/io/json_text.h"

namespace glint {

namespace {

/// A value stays on one line up to this many bytes.
constexpr std::size_t kLineLength = 110;

void appendDouble(std::string& out, double value) {
    if (!std::isfinite(value)) {
        out += "null";
    } else if (value == 0 && std::signbit(value)) {
        out += "-0.0";  // "-0" would be read as an integer, which has no sign of zero.
    } else {
        std::array<char, 32> digits{};
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
        out.append(digits.data(), end);
    }
}

void appendString(std::string& out, const std::string& value) {
    out += Json(value).dump(-1, ' ', false, Json::error_handler_t::replace);
}

void appendScalar(std::string& out, const Json& json) {
    if (json.is_number_float())
        appendDouble(out, json.get<double>());
    else if (json.is_string())
        appendString(out, json.get_ref<const std::string&>());
    else
        out += json.dump();
}

/// On one line. False, with the rest missing, once `out` has grown beyond `limit`.
bool appendLine(std::string& out, const Json& json, std::size_t limit) {
    if (!json.is_structured()) {
        appendScalar(out, json);
        return out.size() <= limit;
    }
    out += json.is_array() ? '[' : '{';
    bool first = true;
    for (auto it = json.begin(); it != json.end(); ++it) {
        if (!first) out += ", ";
        first = false;
        if (json.is_object()) appendString(out, it.key()), out += ": ";
        if (!appendLine(out, *it, limit)) return false;
    }
    out += json.is_array() ? ']' : '}';
    return out.size() <= limit;
}

void appendValue(std::string& out, const Json& json, std::size_t indent) {
    const std::size_t before = out.size();
    const std::size_t lineStart = out.rfind('\n') + 1;
    const bool top = indent == 0;
    if (!json.is_structured() || json.empty() ||
        (!top && appendLine(out, json, lineStart + kLineLength))) {
        if (out.size() == before) appendLine(out, json, std::string::npos);
        return;
    }
    out.resize(before);
    out += json.is_array() ? "[\n" : "{\n";
    bool first = true;
    for (auto it = json.begin(); it != json.end(); ++it) {
        if (!first) out += ",\n";
        first = false;
        out.append(indent + 2, ' ');
        if (json.is_object()) appendString(out, it.key()), out += ": ";
        appendValue(out, *it, indent + 2);
    }
    out += '\n';
    out.append(indent, ' ');
    out += json.is_array() ? ']' : '}';
}

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Optimal string alignment distance.
std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> twoUp, up(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) up[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = lower(a[i - 1]) == lower(b[j - 1]);
            row[j] = std::min({up[j] + 1, row[j - 1] + 1, up[j - 1] + (same ? 0U : 1U)});
            if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
                lower(a[i - 2]) == lower(b[j - 1]))
                row[j] = std::min(row[j], twoUp[j - 2] + 1);
        }
        twoUp = std::exchange(up, row);
    }
    return up[b.size()];
}

/// Bytes of the control character that `text` begins with, 0 for any other: ASCII's, and those that
/// turn the direction of the text around them (U+200E, U+200F, U+202A to U+202E, U+2066 to U+2069).
std::size_t controlAt(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
    };
    if (byte(0) < 0x20 || byte(0) == 0x7F) return 1;
    if (byte(0) != 0xE2) return 0;
    const bool turns = (byte(1) == 0x80 && (byte(2) == 0x8E || byte(2) == 0x8F)) ||
                       (byte(1) == 0x80 && byte(2) >= 0xAA && byte(2) <= 0xAE) ||
                       (byte(1) == 0x81 && byte(2) >= 0xA6 && byte(2) <= 0xA9);
    return turns ? 3 : 0;
}

}  // namespace

std::string formatJson(const Json& json) {
    std::string out;
    appendValue(out, json, 0);
    out += '\n';
    return out;
}

std::string formatJsonLine(const Json& json) {
    std::string out;
    appendLine(out, json, std::string::npos);
    return out;
}

std::string escapedToken(std::string_view token) {
    std::string out;
    for (const char c : token) {
        if (c == '~')
            out += "~0";
        else if (c == '/')
            out += "~1";
        else
            out += c;
    }
    return out;
}

std::vector<std::string> pointerTokens(std::string_view pointer) {
    std::vector<std::string> out;
    for (std::size_t i = 0; i < pointer.size(); ++i) {
        if (pointer[i] == '/') {
            out.emplace_back();
        } else if (!out.empty()) {
            const bool escape = pointer[i] == '~' && i + 1 < pointer.size() &&
                                (pointer[i + 1] == '0' || pointer[i + 1] == '1');
            out.back() += escape ? (pointer[++i] == '0' ? '~' : '/') : pointer[i];
        }
    }
    return out;
}

std::string shortened(std::string_view text, std::size_t limit) {
    std::size_t length = std::min(text.size(), limit);
    const auto continues = [&](std::size_t i) {
        return (static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80U;
    };
    while (length > 0 && length < text.size() && continues(length)) --length;
    std::string out;
    std::size_t i = 0;
    while (i < length) {
        const std::size_t control = controlAt(text.substr(i));
        out += control > 0 ? '?' : text[i];
        i += std::max<std::size_t>(1, control);
    }
    return i < text.size() ? out + "..." : out;
}

std::string inQuotes(std::string_view text) { return '"' + shortened(text) + '"'; }

std::string nearestName(std::string_view wanted, const std::vector<std::string_view>& names) {
    constexpr std::size_t kLongest = 64;  // Bounds the work; nobody misspells a longer name.
    if (wanted.size() > kLongest) return {};
    std::string_view best;
    std::size_t bestDistance = wanted.size() < 4 ? 2 : wanted.size() / 3 + 2;
    for (const std::string_view name : names) {
        if (name.size() > kLongest) continue;
        const std::size_t distance = editDistance(wanted, name);
        if (distance < bestDistance) best = name, bestDistance = distance;
    }
    return std::string(best);
}

}  // namespace glint
