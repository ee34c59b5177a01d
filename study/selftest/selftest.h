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

struct FaultOutcome {
  std::string name, scene;
  SelftestRound round;
  FaultOrigin origin = FaultOrigin::technique;
  std::vector<GateClass> right;
  GateVerdict verdict;
  bool is_found() const { return !verdict.passes(); }
  bool is_right() const;
};

struct BenignOutcome {
  std::string name, scene;
  SelftestRound round;
  GateVerdict verdict;
};

/// A benign variant that was not asked about, as it moves texels that are too coarse for the scene's shadows.
struct LeftOut {
  std::string name, scene;
  SelftestRound round;
  Unresolved unresolved;
};

/// Pixels of one class against those that were painted.
struct MaskOutcome {
  std::string name, scene;
  SelftestRound round;
  FaultClass fault = FaultClass::acne;
  size_t painted = 0, found = 0, both = 0;
  std::optional<double> precision() const;
  std::optional<double> recall() const;
};

/// Whether the widths of a scene's true penumbrae differ enough to tell contact hardening by.
struct HardeningOutcome {
  std::string scene;
  size_t penumbrae = 0;    // profiles of the truth, accepted or not
  ContactHardening exact;  // of the truth drawn again; no technique can tell more
  bool is_told() const;
};

struct SelftestTargets {
  double nearest = 0.8;            // of its limit: the benign trial that comes nearest
  double right = 0.95;             // share of faults
  double mask = 0.95;              // precision and recall
  double cause = 0.95;             // share of faults whose cause can be undone
  double hardening = 10.0 / 14.0;  // share of scenes with penumbrae
};

struct SelftestResults {
  size_t scenes = 0;
  std::vector<FaultOutcome> faults;
  std::vector<BenignOutcome> benign;
  std::vector<LeftOut> left_out;
  std::vector<MaskOutcome> masks;           // of scenes with a place for them
  std::vector<CauseOutcome> causes;         // of the first round
  std::vector<HardeningOutcome> hardening;  // of the first round
  /// The benign trial that came nearest to a limit; null without any.
  const BenignOutcome* nearest_benign() const;
  /// Sums over scenes and rounds, one a mask; `scene` is empty.
  std::vector<MaskOutcome> masks_over_scenes() const;
  size_t found() const, right() const, false_alarms() const, right_causes() const, telling_hardening() const,
      scenes_with_penumbrae() const;
  bool passes(const SelftestTargets& targets = {}) const;
};

/// Every fault whose scene is among `jobs`, every benign variant and painted mask on all of them, in every round. Errors of renderers pass
/// through, but for those that a fault provokes.
SelftestResults run_selftest(std::span<const SceneJob> jobs, const SelftestSettings& settings,
                             SelftestRenderers renderers, Progress& progress);

}  // namespace umbrameter
