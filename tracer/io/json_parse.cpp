// Parsing: the JSON library's event parser feeding a builder that also refuses duplicate keys and
// deep nesting, which the library's own builder lets pass.
#include <algorithm>
#include <iterator>
#include <unordered_set>

#include "tracer/io/json_text.h"

namespace glint {

namespace {

/// A text iterator that tells how far the parser has read.
class TrackedIterator {
  public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    TrackedIterator(const char* at, const char** reached) : at_(at), reached_(reached) {}
    reference operator*() const { return *at_; }
    TrackedIterator& operator++() {
        *reached_ = ++at_;
        return *this;
    }
    bool operator==(const TrackedIterator& other) const { return at_ == other.at_; }

  private:
    const char* at_;
    const char** reached_;
};

/// Builds the value. Holds the first error; the parser stops there.
class Builder {
  public:
    Builder(std::string_view text, const std::string& file)
        : text_(text), file_(file), reached_(text.data()) {}

    TrackedIterator begin() { return {text_.data(), &reached_}; }
    TrackedIterator end() { return {text_.data() + text_.size(), &reached_}; }

    // The library's event interface; each returns false to stop.
    bool null() { return put(nullptr); }
    bool boolean(bool value) { return put(value); }
    bool number_integer(Json::number_integer_t value) { return put(value); }
    bool number_unsigned(Json::number_unsigned_t value) { return put(value); }
    bool number_float(Json::number_float_t value, const std::string&) { return put(value); }
    bool string(std::string& value) { return put(std::move(value)); }
    bool binary(Json::binary_t&) { return false; }
    bool start_object(std::size_t) { return open(Json::object()); }
    bool start_array(std::size_t) { return open(Json::array()); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }

    bool key(std::string& name) {
        if (!isNew(name)) return duplicate(name);
        levels_.back().key = std::move(name);
        return true;
    }

    bool parse_error(std::size_t position, const std::string&,
                     const nlohmann::detail::exception& problem) {
        error_.message = syntaxMessage(problem.what());
        error_.remedy = "correct the JSON here: text in double quotes, finite numbers, no comments";
        place(position > 0 ? position - 1 : 0);
        return false;
    }

    [[nodiscard]] Json takeValue() { return std::move(root_); }
    [[nodiscard]] Error takeError() { return std::move(error_); }

  private:
    /// Objects with more keys than this keep a set of them; smaller ones are searched.
    static constexpr std::size_t kSearched = 16;

    struct Level {
        Json* value;
        std::string key;  ///< of the member being read
        std::unordered_set<std::string> keys;
    };

    Json* add(Json value) {
        if (levels_.empty()) return &(root_ = std::move(value));
        Level& level = levels_.back();
        if (level.value->is_array())
            return &level.value->get_ref<Json::array_t&>().emplace_back(std::move(value));
        // The object's own insertion would search its keys again.
        std::vector<std::pair<const std::string, Json>>& members =
            level.value->get_ref<Json::object_t&>();
        return &members.emplace_back(std::move(level.key), std::move(value)).second;
    }

    bool put(Json value) {
        add(std::move(value));
        return true;
    }

    bool open(Json empty) {
        if (levels_.size() == kMaxJsonDepth) {
            error_.message = "nested deeper than " + std::to_string(kMaxJsonDepth) + " levels";
            error_.remedy = "a scene needs fewer than ten";
            place(offset() - 1);
            return false;
        }
        levels_.push_back({add(std::move(empty)), {}, {}});
        return true;
    }

    bool close() {
        levels_.pop_back();
        return true;
    }

    bool isNew(const std::string& name) {
        Level& level = levels_.back();
        const auto& members = level.value->get_ref<Json::object_t&>();
        if (members.size() < kSearched)
            return std::none_of(members.begin(), members.end(),
                                [&](const auto& m) { return m.first == name; });
        if (level.keys.empty())
            for (const auto& member : members) level.keys.insert(member.first);
        return level.keys.insert(name).second;
    }

    bool duplicate(const std::string& name) {
        std::string pointer;
        for (std::size_t i = 0; i + 1 < levels_.size(); ++i)
            pointer += "/" + lastToken(*levels_[i].value);
        error_.pointer = shortened(pointer + "/" + escapedToken(name), kPointerShown);
        error_.message = "the key " + inQuotes(name) + " stands twice in one object";
        error_.remedy = "keep one of the two";
        const std::size_t value = text_.find_first_not_of(" \t\r\n:", offset());
        place(std::min(value, text_.size()));
        return false;
    }

    /// The token of the newest member of a container.
    static std::string lastToken(const Json& container) {
        if (container.is_array()) return std::to_string(container.size() - 1);
        return escapedToken(container.get_ref<const Json::object_t&>().back().first);
    }

    [[nodiscard]] std::size_t offset() const {
        return static_cast<std::size_t>(reached_ - text_.data());
    }

    void place(std::size_t at) {
        const TextPlace found = placeAt(text_, at);
        error_.file = file_;
        error_.line = found.line;
        error_.column = found.column;
    }

    /// The library's message without its number, its own place and the bytes it had read.
    static std::string syntaxMessage(std::string_view what) {
        const std::size_t bracket = what.find("] ");
        if (bracket != std::string_view::npos) what.remove_prefix(bracket + 2);
        if (what.starts_with("parse error")) {
            const std::size_t colon = what.find(": ");
            if (colon != std::string_view::npos) what.remove_prefix(colon + 2);
        }
        return shortened(what.substr(0, what.find("; last read")), 160);
    }

    std::string_view text_;
    const std::string& file_;
    const char* reached_;
    Json root_;
    std::vector<Level> levels_;
    Error error_;
};

}  // namespace

Result<Json> parseJson(std::string_view text, const std::string& file) {
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
        return Error{.message = "the file is empty",
                     .file = file,
                     .remedy = "a scene begins with {\"glint\": 1"};
    Builder builder(text, file);
    if (!Json::sax_parse(builder.begin(), builder.end(), &builder)) return builder.takeError();
    return builder.takeValue();
}

}  // namespace glint
