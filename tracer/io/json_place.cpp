// Places: byte -> line and column, and JSON pointer -> place. Pointers are looked up only once
// something is wrong, so that reading a good file pays nothing for them.
#include <algorithm>
#include <unordered_map>

#include "tracer/io/json_text.h"

namespace glint {

namespace {

/// Walks over valid JSON and notes where the wanted values begin. A stack of its own: no recursion.
class PointerScanner {
  public:
    PointerScanner(std::string_view text, const std::vector<std::string>& pointers) : text_(text) {
        for (std::string pointer : pointers)
            while (offsets_.emplace(pointer, std::string_view::npos).second && !pointer.empty())
                pointer = parentOf(pointer);
    }

    void run() {
        skipSpace();
        value();
        while (!levels_.empty() && at_ < text_.size()) {
            skipSpace();
            const char c = at_ < text_.size() ? text_[at_] : ']';
            if (c == ']' || c == '}') {
                ++at_;
                levels_.pop_back();
            } else if (c == ',') {
                ++at_;
            } else {
                member(levels_.back());
            }
        }
    }

    /// Where the value begins, or else the innermost one around its place.
    [[nodiscard]] std::size_t offset(std::string pointer) const {
        while (offsets_.at(pointer) == std::string_view::npos && !pointer.empty())
            pointer = parentOf(pointer);
        return offsets_.at(pointer);
    }

  private:
    struct Level {
        bool array;
        std::size_t next;        ///< index of the next element
        std::size_t pathLength;  ///< of the container itself
    };

    static std::string parentOf(const std::string& pointer) {
        return pointer.substr(0, pointer.rfind('/'));
    }

    void member(Level& level) {
        path_.resize(level.pathLength);
        path_ += '/';
        if (level.array) {
            path_ += std::to_string(level.next++);
        } else {
            path_ += escapedToken(key());
            at_ = std::min(text_.find(':', at_), text_.size() - 1) + 1;
            skipSpace();
        }
        value();
    }

    void value() {
        if (const auto wanted = offsets_.find(path_); wanted != offsets_.end())
            wanted->second = at_;
        if (at_ >= text_.size()) return;
        const char c = text_[at_];
        if (c == '{' || c == '[') {
            levels_.push_back({c == '[', 0, path_.size()});
            ++at_;
        } else if (c == '"') {
            skipString();
        } else {
            at_ = std::min(text_.find_first_of(",]} \t\r\n", at_), text_.size());
        }
    }

    std::string key() {
        const std::size_t begin = at_;
        skipString();
        const std::string_view token = text_.substr(begin, at_ - begin);
        if (token.find('\\') == std::string_view::npos)
            return std::string(token.substr(1, token.size() - 2));
        const Json decoded = Json::parse(token, nullptr, false);
        return decoded.is_string() ? decoded.get<std::string>() : std::string(token);
    }

    void skipString() {
        for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_)
            if (text_[at_] == '\\') ++at_;
        at_ = std::min(at_ + 1, text_.size());
    }

    void skipSpace() {
        if (at_ == 0 && text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
        at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::string path_;
    std::vector<Level> levels_;
    std::unordered_map<std::string, std::size_t> offsets_;
};

bool beginsCharacter(char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }

/// Counts lines and columns while it goes forward through a text.
class PlaceCounter {
  public:
    explicit PlaceCounter(std::string_view text) : text_(text) {}

    /// The place of `offset`, which is not before the last one asked for.
    TextPlace at(std::size_t offset) {
        for (; offset_ < offset; ++offset_) {
            if (text_[offset_] == '\n')
                place_ = {place_.line + 1, 1};
            else if (beginsCharacter(text_[offset_]))
                ++place_.column;
        }
        return place_;
    }

  private:
    std::string_view text_;
    std::size_t offset_ = 0;
    TextPlace place_{1, 1};
};

}  // namespace

TextPlace placeAt(std::string_view text, std::size_t offset) {
    return PlaceCounter(text).at(std::min(offset, text.size()));
}

std::vector<TextPlace> placesOf(std::string_view text, const std::vector<std::string>& pointers) {
    PointerScanner scanner(text, pointers);
    scanner.run();
    std::vector<std::pair<std::size_t, std::size_t>> order;  // Offset, index in `pointers`.
    for (std::size_t i = 0; i < pointers.size(); ++i)
        order.emplace_back(scanner.offset(pointers[i]), i);
    std::sort(order.begin(), order.end());
    std::vector<TextPlace> out(pointers.size());
    PlaceCounter counter(text);
    for (const auto& [offset, index] : order)
        if (offset != std::string_view::npos) out[index] = counter.at(offset);
    return out;
}

}  // namespace glint
