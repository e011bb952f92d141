// BlockPool: memory for many blocks of one size. It is taken from the system many pages at a time:
// films are large, and the first touch of a single page may take longer than a sample. Given back
// when the pool ends.
#pragma once

#include <cstddef>
#include <mutex>
#include <vector>

namespace glint {

class BlockPool {
  public:
    /// For blocks of `blockBytes`, of which about `expected` are wanted.
    BlockPool(std::size_t blockBytes, std::size_t expected);
    ~BlockPool();
    BlockPool(const BlockPool&) = delete;
    BlockPool& operator=(const BlockPool&) = delete;

    /// A block, aligned to 64 bytes, with anything in it. Throws std::bad_alloc. Any thread.
    [[nodiscard]] void* take();
    /// Gives one back. Any thread.
    void give(void* block);
    /// Takes some memory from the system, a part of a millisecond's, if fewer blocks are free than
    /// these. Any thread.
    void reserve(std::size_t blocks);

  private:
    struct Free {
        Free* next;
    };
    void grow();

    std::size_t blockBytes_, slabBytes_;
    std::mutex mutex_;
    Free* free_ = nullptr;
    std::size_t freeCount_ = 0;
    std::vector<void*> slabs_;
};

}  // namespace glint
