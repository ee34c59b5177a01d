// SPDX-License-Identifier: Apache-2.0
#pragma once
// The faults that the gate must find and name, and the variants that it must let pass. The machinery behind them:
// study/selftest/{stage,mutant,scene_change,injection}.h.

#include "study/selftest/stage.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

/// Where a fault sits.
enum class FaultOrigin : uint8_t { technique, image, reference, metric };
std::string_view name_of(FaultOrigin origin);

/// The technique that most faults are written into, and that benign variants are compared with.
TechniqueChoice soft_shadows();

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

struct BenignVariant {
  std::string name;
  MakeTrial make;
  bool moves_texels = false;  // benign only where the baseline's map resolves the true edges (resolved.h)
};

std::vector<FaultCase> fault_list();

/// For any scene.
std::vector<BenignVariant> benign_list();

/// Painted faults whose pixels are compared with those that the gate's classes name: speckle and stripes for acne, a
/// slit for leaks, on the exact picture of any scene.
struct MaskCase {
  std::string name;
  FaultClass fault = FaultClass::acne;
  MakeTrial make;
};
std::vector<MaskCase> mask_list();

}  // namespace umbrameter
