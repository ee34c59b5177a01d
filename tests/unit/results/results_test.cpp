// SPDX-License-Identifier: Apache-2.0
// Without these tests a number could be lost or changed on its way through results.json.

#include "results/json/results_json.h"

#include "tests/support/lab/fakes.h"
#include "tests/support/temporary_folder.h"

#include "core/error.h"
#include "results/format.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(Results, SurviveJsonWithEveryBit) {
  const TemporaryFolder folder;
  Results results = fake_results(folder.path());
  results.picture.target_se = 0.1 + 0.2;  // no short decimal
  results.picture.seed = 18446744073709551615u;
  const std::string text = to_json_text(results);
  const Results back = parse_results(text, "results.json");
  EXPECT_EQ(to_json_text(back), text);
  EXPECT_EQ(back.picture.target_se, results.picture.target_se);
  EXPECT_EQ(back.picture.seed, results.picture.seed);
  EXPECT_EQ(back.scenes[0].techniques[1].error->rmse->high,
            results.scenes[0].techniques[1].error->rmse->high);
  EXPECT_EQ(back.scenes[0].techniques[1].parameters, results.scenes[0].techniques[1].parameters);
  EXPECT_EQ(back.scenes[0].techniques[2].failure->kind, ErrorKind::input);
}

TEST(Results, KeepTheDiagnosis) {
  TechniqueResult run;
  Diagnosis& diagnosis = run.diagnosis.emplace();
  diagnosis.penumbra.outcomes = {8, 7, 6, 5, 4, 3, 2, 1};
  diagnosis.penumbra.width_octaves = Spread{0.1, -0.2, 0.3, 0.15, 0.05, 7};
  diagnosis.penumbra.offset_world = Spread{0.01, -0.02, 0.03, 0.02, 0.005, 7};
  diagnosis.penumbra.offset_widths = Spread{0.1, -0.2, 0.3, 0.2, 0.05, 7};
  diagnosis.contact_hardening = {9, 2.5, 0.75, std::nullopt, 0.5};
  for (size_t k = 0; k < kFaultClasses; ++k) {
    diagnosis.faults.by_class[k] = {10 + k, 20 + k, static_cast<double>(k) / 64.0};
  }
  diagnosis.faults.scored_pixels = 99;
  diagnosis.faults.mean_abs_error = 0.5;
  diagnosis.faults.peter_panning_gap_world = 0.25;
  run.fault_picture_file = "faults.png";
  Results results;
  results.scenes.resize(1);
  results.scenes[0].techniques.push_back(run);
  const Results read = parse_results(to_json_text(results), "results.json");
  EXPECT_EQ(read.scenes[0].techniques[0].fault_picture_file, "faults.png");
  const Diagnosis& back = *read.scenes[0].techniques[0].diagnosis;
  EXPECT_EQ(back.penumbra.outcomes, diagnosis.penumbra.outcomes);
  EXPECT_EQ(back.penumbra.rejected(), 28u);  // 7 + 6 + ... + 1
  EXPECT_EQ(back.penumbra.width_octaves->p5, -0.2);
  EXPECT_EQ(back.penumbra.width_octaves->rmse_se, 0.05);
  EXPECT_EQ(back.penumbra.width_octaves->count, 7u);
  EXPECT_EQ(back.penumbra.offset_world->p95, 0.03);
  EXPECT_EQ(back.penumbra.offset_widths->p95, 0.3);
  EXPECT_FALSE(back.penumbra.width_10_90_octaves);
  EXPECT_EQ(back.contact_hardening.slope, 0.75);
  EXPECT_FALSE(back.contact_hardening.intercept_octaves);
  EXPECT_EQ(back.contact_hardening.octaves, 2.5);
  EXPECT_EQ(back.contact_hardening.slope_margin, 0.5);
  for (size_t k = 0; k < kFaultClasses; ++k) {
    EXPECT_EQ(back.faults.by_class[k].pixels, 10 + k);
    EXPECT_EQ(back.faults.by_class[k].components, 20 + k);
    EXPECT_EQ(back.faults.by_class[k].mean_abs_error, static_cast<double>(k) / 64.0);
  }
  EXPECT_EQ(back.faults.scored_pixels, 99u);
  EXPECT_EQ(back.faults.mean_abs_error, 0.5);
  EXPECT_EQ(back.faults.peter_panning_gap_world, 0.25);
}

TEST(Results, HaveNullWhereThereIsNoDiagnosis) {
  const TemporaryFolder folder;
  const auto json = nlohmann::json::parse(to_json_text(fake_results(folder.path())));
  const auto& broken = json["scenes"][0]["techniques"][2];
  for (const char* key : {"penumbra", "contact_hardening", "faults"}) {
    ASSERT_TRUE(broken.contains(key)) << key;
    EXPECT_TRUE(broken[key].is_null()) << key;
  }
}

TEST(Results, CarryTheirContext) {
  const TemporaryFolder folder;
  const auto json = nlohmann::json::parse(to_json_text(fake_results(folder.path())));
  for (const char* key : {"schema", "version", "commit", "quality", "width_px", "height_px", "seed",
                          "samples_per_pixel", "target_se", "parity_passes", "scenes", "skipped"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  const auto& run = json["scenes"][0]["techniques"][1];
  EXPECT_EQ(run["parameters"]["taps"], 16);
  EXPECT_EQ(run["timer"], "fake clock");
  EXPECT_EQ(run["pass_times"][0]["frames"], 5);
  EXPECT_EQ(json["scenes"][0]["hash"], "0123456789abcdef");
}

TEST(Results, AnythingElseIsOneSentence) {
  EXPECT_THAT([] { parse_results("{", "a/results.json"); },
              ThrowsMessage<Error>(HasSubstr("a/results.json: not a results file")));
  EXPECT_THAT([] { parse_results("{\"schema\": 4}", "r.json"); },
              ThrowsMessage<Error>(HasSubstr("not a results file")));
  EXPECT_THAT(
      [] { parse_results("{\"schema\": 99}", "r.json"); },
      ThrowsMessage<Error>(HasSubstr("r.json: results of schema 99; this version reads 4 (run 'umbrameter")));
}

TEST(Results, OfAWrongTypeAreBadInputAndNothingWorse) {
  const TemporaryFolder folder;
  const auto json = nlohmann::json::parse(to_json_text(fake_results(folder.path())));
  const auto leaves = json.flatten();
  size_t rejected = 0;
  for (const auto& [path, leaf] : leaves.items()) {
    auto broken = json;
    broken[nlohmann::json::json_pointer(path)] = {{"an", "object"}};
    try {
      parse_results(broken.dump(), "r.json");  // anything but Error fails the test
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input) << path;
      ++rejected;
    }
  }
  EXPECT_GT(rejected, 100u);
}

TEST(TotalTime, IsWhatTheRendererSaysAndNotASumWithItself) {
  EXPECT_FALSE(total_time({}));
  const auto total = total_time({{"map", 1.5, 0.1, 9}, {"resolve", 2.0, 0.2, 9}, {"total", 3.6, 0.15, 9}});
  EXPECT_DOUBLE_EQ(total->median_ms, 3.6);
  EXPECT_DOUBLE_EQ(total->mad_ms, 0.15);
}

TEST(RegionRmse, KeepsTheSignAndKnowsEmptyRegions) {
  EXPECT_FALSE(region_rmse({}));
  EXPECT_DOUBLE_EQ(*region_rmse({.pixels = 4, .share = 1.0, .mse = 0.04, .bias = 0.0}), 0.2);
  EXPECT_DOUBLE_EQ(*region_rmse({.pixels = 4, .share = 1.0, .mse = -0.04, .bias = 0.0}), -0.2);
}

TEST(Format, NeverRoundsAShareUpToAllOfIt) {
  EXPECT_EQ(format_share(0.9999999), "99.999 %");
  EXPECT_EQ(format_share(1.0), "100.000 %");
}

TEST(Format, SaysWhenThereIsNothing) {
  EXPECT_EQ(format_error(std::nullopt), "n/a");
  EXPECT_EQ(format_interval(std::nullopt), "n/a");
  EXPECT_EQ(format_time(std::nullopt), "n/a");
}

TEST(Format, GivesASpreadOnlyToSeveralFrames) {
  EXPECT_EQ(format_time(PassTime{"total", 12.3456, 0.512, 9}), "12.35 ± 0.512 ms (9 frames)");
  EXPECT_EQ(format_time(PassTime{"total", 32040.4, 99.0, 3}), "32040 ± 99 ms (3 frames)");
  EXPECT_EQ(format_time(PassTime{"total", 1.25, 0.0, 1}), "1.25 ms (1 frame)");
}

}  // namespace
}  // namespace umbrameter
