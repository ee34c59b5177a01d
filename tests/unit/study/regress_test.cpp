// SPDX-License-Identifier: Apache-2.0
// Without these, a regression could forget numbers on their way through its file, fail without a reason, or pass with one.

#include "core/error.h"
#include "metrics/statistics/seed_noise.h"
#include "report/regress_output.h"
#include "results/regress/parameter_changes.h"
#include "study/regress/run.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace umbrameter {
namespace {

using testing::HasSubstr;

CaseNumbers numbers_of(double mse) {
  CaseNumbers numbers;
  numbers.scored_pixels = 1000;
  numbers.mse = {mse, 0.8 * mse, 1.2 * mse};
  numbers.noise_sd = 1e-5;
  numbers.measures = {{"acne", 1e-4},          {"penumbra", 5e-4},
                      {"noise", 0.01},         {"reference_noise", 0.005},
                      {"width_octaves", 0.25}, {"banding", 0.125}};
  return numbers;
}

Baseline small_baseline() {
  BaselineScene scene = {"plate", "abc", {"def", "Embree", 7, 64.0, {0.75, 1e-4}, {0.125, 2e-4}}, {}};
  put_run(scene,
          {"b \"quoted\"", "pcss", "2", "a=1", "llvmpipe", numbers_of(0.001), BaselineTime{1.5, 0.25, 9}});
  put_run(scene, {"a", "hard", "1", "", "llvmpipe", numbers_of(0.002), {}});
  return {"suite", 192, 108, {{"2026-01-02", "first\nline", "0.1", {"plate, a"}}}, {scene}};
}

TEST(RegressBaseline, SaysTheSameAfterItsText) {
  const std::string text = to_toml_text(small_baseline());
  const Baseline read = parse_baseline(text, "b.toml");
  EXPECT_EQ(to_toml_text(read), text);
  ASSERT_EQ(read.scenes.size(), 1u);
  ASSERT_EQ(read.scenes[0].runs.size(), 2u);
  const BaselineRun& run = read.scenes[0].runs[1];
  EXPECT_EQ(run.label, "b \"quoted\"");
  EXPECT_DOUBLE_EQ(run.numbers.mse.value, 0.001);
  EXPECT_DOUBLE_EQ(run.numbers.measures.at("width_octaves"), 0.25);
  EXPECT_DOUBLE_EQ(run.time->mad_ms, 0.25);
  EXPECT_DOUBLE_EQ(read.scenes[0].truth.penumbra.sd, 2e-4);
  EXPECT_EQ(read.reasons[0].text, "first\nline");
}

TEST(RegressBaseline, NamesPlaceAndKeyOfWhatIsWrong) {
  std::string text = to_toml_text(small_baseline());
  text.replace(text.find("noise_sd"), 8, "noise_ds");
  try {
    parse_baseline(text, "b.toml");
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("b.toml:"));
    EXPECT_THAT(error.what(), HasSubstr("noise_sd"));
  }
}

TEST(RegressNumbers, TheGateSeesWhatItSawOfTheRun) {
  const CaseNumbers numbers = numbers_of(0.001);
  const GateVerdict verdict = judge_gate(gate_run_of(numbers), nullptr, false);
  std::map<std::string, double> seen;
  for (const GateMeasure& m : verdict.measures) {
    if (m.value) seen[std::string(name_of(m.kind))] += *m.value;
  }
  EXPECT_DOUBLE_EQ(seen["acne"], 1e-4);
  EXPECT_DOUBLE_EQ(seen["softness"], 5e-4 + 0.25);  // a share of the error and a width
  EXPECT_DOUBLE_EQ(seen["noise"], 0.01 - 0.005);
  EXPECT_DOUBLE_EQ(seen["banding"], 0.125);
  EXPECT_DOUBLE_EQ(seen["error"], std::sqrt(0.001));
  EXPECT_FALSE(seen.contains("hardening"));
}

TEST(RegressNumbers, SeedsAverageOutAndTheTruthDoesNot) {
  std::vector<CaseNumbers> pictures(4, numbers_of(0.001));
  for (CaseNumbers& one : pictures) one.seed_sd = 2e-5;
  pictures[1].measures.erase("banding");
  const CaseNumbers mean = mean_of(pictures);
  EXPECT_DOUBLE_EQ(mean.seed_sd, 1e-5);
  EXPECT_DOUBLE_EQ(mean.noise_sd, 1e-5);
  EXPECT_DOUBLE_EQ(mean.measures.at("acne"), 1e-4);
  EXPECT_FALSE(mean.measures.contains("banding"));
}

TEST(RegressParameters, OnlyWhatDiffersIsSaid) {
  EXPECT_EQ(parameter_changes("bias=0.5 fit=scene taps=16", "bias=0.5 kernel=disk taps=25"),
            "kernel is new and disk, taps was 16 and is 25, fit (scene) is gone");
  EXPECT_EQ(parameter_changes("bias=0.5", "bias=0.5"), "");
}

TEST(RegressJudge, TheRatchetTellsWorseFromNoise) {
  // Margin: 5 % of .001 and 1e-6 for an RMSE of .001; noise: 4 sqrt(2) 1e-5 = 5.66e-5.
  const CaseNumbers before = numbers_of(0.001);
  EXPECT_EQ(judge_case(numbers_of(0.00105), before, {}).outcome, CaseOutcome::pass);
  EXPECT_EQ(judge_case(numbers_of(0.00110), before, {}).outcome, CaseOutcome::undecided);
  EXPECT_EQ(judge_case(numbers_of(0.00112), before, {}).outcome, CaseOutcome::fail);
  EXPECT_EQ(judge_case(numbers_of(0.00112), before, {}).kind, "ratchet");
  EXPECT_EQ(judge_case(numbers_of(0.00088), before, {}).outcome, CaseOutcome::better);
  RegressGates no_ratchet;
  no_ratchet.ratchet = false;
  EXPECT_EQ(judge_case(numbers_of(0.00112), before, no_ratchet).outcome, CaseOutcome::pass);
}

TEST(RegressJudge, AFaultIsNamed) {
  CaseNumbers now = numbers_of(0.001);
  now.measures["acne"] = 1e-3;
  const CaseVerdict verdict = judge_case(now, numbers_of(0.001), {});
  EXPECT_EQ(verdict.outcome, CaseOutcome::fail);
  EXPECT_EQ(verdict.kind, "acne");
  EXPECT_THAT(verdict.message, HasSubstr("0.001"));
}

TEST(RegressJudge, AMetricWithALimitIsNamedByItsKey) {
  CaseNumbers now = numbers_of(0.001), before = now;
  before.measures["worst_pixels_rmse"] = 0.2;
  now.measures["worst_pixels_rmse"] = 0.4;
  EXPECT_EQ(judge_case(now, before, {}).outcome, CaseOutcome::pass);
  RegressGates gates;
  gates.worse_by.further["worst_pixels_rmse"] = {Better::lower, {0.05, 0.25}};
  const CaseVerdict verdict = judge_case(now, before, gates);
  EXPECT_EQ(verdict.kind, "worst_pixels_rmse");
  EXPECT_THAT(verdict.message, HasSubstr("worst_pixels_rmse is 0.4, 2.0 times what may be added"));
}

TEST(RegressJudge, ALimitHoldsWhateverTheBaselineSays) {
  RegressGates gates;
  gates.at_most = {{"acne", 5e-5}};
  EXPECT_EQ(judge_case(numbers_of(0.001), numbers_of(0.001), gates).kind, "limit");
  gates.at_most = {{"rmse", 0.0316}};  // within [.0283, .0346]
  EXPECT_EQ(judge_case(numbers_of(0.001), numbers_of(0.001), gates).outcome, CaseOutcome::undecided);
  gates.at_most = {{"rmse", 0.02}};
  EXPECT_EQ(judge_case(numbers_of(0.001), numbers_of(0.001), gates).outcome, CaseOutcome::fail);
}

TEST(RegressJudge, WhatIsLimitedAndWasNotMeasuredFails) {
  RegressGates gates;
  gates.at_most = {{"hardening_slope", 2.0}};
  const CaseVerdict verdict = judge_case(numbers_of(0.001), numbers_of(0.001), gates);
  EXPECT_EQ(verdict.outcome, CaseOutcome::fail);
  EXPECT_THAT(verdict.message, HasSubstr("hardening_slope has a limit of 2 and was not measured"));
}

TEST(RegressJudge, TimesMayGrowByTheirRatioAndNoise) {
  const BaselineTime before = {10.0, 0.5, 9};
  EXPECT_FALSE(judge_time({12.0, 0.5, 9}, before, 1.1));
  const auto late = judge_time({15.0, 0.5, 9}, before, 1.1);
  ASSERT_TRUE(late);
  EXPECT_EQ(late->kind, "time");
}

Image flat_truth(float visibility, float se, float samples) {
  Image truth(32, 32);
  for (const char* channel : {"visibility", "half_a", "half_b"}) truth.add_plane(channel, visibility);
  truth.add_plane("visibility_se", se);
  truth.add_plane("sample_count", samples);
  truth.add_plane("primitive_id", 0.0f);
  return truth;
}

TEST(RegressTruth, MoreSamplesWeighByTheirNumber) {
  Image truth = flat_truth(0.4f, 0.03f, 64.0f);
  add_samples(truth, flat_truth(0.8f, 0.01f, 192.0f));
  EXPECT_FLOAT_EQ(truth.plane("visibility")[5], 0.7f);
  EXPECT_FLOAT_EQ(truth.plane("half_b")[5], 0.7f);
  EXPECT_FLOAT_EQ(truth.plane("sample_count")[5], 256.0f);
  EXPECT_FLOAT_EQ(truth.plane("visibility_se")[5], std::hypot(0.25f * 0.03f, 0.75f * 0.01f));
}

TEST(RegressTruth, AnotherTruthIsNoticedBeyondNoise) {
  const TruthNumbers before = truth_numbers(flat_truth(0.50f, 0.032f, 64.0f), "x", 1);
  EXPECT_DOUBLE_EQ(before.penumbra.value, 0.25);
  EXPECT_NEAR(before.visibility.sd, 0.001, 1e-6);  // .032 / sqrt(1024)
  EXPECT_FALSE(truth_difference(truth_numbers(flat_truth(0.505f, 0.032f, 64.0f), "x", 2), before, 4.0));
  EXPECT_TRUE(truth_difference(truth_numbers(flat_truth(0.507f, 0.032f, 64.0f), "x", 2), before, 4.0));
}

TEST(RegressSeeds, NoiseIsOfTheMeanSquaredError) {
  const Image truth = flat_truth(0.5f, 0.0f, 64.0f);
  Image one = truth, other = truth;
  const std::vector<uint8_t> mask(one.pixel_count(), 1);
  EXPECT_EQ(seed_noise_of_mse(std::vector<Image>{one, other}, truth, mask), 0.0);
  std::fill(other.planes["visibility"].begin(), other.planes["visibility"].end(), 0.6f);
  // One tile with mean squares 0 and .01: a standard deviation of .01 / sqrt(2).
  EXPECT_NEAR(seed_noise_of_mse(std::vector<Image>{one, other}, truth, mask), 0.01 / std::sqrt(2.0), 1e-8);
}

RegressResults some_results() {
  RegressResults results = {"suite", 10, 10, 1, {}, {}, {}};
  RegressCase fails;
  fails.scene = "a<b";
  fails.label = "x,y:\"z\"";
  fails.verdict = not_compared("acne", "50 % & \x01 \xff\nsecond line");
  RegressCase unsure;
  unsure.scene = "plate";
  unsure.label = "pcss";
  unsure.verdict.outcome = CaseOutcome::undecided;
  unsure.verdict.kind = "ratchet";
  unsure.verdict.message = "perhaps";
  results.cases = {fails, unsure};
  return results;
}

TEST(RegressOutput, JunitIsReadByAnXmlReader) {
  TemporaryFolder folder;
  std::ofstream(folder.path() / "j.xml", std::ios::binary) << junit_xml(some_results());
  const char* script =
      "import sys, xml.etree.ElementTree as e\n"
      "r = e.parse(sys.argv[1]).getroot()\n"
      "f = r.find('testsuite/testcase/failure')\n"
      "print(r.get('tests'), r.get('failures'), len(r), f.get('type'), r[0].get('name'), "
      "r[0][0].get('name'))";
  const ProcessResult result = run_process({"python3", "-c", script, (folder.path() / "j.xml").string()}, {});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "2 1 2 acne a<b x,y:\"z\"\n");
}

TEST(RegressOutput, AnnotationsEscapeWhatGithubWouldRead) {
  const std::string text = github_annotations(some_results());
  EXPECT_THAT(text, HasSubstr("::error title=a<b%2C x%2Cy%3A\"z\"%3A acne::50 %25 & "));
  EXPECT_THAT(text, HasSubstr("%0Asecond line\n"));
  EXPECT_THAT(text, HasSubstr("::warning title=plate%2C pcss%3A ratchet::perhaps\n"));
}

TEST(RegressOutput, TheTableNamesVerdicts) {
  EXPECT_THAT(regress_markdown(some_results()), HasSubstr("| plate | pcss | undecided: ratchet |"));
}

TEST(RegressSuiteFile, ReadsGatesAndRefusesWhatItDoesNotKnow) {
  const std::string head = "schema = 1\ntitle = \"t\"\nscenes = [\"plate\"]\n";
  const std::string run = "[[run]]\nlabel = \"hard\"\ntechnique = \"hard\"\n";
  const RegressSuite suite = parse_suite(
      head + run +
          "[gates]\nratchet = false\nat_most = { acne = 1e-3 }\nworse_by = { noise = { excess = 0.1 } }\n",
      "s.toml");
  EXPECT_FALSE(suite.gates.ratchet);
  EXPECT_DOUBLE_EQ(suite.gates.at_most.at("acne"), 1e-3);
  EXPECT_DOUBLE_EQ(suite.gates.worse_by.noise.excess, 0.1);
  EXPECT_DOUBLE_EQ(suite.gates.worse_by.noise.share, GateLimits{}.noise.share);
  const auto message_of = [&](const std::string& gates) {
    try {
      parse_suite(head + run + gates, "s.toml");
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const RegressSuite rows =
      parse_suite(head + run + "[gates.worse_by.worst_pixels_rmse]\nexcess = 0.05\nshare = 0.25\n", "s.toml");
  EXPECT_DOUBLE_EQ(rows.gates.worse_by.further.at("worst_pixels_rmse").limit.share, 0.25);
  EXPECT_THAT(message_of("[gates.worse_by.worst_pixels_rmse]\nshare = 0.25\n"), HasSubstr("'excess' is 0"));
  EXPECT_THAT(message_of("[gates.worse_by.psnr_db]\nexcess = 1.0\n"), HasSubstr("psnr_db"));
  EXPECT_THAT(message_of("[gates]\nrachet = true\n"), HasSubstr("rachet"));
  EXPECT_THAT(message_of("[gates.at_most]\nacme = 1.0\n"), HasSubstr("acme"));
  EXPECT_THAT(message_of("[gates]\nsigmas = 0.5\n"), HasSubstr("less than 1"));
}

}  // namespace
}  // namespace umbrameter
