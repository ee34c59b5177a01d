// SPDX-License-Identifier: Apache-2.0
// Without these, a metric could be missing from a file, or stand under two names.

#include "results/catalogue.h"

#include "results/csv.h"
#include "results/json/export.h"
#include "results/json/run_json.h"
#include "results/regress/case_numbers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace umbrameter {
namespace {

using ::testing::HasSubstr;

/// A run with a value for every row, each another one.
TechniqueResult measured_run() {
  TechniqueResult run;
  run.label = run.technique = "one";
  run.error.emplace();
  run.error->rmse = Interval{0.5, 0.4, 0.6};
  run.error->bias = -0.25;
  run.error->mae = 0.125;
  run.error->over_shadowing = 0.0625;
  run.error->under_shadowing = 0.03125;
  run.error->max_error = 0.75;
  run.error->penumbra = {10, 0.5, 0.09, 0.0};
  run.error->lit = {10, 0.5, 0.04, 0.0};
  run.error->umbra = {10, 0.5, 0.01, 0.0};
  run.lit_rmse = 0.875;
  run.judgement.significance = SignificanceNumbers{8, 1, 1, {}, 0, {}, {}};
  run.diagnosis.emplace();
  run.diagnosis->penumbra.width_octaves = Spread{.median = 1.5};
  run.diagnosis->penumbra.offset_widths = Spread{.median = -0.1};
  run.diagnosis->penumbra.offset_world = Spread{.median = -0.01};
  run.diagnosis->contact_hardening.slope = 0.9;
  run.diagnosis->causes.noise = 0.011;
  run.diagnosis->causes.banding = 0.022;
  for (size_t k = 0; k < kFaultClasses; ++k)
    run.diagnosis->faults.by_class[k].mean_abs_error = 0.001 * static_cast<double>(k);
  run.similarity = Similarity{60.0, 0.21, 0.22, 0.23, 0.24, 0.25, 0.97, 31.0};
  run.temporal.emplace();
  run.temporal->camera.excess = 0.003;
  run.temporal->light.rms = 0.004;
  run.temporal->seed_noise = 0.005;
  run.pass_times = {{"total", 2.5, 0.1, 9}};
  run.memory_bytes = 1 << 20;
  for (const Metric& metric : metric_catalogue()) {
    if (metric.measure) run.measured[metric.key] = 0.375;
  }
  return run;
}

TEST(Catalogue, HasEveryKeyOnceAndSaysWhatItIs) {
  std::set<std::string> keys, labels;
  for (const Metric& metric : metric_catalogue()) {
    EXPECT_TRUE(keys.insert(metric.key).second) << metric.key;
    EXPECT_TRUE(labels.insert(metric.label).second) << metric.label;
    EXPECT_FALSE(metric.group.empty() || metric.doc.empty()) << metric.key;
    EXPECT_TRUE(metric.of) << metric.key;
    EXPECT_EQ(find_metric(metric.key), &metric);
  }
  EXPECT_EQ(find_metric("no such metric"), nullptr);
}

TEST(Catalogue, FindsEveryNumberOfARunAndNoneOfAnEmptyOne) {
  const TechniqueResult full = measured_run(), empty;
  for (const Metric& metric : metric_catalogue()) {
    EXPECT_TRUE(metric.of(full)) << metric.key;
    EXPECT_FALSE(metric.of(empty)) << metric.key;
    EXPECT_EQ(format_metric(metric, empty), "n/a") << metric.key;
  }
  EXPECT_DOUBLE_EQ(*find_metric("penumbra.rmse")->of(full), 0.3);
  EXPECT_DOUBLE_EQ(*find_metric("wrong_share")->of(full), 0.25);
  EXPECT_DOUBLE_EQ(*find_metric("fault.acne")->of(full), 0.001 * static_cast<double>(FaultClass::acne));
  EXPECT_DOUBLE_EQ(*find_metric("worst_fault_error")->of(full), 0.001 * (kFaultClasses - 1));
}

TEST(Catalogue, IsWhatFilesHoldOfARun) {
  const TechniqueResult run = measured_run();
  const nlohmann::ordered_json json = technique_json(run);
  StoredRuns stored;
  stored.runs.emplace_back();
  stored.runs.back().result = run;
  const std::string csv = to_csv(stored);
  for (const Metric& metric : metric_catalogue()) {
    EXPECT_EQ(json["measurements"][metric.key].get<double>(), *metric.of(run)) << metric.key;
    EXPECT_THAT(csv.substr(0, csv.find('\n')), HasSubstr("," + metric.key + ",")) << metric.key;
    EXPECT_THAT(csv, HasSubstr("," + csv_number(*metric.of(run)))) << metric.key;
  }
  const TechniqueResult read = read_technique(nlohmann::json::parse(json.dump()));
  for (const Metric& metric : metric_catalogue()) EXPECT_EQ(metric.of(read), metric.of(run)) << metric.key;
}

TEST(Catalogue, ARunWithoutAScoredPixelIsVoid) {
  TechniqueResult run = measured_run();
  run.failure = Failure{ErrorKind::input, "does not compile"};
  RunRecord record;
  record.result = run;
  EXPECT_EQ(status_of(record), "failed");
  record.result.failure.reset();
  record.result.error->scored_pixels = 0;
  EXPECT_EQ(status_of(record), "void");
}

TEST(Catalogue, RowsMeasuredFromPicturesStandInBaselines) {
  for (const Metric& metric : metric_catalogue()) {
    const bool is_named = std::ranges::find(measure_names(), metric.key) != measure_names().end();
    EXPECT_TRUE(is_named || !metric.measure) << metric.key;
  }
}

TEST(Catalogue, CarriesWhatGatesAndTheTunerMakeOfARow) {
  const GateLimits limits = gate_limits();
  std::map<std::string, double> terms;
  for (const Metric& metric : metric_catalogue()) {
    if (metric.term) terms[metric.term->name] += 1.0;
    if (!metric.gate) continue;
    EXPECT_GT(metric.gate->limit.excess, 0.0) << metric.key << ": any noise exceeds it";
    EXPECT_NE(metric.better, Better::higher) << metric.key << ": shares of it say nothing";
    EXPECT_EQ(limits.further.contains(metric.key), metric.gate->kind == GateClass::measured) << metric.key;
  }
  EXPECT_EQ(find_metric("fault.acne")->gate->kind, GateClass::acne);
  EXPECT_EQ(find_metric("fault.overlap")->gate->kind, GateClass::softness);
  EXPECT_DOUBLE_EQ(find_metric("fault.resolution")->gate->limit.share, GateLimits{}.resolution.share);
  EXPECT_DOUBLE_EQ(find_metric("rmse")->gate->limit.excess, GateLimits{}.error.excess);
  EXPECT_EQ(terms, (std::map<std::string, double>{{"acne", 1}, {"leaks", 4}, {"edges", 1}, {"widths", 1}}));
}

TEST(Catalogue, SaysHowFarANumberIsFromRight) {
  const TechniqueResult run = measured_run();
  EXPECT_DOUBLE_EQ(*badness(*find_metric("rmse"), run), 0.5);
  EXPECT_DOUBLE_EQ(*badness(*find_metric("bias"), run), 0.25);
  EXPECT_NEAR(*badness(*find_metric("contact_hardening_slope"), run), 0.1, 1e-12);
  EXPECT_DOUBLE_EQ(*badness(*find_metric("psnr_db"), run), -31.0);
  EXPECT_FALSE(badness(*find_metric("rmse"), {}));
}

TEST(Catalogue, ARowThatAGateLooksAtIsRememberedByBaselines) {
  GateRun run;
  run.error.emplace();
  run.error->mse = Interval{0.01, 0.01, 0.01};
  run.measured = gate_measures(measured_run());
  EXPECT_DOUBLE_EQ(run.measured.at("worst_pixels_rmse"), 0.375);
  EXPECT_FALSE(run.measured.contains("rmse")) << "a class stands for it";
  EXPECT_FALSE(run.measured.contains("psnr_db"));
  EXPECT_EQ(gate_run_of(*case_numbers(run)).measured, run.measured);
}

TEST(Catalogue, WritesNumbersAsPeopleReadThem) {
  const TechniqueResult run = measured_run();
  EXPECT_EQ(format_metric(*find_metric("rmse"), run), "0.50000 [0.40000, 0.60000]");
  EXPECT_EQ(format_metric(*find_metric("bias"), run), "-0.25000");
  EXPECT_EQ(format_metric(*find_metric("width_octaves"), run), "2.83 x");
  EXPECT_EQ(format_metric(*find_metric("psnr_db"), run), "31.0 dB");
  EXPECT_EQ(format_metric(*find_metric("memory_bytes"), run), "1.0 MiB");
}

TEST(Catalogue, LinesOfAGroupAreThoseThatWereMeasured) {
  TechniqueResult run = measured_run();
  run.error->bias.reset();
  const TermLines lines = metric_lines(run, "error");
  ASSERT_FALSE(lines.empty());
  EXPECT_EQ(lines.front(), std::pair(std::string("RMSE [95 %]"), std::string("0.50000 [0.40000, 0.60000]")));
  for (const auto& [label, text] : lines) EXPECT_TRUE(label != "mean error" && text != "n/a") << label;
  EXPECT_TRUE(metric_lines({}, "error").empty());
}

TEST(Catalogue, AnInfinitePsnrIsNoNumber) {
  TechniqueResult run = measured_run();
  run.similarity->psnr_db = INFINITY;
  EXPECT_FALSE(find_metric("psnr_db")->of(run));
}

}  // namespace
}  // namespace umbrameter
