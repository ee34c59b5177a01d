// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a stress run gets from the composition root.

#include "lab/truth_oracle.h"
#include "lab/validation.h"
#include "scenes/altered/stress/axis.h"

#include <functional>
#include <string>
#include <vector>

namespace umbrameter {

/// What study/ cannot make itself.
struct StressTools {
  std::vector<TechniqueRun> techniques;  // at their defaults
  /// With `edits` made in the manifests of all built-in techniques; valid until the next call.
  std::function<Renderer&(const std::vector<ManifestEdit>& edits)> realtime;
  /// Error{input} for what the technique does not allow.
  std::function<TechniqueRun(const TechniqueRun& run, const std::vector<std::string>& assignments,
                             const std::vector<ManifestEdit>& edits)>
      choose;
  Renderer& reference;
  TruthOracle oracle;
};

}  // namespace umbrameter
