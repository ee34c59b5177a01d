// SPDX-License-Identifier: Apache-2.0
// Without these tests a leak could be reported as another fault, or a missing channel could cost the score.

#include "metrics/diagnosis.h"

#include "tests/support/lab/fakes.h"
#include "tests/support/temporary_folder.h"

#include "lab/score.h"
#include "results/diagnosis_format.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace umbrameter {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// Techniques "exact" and "leak" on a hard shadow; `reference` may lack channels.
SceneResult validate_leak(const Image& reference_picture, const std::filesystem::path& folder) {
  FakeRenderer reference([&](const RenderRequest&) { return frame_of(reference_picture); });
  FakeRenderer realtime([](const RenderRequest& request) {
    Image image = leaking_image();
    if (request.technique == "exact") {
      const Image truth = shadowed_reference_image();
      const auto v = truth.plane("visibility");
      std::copy(v.begin(), v.end(), image.plane("visibility").begin());
    }
    return frame_of(std::move(image));
  });
  const std::vector<SceneJob> scenes{fake_scene("plate")};
  SilentProgress progress;
  const ValidationPlan plan = fake_plan({fake_technique("exact"), fake_technique("leak")});
  return run_validation(scenes, plan, {reference, realtime}, folder, progress).scenes.at(0);
}

TEST(Diagnosis, NamesTheLeakAndFindsNothingInTheTruth) {
  const TemporaryFolder folder;
  const SceneResult scene = validate_leak(shadowed_reference_image(), folder.path());
  const TechniqueResult& exact = scene.techniques[0];
  const TechniqueResult& leak = scene.techniques[1];
  ASSERT_TRUE(exact.diagnosis && leak.diagnosis);
  EXPECT_FALSE(worst_fault(exact.diagnosis->faults));
  EXPECT_EQ(format_worst_fault(exact.diagnosis), "none");
  EXPECT_EQ(worst_fault(leak.diagnosis->faults), FaultClass::geometric_leak);
  // 3 x 20 of 39 x 30 scored pixels are wrong by 1: 60 / 1170 = 0.05128.
  EXPECT_NEAR(leak.diagnosis->faults.of(FaultClass::geometric_leak).mean_abs_error, 60.0 / 1170.0, 1e-12);
  EXPECT_EQ(format_worst_fault(leak.diagnosis), "geometric leak 0.05128");
  EXPECT_TRUE(std::filesystem::exists(folder.path() / leak.fault_picture_file));
  EXPECT_TRUE(leak.warnings.empty());
}

TEST(Diagnosis, ThatFailsLeavesTheScoreAndNamesThePixel) {
  const TemporaryFolder folder;
  Image reference = shadowed_reference_image();
  reference.plane("blocker_layers")[2 * kFakeWidth_px + 5] = -1.0f;
  const TechniqueResult leak = validate_leak(reference, folder.path()).techniques[1];
  EXPECT_FALSE(leak.failure);
  EXPECT_TRUE(leak.error);
  EXPECT_FALSE(leak.diagnosis);
  EXPECT_THAT(leak.warnings, ElementsAre(testing::AllOf(StartsWith("the faults could not be told apart: "),
                                                        HasSubstr("'blocker_layers'"), HasSubstr("(5, 2)"))));
  EXPECT_EQ(format_worst_fault(leak.diagnosis), "n/a");
}

TEST(WorstFault, IsTheClassWithTheMostErrorThatIsNotExplained) {
  FaultNumbers faults;
  const auto set = [&](FaultClass fault, double part) {
    faults.by_class[static_cast<size_t>(fault)].mean_abs_error = part;
  };
  set(FaultClass::explained, 0.5);
  EXPECT_FALSE(worst_fault(faults));
  set(FaultClass::penumbra, 0.05);
  EXPECT_EQ(worst_fault(faults), FaultClass::penumbra);
  set(FaultClass::acne, 0.1);
  set(FaultClass::bleed, 0.2);
  set(FaultClass::overlap, 0.15);
  EXPECT_EQ(worst_fault(faults), FaultClass::bleed);
}

TEST(DiagnosisLines, SayWhenContactHardeningIsNotIdentifiable) {
  Diagnosis diagnosis;
  diagnosis.contact_hardening = {12, 1.5, std::nullopt, std::nullopt, std::nullopt};
  EXPECT_EQ(penumbra_lines(diagnosis).back().second, "not identifiable: 12 profiles over 1.5 octaves");
  diagnosis.contact_hardening = {300, 3.5, 0.875, -0.25, 0.125};
  EXPECT_EQ(penumbra_lines(diagnosis).back().second,
            "slope 0.875 +- 0.12, -0.25 octaves at the median width (300 profiles over 3.5 octaves)");
}

TEST(DiagnosisLines, CountRejectedProfilesByCause) {
  Diagnosis diagnosis;
  diagnosis.penumbra.outcomes = {10, 0, 3, 0, 0, 0, 2, 0};
  EXPECT_EQ(penumbra_lines(diagnosis)[2].second,
            "10 accepted, 5 rejected (3 discontinuity, 2 test unreached)");
}

Diagnosis with_parts(const std::vector<std::pair<FaultClass, double>>& parts) {
  Diagnosis diagnosis;
  diagnosis.faults.mean_abs_error = 0.0;
  for (const auto& [fault, part] : parts) {
    diagnosis.faults.by_class[static_cast<size_t>(fault)].mean_abs_error = part;
    *diagnosis.faults.mean_abs_error += part;
  }
  return diagnosis;
}

TEST(Faults, EveryClassAboveATenthOfTheErrorIsNamed) {
  const Diagnosis diagnosis = with_parts({{FaultClass::explained, 0.05},
                                          {FaultClass::acne, 0.012},
                                          {FaultClass::penumbra_too_wide, 0.03},
                                          {FaultClass::bleed, 0.008}});
  EXPECT_EQ(format_faults(diagnosis), "penumbra too wide 0.03000, acne 0.01200");
  EXPECT_EQ(format_faults(with_parts({{FaultClass::explained, 1.0}, {FaultClass::acne, 0.01}})),
            "acne 0.01000");
  EXPECT_EQ(format_faults(with_parts({{FaultClass::explained, 1.0}})), "none");
  EXPECT_EQ(format_faults(std::nullopt), "n/a");
}

TEST(Faults, WhatGrewAgainstTheBaselineIsNamed) {
  const Diagnosis baseline =
      with_parts({{FaultClass::penumbra, 0.05}, {FaultClass::acne, 0.01}, {FaultClass::bleed, 0.001}});
  const Diagnosis now =
      with_parts({{FaultClass::penumbra, 0.01}, {FaultClass::acne, 0.02}, {FaultClass::bleed, 0.003}});
  EXPECT_EQ(format_growth(now, baseline), "+acne 0.01000");
  EXPECT_EQ(format_growth(baseline, baseline), "nothing");
  EXPECT_EQ(format_growth(now, std::nullopt), "n/a");
}

TEST(DiagnosisLines, SayHowManyProfilesAreStretches) {
  Diagnosis diagnosis;
  diagnosis.penumbra.outcomes = {10, 0, 0, 0, 0, 0, 0, 0};
  diagnosis.penumbra.partial = 4;
  EXPECT_EQ(penumbra_lines(diagnosis)[2].second, "10 accepted, 0 rejected, 4 by a stretch");
}

TEST(DiagnosisLines, NeverShowAFaultThatIsThereAsNothing) {
  Diagnosis diagnosis;
  diagnosis.faults.by_class[static_cast<size_t>(FaultClass::acne)] = {3, 1, 2e-7};
  EXPECT_EQ(format_worst_fault(diagnosis), "acne < 0.00001");
}

}  // namespace
}  // namespace umbrameter
