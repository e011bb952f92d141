// What a measurement leaves behind: JSON, CSV, tables, plots. All are written whole or not at all,
// with one way to say that it could not be done.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tracer/base/result.h"

namespace glint::bench {

using Json = nlohmann::ordered_json;

/// Writes `text` to `file`; with an empty `file` nothing. False with a message on the error stream
/// where that fails.
[[nodiscard]] bool writeText(const std::string& file, const std::string& text);
/// The same for JSON.
[[nodiscard]] bool writeJson(const std::string& file, const Json& json);

/// Says so before an hour of measuring ends in a file that cannot be written: true if `file`
/// (empty: none) can be opened for writing.
[[nodiscard]] bool canWrite(const std::string& file);

/// Prints the error and answers with `code`.
int complain(const Error& error, int code);

/// printf to a string.
[[nodiscard]] std::string format(const char* pattern, ...) __attribute__((format(printf, 1, 2)));

/// A Markdown table, its columns padded so that it reads well as text too.
class Table {
  public:
    explicit Table(std::vector<std::string> head) : rows_{std::move(head)} {}
    void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
    [[nodiscard]] std::string markdown() const;

  private:
    std::vector<std::vector<std::string>> rows_;
};

}  // namespace glint::bench
