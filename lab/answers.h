// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a verb found out piece by piece (a case, a trial, a cell), kept in a store under what determines it: a verb that is asked
// again, or was killed, reads it. Not here: truths (lab/stored_reference.h) and runs (lab/validation_cache.h).

#include "store/lazy_store.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <functional>
#include <string>

namespace umbrameter {

class Answers {
 public:
  /// Keeps nothing.
  Answers() = default;
  /// Without `reuse` nothing is found, and everything is kept. The store must outlive it.
  Answers(LazyStore& store, bool reuse) : store_(&store), reuse_(reuse) {}

  bool keeps() const { return store_ != nullptr; }

  /// Whether something is kept under the key that `read` understands: what throws nlohmann::json::exception is of another
  /// version.
  bool find(const std::string& key, const std::function<void(const nlohmann::json&)>& read);

  void keep(const std::string& key, const nlohmann::ordered_json& answer);

  /// How many were found, since it was last asked.
  size_t take_reused();

 private:
  LazyStore* store_ = nullptr;
  bool reuse_ = false;
  size_t reused_ = 0;
};

}  // namespace umbrameter
