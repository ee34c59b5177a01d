// SPDX-License-Identifier: Apache-2.0
#pragma once
// What was made last and may be wanted again, within a budget of memory.

#include <cstddef>
#include <list>
#include <memory>
#include <string>

namespace umbrameter {

template <typename T>
class RecentlyUsed {
 public:
  explicit RecentlyUsed(size_t budget_bytes) : budget_bytes_(budget_bytes) {}

  /// Null when it is not there.
  std::shared_ptr<const T> find(const std::string& key) {
    for (auto entry = entries_.begin(); entry != entries_.end(); ++entry) {
      if (entry->key != key) continue;
      entries_.splice(entries_.begin(), entries_, entry);
      return entries_.front().value;
    }
    return nullptr;
  }

  /// Lets go of what was not used for longest until `bytes` more fit; of everything when they never do. To be called before
  /// they are allocated.
  void make_room(size_t bytes) {
    while (!entries_.empty() && bytes_ + bytes > budget_bytes_) {
      bytes_ -= entries_.back().bytes;
      entries_.pop_back();
    }
  }

  void keep(const std::string& key, std::shared_ptr<const T> value, size_t bytes) {
    entries_.push_front({key, std::move(value), bytes});
    bytes_ += bytes;
  }

 private:
  struct Entry {
    std::string key;
    std::shared_ptr<const T> value;
    size_t bytes = 0;
  };
  size_t budget_bytes_;
  size_t bytes_ = 0;
  std::list<Entry> entries_;  // the last used first
};

}  // namespace umbrameter
