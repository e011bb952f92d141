// Result<T>: a value, or an Error that a person can act on. For whatever can be wrong in the world:
// files, fields, flags.
#pragma once

#include <string>
#include <utility>
#include <variant>

#include "tracer/base/check.h"

namespace glint {

/// What is wrong, where, and what to do about it. Parts that do not apply stay empty (line and
/// column 0).
struct Error {
    std::string message;  ///< what is wrong, without a full stop
    std::string file;     ///< path as the person gave it
    int line = 0;         ///< 1-based
    int column = 0;       ///< 1-based
    std::string pointer;  ///< JSON pointer (RFC 6901) of the value at fault
    std::string remedy;   ///< what to do, without a full stop

    bool operator==(const Error&) const = default;

    /// One line: "file:line:column: /pointer: message (remedy)".
    [[nodiscard]] std::string text() const {
        std::string out = file;
        if (line > 0) out += ":" + std::to_string(line);
        if (column > 0) out += ":" + std::to_string(column);
        if (!out.empty()) out += ": ";
        if (!pointer.empty()) out += pointer + ": ";
        out += message;
        if (!remedy.empty()) out += " (" + remedy + ")";
        return out;
    }
};

template <class T>
class [[nodiscard]] Result {
  public:
    Result(T value) : value_(std::move(value)) {}
    Result(Error error) : value_(std::move(error)) {}

    [[nodiscard]] bool ok() const { return std::holds_alternative<T>(value_); }
    explicit operator bool() const { return ok(); }

    [[nodiscard]] const T& value() const& {
        GLINT_CHECK(ok());
        return std::get<T>(value_);
    }
    [[nodiscard]] T&& value() && {
        GLINT_CHECK(ok());
        return std::get<T>(std::move(value_));
    }
    [[nodiscard]] const Error& error() const {
        GLINT_CHECK(!ok());
        return std::get<Error>(value_);
    }

  private:
    std::variant<T, Error> value_;
};

/// For operations that yield nothing but may fail.
struct Done {};
using Status = Result<Done>;

}  // namespace glint
