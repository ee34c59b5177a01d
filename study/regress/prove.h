#pragma once
// The mutation suite of the selftest (study/selftest/fault_list.h) against baselines that have been through their text
// file: does a regression find and name the same faults?

#include "study/regress/judge.h"
#include "study/selftest/fault_list.h"

#include <span>
#include <string>
#include <vector>

namespace umbrameter {

struct ProvedFault {
  std::string name, scene;
  std::vector<GateClass> right;
  CaseVerdict verdict;
  bool is_found() const { return verdict.outcome == CaseOutcome::fail; }
  bool is_named() const;
};

/// Every fault whose scene is among `jobs`. Its technique without the fault is the baseline; where the fault is painted into
/// the exact picture, that is.
std::vector<ProvedFault> prove_faults(std::span<const SceneJob> jobs, const SelftestSettings& settings,
                                      SelftestRenderers renderers, const RegressGates& gates,
                                      Progress& progress);

std::string proof_markdown(std::span<const ProvedFault> faults);

}  // namespace umbrameter
