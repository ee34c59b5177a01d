// SPDX-License-Identifier: Apache-2.0
#pragma once
// A store that is made when the first thing is put into it, so that a run that ends before leaves nothing behind.

#include "store/store.h"

#include <memory>
#include <string>
#include <vector>

namespace umbrameter {

class LazyStore {
 public:
  /// Opens the store in `folder` if there is one.
  explicit LazyStore(std::filesystem::path folder) : folder_(std::move(folder)) {
    if (has_store(folder_)) store();
  }

  bool exists() const { return store_ != nullptr; }

  std::optional<std::string> find(const std::string& key) {
    return store_ ? store_->find(key) : std::nullopt;
  }

  /// Made when there is none.
  Store& store() {
    if (!store_) store_ = std::make_unique<Store>(folder_, Database::Mode::write);
    return *store_;
  }

  std::vector<std::string> take_warnings() {
    return store_ ? store_->take_warnings() : std::vector<std::string>();
  }

 private:
  std::filesystem::path folder_;
  std::unique_ptr<Store> store_;
};

}  // namespace umbrameter
