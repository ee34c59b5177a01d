// SPDX-License-Identifier: Apache-2.0
#pragma once
// The faults that the gate must find and name, and the variants that it must let pass. The machinery behind them:
// study/stage.h, study/selftest/{mutant,scene_change,injection}.h.

#include "study/fault_case.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

/// The technique that most faults are written into, and that benign variants are compared with.
TechniqueChoice soft_shadows();

struct BenignVariant {
  std::string name;
  MakeTrial make;
  bool moves_texels =
      false;  // benign only where the baseline's map resolves the true edges (metrics/faults/resolved.h)
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
