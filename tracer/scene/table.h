// Table<T>: the document's containers. Values by id in insertion order; copying a table costs a few
// pointers, editing one entry copies one chunk and that entry, and two versions are compared only
// where their chunks differ.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "tracer/base/check.h"
#include "tracer/scene/ids.h"

namespace glint {

template <class T, class IdType>
class Table {
  public:
    /// Appends `value` under a new id.
    IdType add(T value) {
        const IdType id{next_++};
        (*writable(id))[slotOf(id)] = std::make_shared<const T>(std::move(value));
        ++size_;
        return id;
    }

    /// Appends many values under new ids, in order; each chunk is made once.
    void addAll(std::vector<T> values) {
        std::shared_ptr<Chunk> own;
        for (T& value : values) {
            const IdType id{next_++};
            if (!own || slotOf(id) == 0) own = writable(id);
            (*own)[slotOf(id)] = std::make_shared<const T>(std::move(value));
        }
        size_ += values.size();
    }

    /// Puts `value` at an id that is in the table.
    void set(IdType id, T value) {
        GLINT_CHECK(find(id) != nullptr);
        (*writable(id))[slotOf(id)] = std::make_shared<const T>(std::move(value));
    }

    void erase(IdType id) {
        GLINT_CHECK(find(id) != nullptr);
        (*writable(id))[slotOf(id)].reset();
        --size_;
    }

    [[nodiscard]] const T* find(IdType id) const { return shared(id).get(); }

    [[nodiscard]] const T& at(IdType id) const {
        const T* found = find(id);
        GLINT_CHECK(found != nullptr);
        return *found;
    }

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] bool empty() const { return size_ == 0; }

    /// Calls `visit(id, value)` in insertion order.
    template <class Visit>
    void forEach(Visit&& visit) const {
        for (std::size_t c = 0; c < chunks_.size(); ++c) {
            if (!chunks_[c]) continue;
            for (std::size_t s = 0; s < kChunk; ++s)
                if ((*chunks_[c])[s]) visit(idAt(c, s), *(*chunks_[c])[s]);
        }
    }

    [[nodiscard]] std::vector<IdType> ids() const {
        std::vector<IdType> out;
        out.reserve(size_);
        forEach([&](IdType id, const T&) { out.push_back(id); });
        return out;
    }

    /// Calls `visit(id, before, after)` (null where absent) for each entry that is not the same in
    /// both tables.
    template <class Visit>
    static void forEachDifference(const Table& before, const Table& after, Visit&& visit) {
        const std::size_t chunks = std::max(before.chunks_.size(), after.chunks_.size());
        for (std::size_t c = 0; c < chunks; ++c) {
            const Chunk* a = c < before.chunks_.size() ? before.chunks_[c].get() : nullptr;
            const Chunk* b = c < after.chunks_.size() ? after.chunks_[c].get() : nullptr;
            if (a == b) continue;
            for (std::size_t s = 0; s < kChunk; ++s) {
                const T* x = a ? (*a)[s].get() : nullptr;
                const T* y = b ? (*b)[s].get() : nullptr;
                if (x != y && !(x && y && *x == *y)) visit(idAt(c, s), x, y);
            }
        }
    }

    /// Same ids with equal values. The next free id is not part of the value.
    bool operator==(const Table& other) const {
        bool equal = size_ == other.size_;
        if (equal)
            forEachDifference(*this, other, [&](IdType, const T*, const T*) { equal = false; });
        return equal;
    }

  private:
    static constexpr std::size_t kChunk = 64;
    using Chunk = std::array<std::shared_ptr<const T>, kChunk>;

    static std::size_t slotOf(IdType id) { return (id.value - 1) % kChunk; }
    static IdType idAt(std::size_t chunk, std::size_t slot) {
        return IdType{static_cast<std::uint32_t>(chunk * kChunk + slot + 1)};
    }

    [[nodiscard]] const std::shared_ptr<const T>& shared(IdType id) const {
        static const std::shared_ptr<const T> none;
        const std::size_t c = (id.value - 1) / kChunk;
        if (id.value == 0 || c >= chunks_.size() || !chunks_[c]) return none;
        return (*chunks_[c])[slotOf(id)];
    }

    /// A fresh chunk of our own to write to, with what the old one held.
    std::shared_ptr<Chunk> writable(IdType id) {
        const std::size_t c = (id.value - 1) / kChunk;
        if (c >= chunks_.size()) chunks_.resize(c + 1);
        auto own = chunks_[c] ? std::make_shared<Chunk>(*chunks_[c]) : std::make_shared<Chunk>();
        chunks_[c] = own;
        return own;
    }

    std::vector<std::shared_ptr<const Chunk>> chunks_;
    std::uint32_t next_ = 1;
    std::size_t size_ = 0;
};

}  // namespace glint
