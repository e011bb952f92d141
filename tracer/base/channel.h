// Lock-free hand-over between two threads: Inbox (many writers, one reader takes all) and
// TripleBuffer (one writer, one reader, newest value wins). Neither side ever waits. Nothing here
// wakes anybody: see render/session.h for that.
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <utility>
#include <vector>

namespace glint {

/// A list that any thread may push on and one thread empties with one exchange.
template <class T>
class Inbox {
  public:
    Inbox() = default;
    Inbox(const Inbox&) = delete;
    Inbox& operator=(const Inbox&) = delete;
    ~Inbox() { takeAll(); }

    void push(T value) {
        auto* node = new Node{std::move(value), head_.load(std::memory_order_relaxed)};
        // Release: pairs with the acquire in takeAll, so the reader sees the whole node.
        while (!head_.compare_exchange_weak(node->next, node, std::memory_order_release,
                                            std::memory_order_relaxed)) {
        }
    }

    /// Everything pushed so far, oldest first.
    std::vector<T> takeAll() {
        Node* node = head_.exchange(nullptr, std::memory_order_acquire);
        Node* oldest = nullptr;
        while (node) std::swap(node->next, oldest), std::swap(node, oldest);
        std::vector<T> out;
        while (oldest) {
            std::unique_ptr<Node> owned(oldest);
            out.push_back(std::move(owned->value));
            oldest = owned->next;
        }
        return out;
    }

  private:
    struct Node {
        T value;
        Node* next;
    };
    std::atomic<Node*> head_{nullptr};
};

/// Three slots: the writer fills `back()`, the reader looks at what `take()` gave it, the third is
/// in flight.
template <class T>
class TripleBuffer {
  public:
    /// Writer: the slot to fill. It may hold an old value whose storage can be used again.
    T& back() { return slots_[back_]; }

    /// Writer: makes the back slot the newest one.
    void publish() {
        // Release: the reader sees the slot's content. Acquire: the slot handed back is no longer
        // being read.
        back_ = flight_.exchange(back_ | kFresh, std::memory_order_acq_rel) & kIndex;
    }

    /// Reader: the newest value if there is one it has not seen, else null. Valid until the next
    /// take().
    T* take() {
        if (!(flight_.load(std::memory_order_relaxed) & kFresh)) return nullptr;
        front_ =
            flight_.exchange(front_, std::memory_order_acq_rel) & kIndex;  // Partner: publish().
        return &slots_[front_];
    }

  private:
    static constexpr unsigned kIndex = 3, kFresh = 4;
    std::array<T, 3> slots_{};
    unsigned back_ = 0, front_ = 1;
    std::atomic<unsigned> flight_{2};
};

}  // namespace glint
