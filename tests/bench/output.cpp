#include "tests/bench/output.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>

#include "tracer/io/atomic_file.h"

namespace glint::bench {

bool writeText(const std::string& file, const std::string& text) {
    if (file.empty()) return true;
    const Status written = writeWhole(file, text);
    if (!written) complain(written.error(), 0);
    return written.ok();
}

bool writeJson(const std::string& file, const Json& json) {
    return writeText(file, json.dump(2) + '\n');
}

bool canWrite(const std::string& file) {
    if (file.empty()) return true;
    const Status writable = checkWritable(file);
    if (!writable) complain(writable.error(), 0);
    return writable.ok();
}

int complain(const Error& error, int code) {
    std::fprintf(stderr, "glint-bench: %s\n", error.text().c_str());
    return code;
}

std::string format(const char* pattern, ...) {
    va_list arguments;
    va_start(arguments, pattern);
    va_list again;
    va_copy(again, arguments);
    std::string out(static_cast<std::size_t>(std::vsnprintf(nullptr, 0, pattern, arguments)), '\0');
    std::vsnprintf(out.data(), out.size() + 1, pattern, again);
    va_end(again);
    va_end(arguments);
    return out;
}

std::string Table::markdown() const {
    std::vector<std::size_t> widths(rows_.front().size());
    for (const auto& row : rows_)
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    std::string out;
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        for (std::size_t i = 0; i < rows_[r].size(); ++i) {
            const std::string& cell = rows_[r][i];
            const std::string space(widths[i] - cell.size(), ' ');
            out += "| " + (i == 0 ? cell + space : space + cell) + ' ';
        }
        out += "|\n";
        if (r > 0) continue;
        for (std::size_t i = 0; i < widths.size(); ++i)
            out += '|' + std::string(widths[i] + 1, '-') + (i == 0 ? "-" : ":");
        out += "|\n";
    }
    return out;
}

}  // namespace glint::bench
