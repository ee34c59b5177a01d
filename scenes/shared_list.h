// SPDX-License-Identifier: Apache-2.0
#pragma once
// A list that all copies of its owner hold together, until one of them edits it: every camera and light of a scene sees the
// same geometry in memory.

#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace umbrameter {

template <class T>
class SharedList {
 public:
  using value_type = T;
  using const_iterator = const T*;

  SharedList() : items_(none()) {}
  SharedList(std::vector<T> items) : items_(std::make_shared<std::vector<T>>(std::move(items))) {}
  SharedList(std::initializer_list<T> items) : SharedList(std::vector<T>(items)) {}

  size_t size() const { return items_->size(); }
  bool empty() const { return items_->empty(); }
  const T* data() const { return items_->data(); }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size(); }
  const T& operator[](size_t i) const { return (*items_)[i]; }
  const T& at(size_t i) const { return items_->at(i); }
  const T& back() const { return items_->back(); }
  bool operator==(const SharedList& other) const { return *items_ == *other.items_; }

  /// To change it: others that hold the list keep theirs as it is. Not while another thread copies this.
  std::vector<T>& edit() {
    if (items_.use_count() > 1) items_ = std::make_shared<std::vector<T>>(*items_);
    return *items_;
  }
  /// Whether both are one list in memory.
  bool is_one_with(const SharedList& other) const { return items_ == other.items_; }

 private:
  static const std::shared_ptr<std::vector<T>>& none() {
    static const auto kNone = std::make_shared<std::vector<T>>();
    return kNone;
  }

  std::shared_ptr<std::vector<T>> items_;  // never null: moving copies the pointer
};

}  // namespace umbrameter
