// SPDX-License-Identifier: Apache-2.0
#pragma once
// A fault that the gate must find and name, as a picture to be made. Not here: which there are (study/selftest/fault_list.h).

#include "study/stage.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {

/// One picture to be judged.
struct Trial {
  std::optional<Failure> failure;  // instead of a picture
  Image picture;
  std::optional<TechniqueChoice> baseline;  // absent: against the limits alone
  std::optional<Image> truth;               // absent: the stage's
  ErrorMetric metric = error_metric;
  std::vector<uint8_t> injected;  // pixels that were painted; empty when none were
};

using MakeTrial = std::function<Trial(Stage&)>;

struct FaultCase {
  std::string name;
  FaultOrigin origin = FaultOrigin::technique;
  std::string scene;             // of the library
  std::vector<GateClass> right;  // any of these names it
  MakeTrial make;
};

}  // namespace umbrameter
