// SPDX-License-Identifier: Apache-2.0
// Without these the gate could pass a fault, name the wrong one, or alarm at what the baseline has anyway.

#include "metrics/gate.h"

#include <gtest/gtest.h>

#include <set>

namespace umbrameter {
namespace {

GateRun clean_run() {
  GateRun run;
  run.error = VisibilityError{};
  run.error->rmse = Interval{0.01, 0.009, 0.011};
  run.diagnosis = Diagnosis{};
  return run;
}

GateRun with_share(FaultClass fault, double share) {
  GateRun run = clean_run();
  run.diagnosis->faults.by_class[static_cast<size_t>(fault)].mean_abs_error = share;
  return run;
}

Spread spread(double rmse) {
  return {0.0, -rmse, rmse, rmse};
}

TEST(Gate, ACleanRunPassesWithAndWithoutABaseline) {
  EXPECT_TRUE(judge_gate(clean_run(), nullptr, false).passes());
  const GateRun baseline = clean_run();
  EXPECT_TRUE(judge_gate(clean_run(), &baseline, false).passes());
}

TEST(Gate, EveryClassHasItsOwnName) {
  std::set<std::string_view> names;
  for (size_t k = 0; k < kGateClasses; ++k) names.insert(name_of(static_cast<GateClass>(k)));
  EXPECT_EQ(names.size(), kGateClasses);
}

TEST(Gate, AFaultBeyondItsLimitIsNamed) {
  EXPECT_TRUE(judge_gate(with_share(FaultClass::acne, 1.9e-4), nullptr, false).passes());
  EXPECT_EQ(judge_gate(with_share(FaultClass::acne, 2.1e-4), nullptr, false).kind, GateClass::acne);
  EXPECT_EQ(judge_gate(with_share(FaultClass::bleed, 1e-2), nullptr, false).kind, GateClass::bleed);
}

TEST(Gate, WhatTheBaselineHasIsAllowedAndHalfOfItMore) {
  GateRun baseline = with_share(FaultClass::acne, 0.01);
  EXPECT_TRUE(judge_gate(with_share(FaultClass::acne, 0.015), &baseline, false).passes());
  EXPECT_EQ(judge_gate(with_share(FaultClass::acne, 0.0153), &baseline, false).kind, GateClass::acne);
  // Resolution is more of a chance.
  baseline = with_share(FaultClass::resolution, 0.01);
  EXPECT_TRUE(judge_gate(with_share(FaultClass::resolution, 0.02), &baseline, false).passes());
  EXPECT_EQ(judge_gate(with_share(FaultClass::resolution, 0.0203), &baseline, false).kind,
            GateClass::resolution);
}

TEST(Gate, TheLargestExcessIsTheMainFault) {
  GateRun run = with_share(FaultClass::acne, 0.02);
  run.diagnosis->faults.by_class[static_cast<size_t>(FaultClass::bleed)].mean_abs_error = 0.03;
  EXPECT_EQ(judge_gate(run, nullptr, false).kind, GateClass::bleed);
  const GateRun baseline = with_share(FaultClass::bleed, 0.025);
  EXPECT_EQ(judge_gate(run, &baseline, false).kind, GateClass::acne);
}

TEST(Gate, AWrongPenumbraIsToldByItsShape) {
  GateRun run = with_share(FaultClass::penumbra, 0.01);
  EXPECT_EQ(judge_gate(run, nullptr, false).kind, GateClass::softness);
  run.diagnosis->penumbra.offset_widths = spread(0.5);
  EXPECT_EQ(judge_gate(run, nullptr, false).kind, GateClass::offset);
  run.diagnosis->penumbra.width_octaves = spread(1.0);
  EXPECT_EQ(judge_gate(run, nullptr, false).kind, GateClass::softness);
  run.diagnosis->contact_hardening.slope = 0.0;
  EXPECT_EQ(judge_gate(run, nullptr, false).kind, GateClass::hardening);
}

TEST(Gate, SoftnessThatIsMostlyBeyondTheTrueOneIsTooWide) {
  GateRun run = with_share(FaultClass::penumbra_too_wide, 0.01);
  EXPECT_EQ(judge_gate(run, nullptr, false).kind, GateClass::penumbra_too_wide);
  const auto set = [&](FaultClass fault, double part) {
    run.diagnosis->faults.by_class[static_cast<size_t>(fault)].mean_abs_error = part;
  };
  set(FaultClass::penumbra, 0.02);
  EXPECT_EQ(judge_gate(run, nullptr, false).kind, GateClass::softness);
  // Of what is more than the baseline's.
  const GateRun baseline = with_share(FaultClass::penumbra, 0.018);
  EXPECT_EQ(judge_gate(run, &baseline, false).kind, GateClass::penumbra_too_wide);
  set(FaultClass::acne, 0.05);
  EXPECT_EQ(judge_gate(run, nullptr, false).kind, GateClass::acne);
}

TEST(Gate, WhatTheBaselineDoesNotLetMeasureIsNotCompared) {
  GateRun run = clean_run();
  run.diagnosis->contact_hardening.slope = 0.0;
  GateRun baseline = clean_run();
  EXPECT_TRUE(judge_gate(run, &baseline, false).passes());
  baseline.diagnosis->contact_hardening.slope = 0.9;
  EXPECT_EQ(judge_gate(run, &baseline, false).kind, GateClass::hardening);
}

TEST(Gate, ASlopeIsDoubtfulByItsInterval) {
  GateRun run = clean_run();
  run.diagnosis->contact_hardening.slope = 0.5;
  GateRun baseline = clean_run();
  baseline.diagnosis->contact_hardening.slope = 1.0;
  EXPECT_EQ(judge_gate(run, &baseline, false).kind, GateClass::hardening);
  run.diagnosis->contact_hardening.slope_margin = 0.15;
  baseline.diagnosis->contact_hardening.slope_margin = 0.15;  // .21 together
  EXPECT_TRUE(judge_gate(run, &baseline, false).passes());
}

TEST(Gate, AWrongSlopeWithoutNarrowPenumbraeIsAFilterTooWide) {
  GateRun run = with_share(FaultClass::penumbra_too_wide, 0.01);
  run.diagnosis->contact_hardening.slope = 0.5;
  run.diagnosis->penumbra.width_octaves = Spread{0.8, 0.1, 2.0, 1.0};
  EXPECT_EQ(judge_gate(run, nullptr, false).kind, GateClass::penumbra_too_wide);
  // At the line's end, penumbrae without an umbra, by .3 - .5 * 4 * .5 = -.7 octaves.
  run.diagnosis->contact_hardening.octaves = 4.0;
  run.diagnosis->contact_hardening.intercept_octaves = 0.3;
  EXPECT_EQ(judge_gate(run, nullptr, false).kind, GateClass::hardening);
  run.diagnosis->contact_hardening.intercept_octaves = 1.0;
  EXPECT_EQ(judge_gate(run, nullptr, false).kind, GateClass::penumbra_too_wide);
  run.diagnosis->penumbra.width_octaves = Spread{0.8, -0.5, 2.0, 1.0};
  EXPECT_EQ(judge_gate(run, nullptr, false).kind, GateClass::hardening);
  // What the baseline has is no sign of the run's.
  GateRun baseline = clean_run();
  baseline.diagnosis->contact_hardening.slope = 1.0;
  baseline.diagnosis->penumbra.width_octaves = Spread{0.0, -0.4, 0.4, 0.2};
  EXPECT_EQ(judge_gate(run, &baseline, false).kind, GateClass::penumbra_too_wide);
  run.diagnosis->faults.by_class[static_cast<size_t>(FaultClass::penumbra)].mean_abs_error = 0.003;
  EXPECT_EQ(judge_gate(run, &baseline, false).kind, GateClass::hardening);
}

TEST(Gate, EdgesAreNotTheMapsFaultWhereItIsNoCoarser) {
  GateRun baseline = clean_run();
  baseline.diagnosis->causes.median_footprint_px = 2.0;
  GateRun run = with_share(FaultClass::resolution, 0.02);
  run.diagnosis->faults.by_class[static_cast<size_t>(FaultClass::penumbra_too_wide)].mean_abs_error = 0.01;
  run.diagnosis->causes.median_footprint_px = 4.0;
  EXPECT_EQ(judge_gate(run, &baseline, false).kind, GateClass::resolution);
  run.diagnosis->causes.median_footprint_px = 2.0;
  EXPECT_EQ(judge_gate(run, &baseline, false).kind, GateClass::penumbra_too_wide);
  // Without anything wrong of penumbrae it keeps its name, and without known texels, too.
  EXPECT_EQ(judge_gate(with_share(FaultClass::resolution, 0.02), &baseline, false).kind,
            GateClass::resolution);
  run.diagnosis->causes.median_footprint_px.reset();
  EXPECT_EQ(judge_gate(run, &baseline, false).kind, GateClass::resolution);
}

TEST(Gate, ACoarserMapsTexelsAreNamedBeforeWhatTheyMake) {
  GateRun baseline = clean_run();
  baseline.diagnosis->causes.median_footprint_px = 2.0;
  for (const auto& [fault, kind] : {std::pair(FaultClass::peter_panning, GateClass::peter_panning),
                                    std::pair(FaultClass::acne, GateClass::acne)}) {
    GateRun run = with_share(fault, 0.05);
    run.diagnosis->causes.median_footprint_px = 8.0;
    EXPECT_EQ(judge_gate(run, &baseline, false).kind, kind) << "no edge says that texels are too wide";
    run.diagnosis->faults.by_class[static_cast<size_t>(FaultClass::resolution)].mean_abs_error = 0.02;
    EXPECT_EQ(judge_gate(run, &baseline, false).kind, GateClass::resolution);
    EXPECT_EQ(judge_gate(run, nullptr, false).kind, kind) << "not known to be coarser";
    run.diagnosis->causes.median_footprint_px = 2.0;
    EXPECT_EQ(judge_gate(run, &baseline, false).kind, kind);
  }
}

TEST(Gate, PenumbraeErrMoreAsTexelsGrow) {
  const auto with = [](double penumbra, double explained, double texel_px) {
    GateRun run = with_share(FaultClass::overlap, penumbra);
    run.diagnosis->faults.by_class[static_cast<size_t>(FaultClass::explained)].mean_abs_error = explained;
    run.diagnosis->causes.median_footprint_px = texel_px;
    return run;
  };
  const GateRun baseline = with(0.001, 0.009, 2.0);
  // Half of the baseline's and .0002, then a twentieth of what errs there: .0005.
  EXPECT_TRUE(judge_gate(with(0.0021, 0.009, 2.1), &baseline, false).passes());
  EXPECT_FALSE(judge_gate(with(0.0023, 0.009, 2.1), &baseline, false).passes());
  EXPECT_FALSE(judge_gate(with(0.0021, 0.009, 2.0), &baseline, false).passes());
  EXPECT_FALSE(judge_gate(with(0.0021, 0.009, 1.0), &baseline, false).passes());
  // A coarser map is allowed no more than a map laid otherwise.
  EXPECT_TRUE(judge_gate(with(0.0026, 0.009, 9.0), &baseline, false).passes());
  EXPECT_FALSE(judge_gate(with(0.0028, 0.009, 9.0), &baseline, false).passes());
}

TEST(Gate, GrainIsNotBanding) {
  GateRun run = clean_run();
  run.diagnosis->causes.banding = 0.9;
  EXPECT_EQ(judge_gate(run, nullptr, false).kind, GateClass::banding);
  run.diagnosis->causes.noise = 0.07;
  run.diagnosis->causes.reference_noise = 0.04;
  EXPECT_EQ(judge_gate(run, nullptr, false).kind, GateClass::noise);
}

TEST(Gate, AnErrorWithoutACauseFailsOnlyWhenItIsWorseForCertain) {
  const GateRun baseline = clean_run();
  GateRun run = clean_run();
  run.error->rmse->value = 0.05;
  EXPECT_TRUE(judge_gate(run, &baseline, false).passes());
  EXPECT_EQ(judge_gate(run, &baseline, true).kind, GateClass::error);
}

TEST(Gate, APictureFullOfPenumbraeMayBeWrongByTheirWidths) {
  const auto kind_of = [](double rmse, double penumbra_share) {
    GateRun run = clean_run();
    run.error->rmse = Interval{rmse, rmse, rmse};
    run.error->penumbra.share = penumbra_share;
    return judge_gate(run, nullptr, false).kind;
  };
  EXPECT_EQ(kind_of(0.031, 0.0), GateClass::error);
  // All penumbrae .2 octaves too wide have an RMSE of .0283 where they are half of the picture.
  EXPECT_EQ(kind_of(0.041, 0.5), std::nullopt);
  EXPECT_EQ(kind_of(0.042, 0.5), GateClass::error);
}

TEST(Gate, AFurtherMeasureSpeaksWhereNoClassDoes) {
  GateLimits limits;
  limits.further = {{"worst", {Better::lower, {0.1, 0.5}}}, {"seam", {Better::nearest_zero, {0.1, 0.0}}}};
  const auto with = [](double worst, double seam) {
    GateRun run = clean_run();
    run.measured = {{"worst", worst}, {"seam", seam}};
    return run;
  };
  const GateRun baseline = with(0.2, -0.05);
  EXPECT_TRUE(judge_gate(with(0.39, -0.14), &baseline, false, limits).passes());
  const GateVerdict verdict = judge_gate(with(0.41, -0.16), &baseline, false, limits);
  EXPECT_EQ(verdict.kind, GateClass::measured);
  EXPECT_EQ(name_of(verdict), "seam") << ".11 of the .1 that may be added, against .21 of .2";
  EXPECT_EQ(name_of(judge_gate(with(0.5, 0.0), &baseline, false, limits)), "worst");
  EXPECT_TRUE(judge_gate(with(0.5, 0.0), &baseline, false).passes()) << "no limit, no gate";
  GateRun acne = with(9.0, 9.0);
  acne.diagnosis->faults.by_class[static_cast<size_t>(FaultClass::acne)].mean_abs_error = 0.01;
  EXPECT_EQ(name_of(judge_gate(acne, &baseline, false, limits)), "acne");
  const GateRun unmeasured = clean_run();
  EXPECT_TRUE(judge_gate(with(9.0, 9.0), &unmeasured, false, limits).passes());
  EXPECT_EQ(name_of(GateVerdict{}), "");
}

TEST(Gate, WhatVoidsARunIsSaidFirst) {
  GateRun run = with_share(FaultClass::acne, 0.1);
  run.parity_passes = false;
  EXPECT_EQ(judge_gate(run, nullptr, false).kind, GateClass::parity);
  run.is_other_light = true;
  EXPECT_EQ(judge_gate(run, nullptr, false).kind, GateClass::light);
  run.truth_problems = {"the halves are one"};
  EXPECT_EQ(judge_gate(run, nullptr, false).kind, GateClass::truth);
  run.metric_problems = {"mse is mae"};
  EXPECT_EQ(judge_gate(run, nullptr, false).kind, GateClass::metric);
  run.failure = Failure{ErrorKind::input, "visibility is not finite"};
  const GateVerdict verdict = judge_gate(run, nullptr, false);
  EXPECT_EQ(verdict.kind, GateClass::failure);
  EXPECT_TRUE(verdict.measures.empty());
}

TEST(Gate, WhatTheEnvelopeNoLongerExcusesIsNoNewSoftness) {
  const GateRun baseline = with_share(FaultClass::explained, 2e-3);
  GateRun run = with_share(FaultClass::explained, 1e-3);
  const auto set = [&](FaultClass fault, double share) {
    run.diagnosis->faults.by_class[static_cast<size_t>(fault)].mean_abs_error = share;
  };
  set(FaultClass::overlap, 1.1e-3);
  EXPECT_TRUE(judge_gate(run, &baseline, false).passes());
  set(FaultClass::overlap, 1.3e-3);
  EXPECT_EQ(judge_gate(run, &baseline, false).kind, GateClass::softness);
  // Nor does it excuse anything else.
  set(FaultClass::overlap, 0.0);
  set(FaultClass::acne, 3e-4);
  EXPECT_EQ(judge_gate(run, &baseline, false).kind, GateClass::acne);
}

TEST(Gate, WhatAFinerMapNoLongerExcusesIsNoNewFault) {
  GateRun baseline = with_share(FaultClass::resolution, 2e-3);
  GateRun run = with_share(FaultClass::resolution, 1e-3);
  run.diagnosis->faults.by_class[static_cast<size_t>(FaultClass::penumbra)].mean_abs_error = 9e-4;
  EXPECT_TRUE(judge_gate(run, &baseline, false).passes());
  // With more error in all it is one, and so it is without the resolution's decline.
  run.diagnosis->faults.by_class[static_cast<size_t>(FaultClass::penumbra)].mean_abs_error = 1.1e-3;
  EXPECT_EQ(judge_gate(run, &baseline, false).kind, GateClass::softness);
  baseline = with_share(FaultClass::acne, 2e-3);
  run = with_share(FaultClass::geometric_leak, 9e-4);
  EXPECT_EQ(judge_gate(run, &baseline, false).kind, GateClass::geometric_leak);
}

TEST(Gate, FewProfilesAreDoubtful) {
  const auto with_width = [](double rmse, double rmse_se) {
    GateRun run = clean_run();
    run.diagnosis->penumbra.width_octaves = Spread{0.0, -rmse, rmse, rmse, rmse_se, 5};
    return run;
  };
  const GateRun baseline = with_width(0.2, 0.0);
  EXPECT_EQ(judge_gate(with_width(0.5, 0.0), &baseline, false).kind, GateClass::softness);
  EXPECT_TRUE(judge_gate(with_width(0.5, 0.05), &baseline, false).passes());
}

TEST(Gate, SeverityIsOneAtTheLimit) {
  const GateRun baseline = with_share(FaultClass::acne, 4e-4);
  const GateVerdict verdict = judge_gate(with_share(FaultClass::acne, 8e-4), &baseline, false);
  EXPECT_NEAR(verdict.measures.at(0).severity(), 1.0, 1e-9);
  EXPECT_NEAR(verdict.measures.at(0).allowed, 8e-4, 1e-12);
}

}  // namespace
}  // namespace umbrameter
