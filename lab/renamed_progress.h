// SPDX-License-Identifier: Apache-2.0
#pragma once
// Gives tasks longer names: "pcss" becomes "plate (2 of 13), pcss:taps=64".

#include "core/progress.h"

#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace umbrameter {

class RenamedProgress final : public Progress {
 public:
  using Rename = std::function<std::string(std::string_view)>;
  RenamedProgress(Progress& inner, Rename rename) : inner_(inner), rename_(std::move(rename)) {}
  void begin(std::string_view task, uint64_t steps) override { inner_.begin(rename_(task), steps); }
  void advance(uint64_t steps) override { inner_.advance(steps); }
  void end() override { inner_.end(); }

 private:
  Progress& inner_;
  Rename rename_;
};

}  // namespace umbrameter
