// SPDX-License-Identifier: Apache-2.0
#pragma once
// Copies of technique folders with a fault written into them.

#include "study/stage.h"

#include <span>
#include <string>

namespace umbrameter {

/// The one occurrence of `from` in `file`, which lies in the technique's folder or else in the shader library.
struct Patch {
  std::string file, from, to;
};

/// `choice` with its technique patched, in a folder `name` of the scratch folder. Error{internal} when a patch does not fit
/// exactly once: the technique has changed, and the fault must follow.
TechniqueChoice mutant(const TechniqueChoice& choice, const std::string& name, std::span<const Patch> patches,
                       const SelftestSettings& settings);

}  // namespace umbrameter
