// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a self-test found of each trial (docs/selftest.md). Not here: trials (study/selftest/).

#include "metrics/causes/fault_causes.h"
#include "metrics/causes/substitutions.h"
#include "metrics/faults/resolved.h"
#include "metrics/gate.h"
#include "metrics/penumbra/contact_hardening.h"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {

/// A size and samples that everything is tried with.
struct SelftestRound {
  int width_px = 320;
  int height_px = 180;
  uint64_t seed = 1;
  auto operator<=>(const SelftestRound&) const = default;
};
/// "320 x 180 px, seed 1".
std::string text_of(const SelftestRound& round);

/// Where a fault sits.
enum class FaultOrigin : uint8_t { technique, image, reference, metric };
std::string_view name_of(FaultOrigin origin);

struct CauseOutcome {
  std::string name, scene;
  std::vector<RunPart> right;
  std::optional<FaultClass>
      fault;  // the class whose error grew most against the sound picture; absent: none did
  std::vector<SubstitutionOutcome> tried;  // with one number each: of `fault`
  std::string best;                        // substitution that removes most of it; empty without any
  double removed = 0.0;                    // by that
  double undone = 0.0;           // by the sound run itself: no substitution of the right part can do more
  std::optional<RunPart> cause;  // what it replaced, where it mends the fault
  bool is_right() const;
};
/// "bias x 0 of colonnade: acne, ten times the bias removes 97 %".
std::string text_of(const CauseOutcome& outcome);

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

}  // namespace umbrameter
