// What a leaf works out for each refractive index that can meet it in the scene: when it first
// meets it.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

namespace glint {

/// Values by an index, or by a ratio of two, shared by the copies of a leaf. Each is made by the
/// thread that first asks for it; others that ask meanwhile wait.
template <class T>
class ByIndex {
  public:
    using Make = std::function<T(float index)>;

    ByIndex(std::span<const float> indices, Make make)
        : made_(std::make_shared<Made>(indices, std::move(make))) {}
    /// The value of the nearest index; there must be one.
    [[nodiscard]] const T& nearest(float index) const { return made_->value(*at(index)); }
    /// The value of this index, to a rounding or two; null where it is none of those given.
    [[nodiscard]] const T* find(float index) const {
        constexpr float kSame = 1e-5f;
        Entry* entry = at(index);
        return entry && std::abs(entry->index - index) <= kSame * index ? &made_->value(*entry)
                                                                        : nullptr;
    }

  private:
    struct Entry {
        float index = 0;
        std::once_flag once;  ///< guards `value`
        std::optional<T> value;
    };
    struct Made {
        std::vector<Entry> entries;
        Make make;

        Made(std::span<const float> indices, Make f) : entries(indices.size()), make(std::move(f)) {
            for (std::size_t i = 0; i < indices.size(); ++i) entries[i].index = indices[i];
        }
        const T& value(Entry& entry) {
            std::call_once(entry.once, [&] { entry.value.emplace(make(entry.index)); });
            return *entry.value;
        }
    };
    [[nodiscard]] Entry* at(float index) const {
        Entry* best = nullptr;
        for (Entry& entry : made_->entries)
            if (!best || std::abs(entry.index - index) < std::abs(best->index - index))
                best = &entry;
        return best;
    }

    std::shared_ptr<Made> made_;
};

}  // namespace glint
