#include "tracer/base/block_pool.h"

#include <sys/mman.h>

#include <algorithm>
#include <cstddef>
#include <new>

namespace glint {

namespace {

constexpr std::size_t kSlab = std::size_t{512} << 10, kAlignment = 64;

std::size_t roundUp(std::size_t bytes, std::size_t to) { return (bytes + to - 1) / to * to; }

}  // namespace

BlockPool::BlockPool(std::size_t blockBytes, std::size_t expected)
    : blockBytes_(roundUp(std::max(blockBytes, sizeof(Free)), kAlignment)),
      slabBytes_(std::max(blockBytes_, std::min(kSlab, blockBytes_ * expected))) {}

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
    void* const mapped =
        mmap(nullptr, slabBytes_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (mapped == MAP_FAILED) throw std::bad_alloc();
    slabs_.push_back(mapped);
    madvise(mapped, slabBytes_,
            MADV_POPULATE_WRITE);  // A wish: an older kernel gives page by page what is touched.
    auto* const slab = static_cast<std::byte*>(mapped);
    const std::size_t blocks = slabBytes_ / blockBytes_;
    for (std::size_t i = blocks; i-- > 0;) free_ = new (slab + i * blockBytes_) Free{free_};
    freeCount_ += blocks;
}

}  // namespace glint
