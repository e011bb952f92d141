// BlockPool: memory for many blocks of one size. It is taken from the system in huge pages where there are any: films are large, and
// the first touch of a page takes longer than a sample. Given back when the pool ends.
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

  private:
    struct Free {
        Free* next;
    };
    void grow();

    std::size_t blockBytes_, slabBytes_;
    std::mutex mutex_;
    Free* free_ = nullptr;
    std::vector<void*> slabs_;
};

}  // namespace glint
