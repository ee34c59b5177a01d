// SPDX-License-Identifier: Apache-2.0
// Without these a self-test that goes on after a kill could count other outcomes than it had.

#include "study/selftest/kept_trials.h"

#include <gtest/gtest.h>

#include <cmath>

namespace umbrameter {
namespace {

/// What is read of what is written is written the same.
template <class Outcome>
void expect_kept(const Outcome& outcome) {
  const std::string text = trial_json(outcome).dump();
  Outcome read{};
  read_trial(nlohmann::json::parse(text), read);
  EXPECT_EQ(trial_json(read).dump(), text);
}

TEST(KeptTrials, SayTheSameAfterTheStore) {
  GateVerdict verdict;
  verdict.measures = {{GateClass::acne, 0.25, 0.125, 0.5}, {GateClass::noise, {}, {}, HUGE_VAL}};
  expect_kept(verdict);
  verdict.kind = GateClass::penumbra_too_wide;
  expect_kept(verdict);
  verdict.measures.push_back({GateClass::measured, 0.25, 0.125, 0.5, "map_seam"});
  verdict.key = "map_seam";
  expect_kept(verdict);
  GateVerdict read;
  read_trial(nlohmann::json::parse(trial_json(verdict).dump()), read);
  EXPECT_EQ(read.kind, GateClass::penumbra_too_wide);
  EXPECT_EQ(read.measures[1].allowed, HUGE_VAL);
  EXPECT_EQ(read.measures[0].severity(), verdict.measures[0].severity());

  expect_kept(Unresolved{0.25, 0.5});
  expect_kept(std::optional<MaskOutcome>());
  expect_kept(std::optional(MaskOutcome{"acne", "plate", {64, 36, 7}, FaultClass::acne, 3, 2, 1}));
  expect_kept(HardeningOutcome{"plate", 12, {9, 3.5, 0.75, {}, 0.125}});
  CauseOutcome cause;
  cause.name = "bias 32";
  cause.right = {RunPart::bias, RunPart::blocker_distance};
  cause.fault = FaultClass::peter_panning;
  cause.tried = {{"bias_zero", {"bias_texels 32 -> 0"}, {}, {0.75}, 0.125},
                 {"taps_x4", {}, "no taps", {}, 0.0}};
  cause.cause = RunPart::blocker_distance;
  expect_kept(cause);
}

TEST(KeptTrials, OfAnotherVersionAreRefused) {
  GateVerdict verdict;
  EXPECT_THROW(read_trial({{"measures", nlohmann::json::array()}, {"kind", "nonsense"}}, verdict),
               nlohmann::json::exception);
  EXPECT_THROW(read_trial(nlohmann::json::object(), verdict), nlohmann::json::exception);
}

}  // namespace
}  // namespace umbrameter
