// SPDX-License-Identifier: Apache-2.0
#include "lab/answers.h"

#include "results/json/json_optional.h"

#include <nlohmann/json.hpp>

#include <utility>

namespace umbrameter {

bool Answers::find(const std::string& key, const std::function<void(const nlohmann::json&)>& read) {
  if (store_ == nullptr || !reuse_) return false;
  const auto found = read_json(store_->find(key), [&](const nlohmann::json& json) {
    read(json);
    return std::optional(true);
  });
  if (found) ++reused_;
  return found.has_value();
}

void Answers::keep(const std::string& key, const nlohmann::ordered_json& answer) {
  if (store_ != nullptr) store_->store().put({key, EntryKind::answer, answer.dump()});
}

size_t Answers::take_reused() {
  return std::exchange(reused_, 0);
}

}  // namespace umbrameter
