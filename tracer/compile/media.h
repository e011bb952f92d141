// The dielectrics that a path is inside of. Membership changes only when the path crosses a
// surface, and decides which end of a shape's span the path can meet next (shapes/crossing.h), so
// rounding can never turn inside and outside round.
#pragma once

#include <array>
#include <cstdint>

namespace glint {

/// A small set of shape instances in the order of entry. Deeper nesting than kCapacity drops the
/// oldest.
class MediaStack {
  public:
    static constexpr int kCapacity = 16;

    MediaStack() {}  // Not defaulted: the places stay as they are.
    /// Copies what it holds, mostly nothing.
    MediaStack(const MediaStack& other) { *this = other; }
    MediaStack& operator=(const MediaStack& other) {
        count_ = other.count_;
        for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i)
            shapes_[i] = other.shapes_[i];
        return *this;
    }

    [[nodiscard]] bool empty() const { return count_ == 0; }
    [[nodiscard]] int size() const { return count_; }
    [[nodiscard]] std::uint32_t operator[](int i) const {
        return shapes_[static_cast<std::size_t>(i)];
    }
    [[nodiscard]] bool contains(std::uint32_t shape) const {
        for (int i = 0; i < count_; ++i)
            if ((*this)[i] == shape) return true;
        return false;
    }
    /// Enters the shape if outside of it, leaves it if inside.
    void cross(std::uint32_t shape) {
        for (int i = 0; i < count_; ++i)
            if ((*this)[i] == shape) return erase(i);
        if (count_ == kCapacity) erase(0);
        shapes_[static_cast<std::size_t>(count_++)] = shape;
    }

  private:
    void erase(int i) {
        for (--count_; i < count_; ++i) shapes_[static_cast<std::size_t>(i)] = (*this)[i + 1];
    }

    std::array<std::uint32_t, kCapacity> shapes_;  ///< the first count_ are set
    int count_ = 0;
};

}  // namespace glint
