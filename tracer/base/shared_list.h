// SharedList<T>: a list that does not change, and whose copies are the same list.
#pragma once

#include <memory>
#include <utility>
#include <vector>

namespace glint {

template <class T>
class SharedList {
  public:
    SharedList() : SharedList(std::vector<T>()) {}
    // A vector is a list that has not been shared yet.
    SharedList(std::vector<T> values)
        : list_(std::make_shared<const std::vector<T>>(std::move(values))) {}

    [[nodiscard]] const T& operator[](std::size_t i) const { return (*list_)[i]; }
    [[nodiscard]] std::size_t size() const { return list_->size(); }
    [[nodiscard]] bool empty() const { return list_->empty(); }
    [[nodiscard]] auto begin() const { return list_->begin(); }
    [[nodiscard]] auto end() const { return list_->end(); }
    operator const std::vector<T>&() const { return *list_; }

  private:
    std::shared_ptr<const std::vector<T>> list_;
};

}  // namespace glint
