// SPDX-License-Identifier: Apache-2.0
#pragma once
// Faults of the selftest (study/selftest/fault_list.h) through a whole record and check: does a regression find and name them,
// too?

#include "study/fault_case.h"
#include "study/regress/run.h"

#include <span>
#include <string>
#include <vector>

namespace umbrameter {

/// Those of `faults` whose scene is among `jobs`. Its technique without the fault is recorded, the text read back, and the fault
/// checked against it as a suite is: with more samples and seeds until a failure stands. Where the fault is painted into the
/// exact picture, that is recorded. `samples_per_pixel`: of one render of `renderers.reference`; a check may have twice.
std::vector<ProvedFault> prove_faults(std::span<const FaultCase> faults, std::span<const SceneJob> jobs,
                                      const SelftestSettings& settings, PictureRenderers renderers,
                                      int samples_per_pixel, const RegressGates& gates, Progress& progress);

}  // namespace umbrameter
