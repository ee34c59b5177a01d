// SPDX-License-Identifier: Apache-2.0
#pragma once
// The tester tested: known faults in pictures, techniques, references and metrics, which the gate must find and name, and
// benign variants, which it must let pass (docs/selftest.md).

#include "study/selftest/causes.h"
#include "study/selftest/fault_list.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace umbrameter {

/// Every fault whose scene is among `jobs`, every benign variant and painted mask on all of them, in every round. Errors of renderers pass
/// through, but for those that a fault provokes.
SelftestResults run_selftest(std::span<const SceneJob> jobs, const SelftestSettings& settings,
                             PictureRenderers renderers, Progress& progress);

}  // namespace umbrameter
