// SPDX-License-Identifier: Apache-2.0
#include "lab/answers.h"

#include <nlohmann/json.hpp>

#include <utility>

namespace umbrameter {

bool Answers::find(const std::string& key, const std::function<void(const nlohmann::json&)>& read) {
  const auto text = store_ != nullptr && reuse_ ? store_->find(key) : std::nullopt;
  if (!text) return false;
  try {
    read(nlohmann::json::parse(*text));
  } catch (const nlohmann::json::exception&) {
    return false;
  }
  ++reused_;
  return true;
}

void Answers::keep(const std::string& key, const nlohmann::ordered_json& answer) {
  if (store_ != nullptr) store_->store().put({key, EntryKind::answer, answer.dump()});
}

size_t Answers::take_reused() {
  return std::exchange(reused_, 0);
}

}  // namespace umbrameter
