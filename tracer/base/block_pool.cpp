#include "tracer/base/block_pool.h"

#include <sys/mman.h>

#include <algorithm>
#include <cstdint>
#include <new>

namespace glint {

namespace {

constexpr std::size_t kHugePage = std::size_t{2} << 20, kAlignment = 64;

std::size_t roundUp(std::size_t bytes, std::size_t to) { return (bytes + to - 1) / to * to; }

/// Starts at a multiple of kHugePage if it is at least so long.
void* mapSlab(std::size_t bytes) {
    const std::size_t spare = bytes < kHugePage ? 0 : kHugePage;
    void* mapped = mmap(nullptr, bytes + spare, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (mapped == MAP_FAILED) throw std::bad_alloc();
    if (spare == 0) return mapped;
    auto* const begin = static_cast<std::byte*>(mapped);
    const std::size_t head = roundUp(reinterpret_cast<std::uintptr_t>(begin), kHugePage) - reinterpret_cast<std::uintptr_t>(begin);
    if (head > 0) munmap(begin, head);
    if (head < spare) munmap(begin + head + bytes, spare - head);
    madvise(begin + head, bytes, MADV_HUGEPAGE);  // A wish: without huge pages it is slower, not wrong.
    return begin + head;
}

}  // namespace

BlockPool::BlockPool(std::size_t blockBytes, std::size_t expected)
    : blockBytes_(roundUp(std::max(blockBytes, sizeof(Free)), kAlignment)),
      slabBytes_(blockBytes_ * std::max<std::size_t>(expected, 1) < kHugePage ? blockBytes_ * std::max<std::size_t>(expected, 1) : roundUp(blockBytes_, kHugePage)) {}

BlockPool::~BlockPool() {
    for (void* slab : slabs_) munmap(slab, slabBytes_);
}

void* BlockPool::take() {
    const std::scoped_lock lock(mutex_);
    if (!free_) grow();
    Free* const block = free_;
    free_ = block->next;
    return block;
}

void BlockPool::give(void* block) {
    const std::scoped_lock lock(mutex_);
    free_ = new (block) Free{free_};
}

void BlockPool::grow() {
    slabs_.reserve(slabs_.size() + 1);
    auto* const slab = static_cast<std::byte*>(mapSlab(slabBytes_));
    slabs_.push_back(slab);
    for (std::size_t i = slabBytes_ / blockBytes_; i-- > 0;) free_ = new (slab + i * blockBytes_) Free{free_};
}

}  // namespace glint
