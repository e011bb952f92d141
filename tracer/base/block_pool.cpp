#include "tracer/base/block_pool.h"

#include <sys/mman.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>

namespace glint {

namespace {

constexpr std::size_t kHugePage = std::size_t{2} << 20, kPage = 4096, kAlignment = 64;

std::size_t roundUp(std::size_t bytes, std::size_t to) { return (bytes + to - 1) / to * to; }

/// Fresh pages; of a huge page's bytes or more, ones that begin at such. Null if there are none.
std::byte* mapPages(std::size_t bytes) {
    const std::size_t spare = bytes >= kHugePage ? kHugePage : 0;
    void* const mapped =
        mmap(nullptr, bytes + spare, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (mapped == MAP_FAILED) return nullptr;
    auto* const start = static_cast<std::byte*>(mapped);
    if (spare == 0) return start;
    const std::size_t before = roundUp(reinterpret_cast<std::uintptr_t>(start), kHugePage) -
                               reinterpret_cast<std::uintptr_t>(start);
    if (before > 0) munmap(start, before);
    if (before < spare) munmap(start + before + bytes, spare - before);
    // What the system answers changes the speed alone: a huge page comes sooner than its many small
    // ones.
    madvise(start + before, bytes, MADV_HUGEPAGE);
    return start + before;
}

}  // namespace

BlockPool::BlockPool(std::size_t blockBytes, std::size_t expected)
    : blockBytes_(roundUp(std::max(blockBytes, sizeof(Free)), kAlignment)),
      slabBytes_(
          roundUp(std::max(blockBytes_, std::min(kHugePage, blockBytes_ * expected)), kPage)) {}

BlockPool::~BlockPool() {
    for (void* slab : slabs_) munmap(slab, slabBytes_);
}

void* BlockPool::take() {
    const std::scoped_lock lock(mutex_);
    if (!free_) grow();
    Free* const block = free_;
    free_ = block->next;
    --freeCount_;
    return block;
}

void BlockPool::give(void* block) {
    const std::scoped_lock lock(mutex_);
    free_ = new (block) Free{free_};
    ++freeCount_;
}

void BlockPool::reserve(std::size_t blocks) {
    const std::scoped_lock lock(mutex_);
    if (freeCount_ < blocks) grow();
}

void BlockPool::grow() {
    slabs_.reserve(slabs_.size() + 1);
    std::byte* const slab = mapPages(slabBytes_);
    if (!slab) throw std::bad_alloc();
    slabs_.push_back(slab);
    // A wish: an older kernel gives page by page what is touched.
    madvise(slab, slabBytes_, MADV_POPULATE_WRITE);
    const std::size_t blocks = slabBytes_ / blockBytes_;
    for (std::size_t i = blocks; i-- > 0;) free_ = new (slab + i * blockBytes_) Free{free_};
    freeCount_ += blocks;
}

}  // namespace glint
