// SPDX-License-Identifier: Apache-2.0
// Without these a stress run could call noise a break, name the wrong value, or lose what happened before a crash.

#include "report/stress_output.h"
#include "results/stress/journal.h"
#include "study/stress/axes.h"
#include "study/stress/judge.h"
#include "study/stress/kept_cells.h"
#include "study/stress/suite_file.h"
#include "tests/support/lab/fakes.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <set>

namespace umbrameter {
namespace {

using testing::HasSubstr;
using enum StressOutcome;

StressMeasure measured(double low, double value, double high) {
  StressMeasure measure;
  measure.run.error = VisibilityError{};
  measure.run.error->rmse = Interval{value, low, high};
  measure.run.diagnosis = Diagnosis{};
  measure.scored_pixels = 100;
  return measure;
}

TEST(StressRule, worse_means_certainly_beyond_twice_the_nominal_error) {
  const StressMeasure nominal = measured(0.03, 0.04, 0.05);
  EXPECT_EQ(judge_stress(measured(0.08, 0.12, 0.20), &nominal).outcome, ok);  // its low end may be 2 x 0.05
  EXPECT_EQ(judge_stress(measured(0.11, 0.12, 0.20), &nominal).outcome, worse);
  EXPECT_EQ(judge_stress(measured(0.11, 0.12, 0.20), &nominal).how, "error");
}

TEST(StressRule, small_errors_are_none) {
  const StressMeasure nominal = measured(0.0, 0.0, 0.0);
  EXPECT_EQ(judge_stress(measured(0.015, 0.016, 0.019), &nominal).outcome, ok);
  EXPECT_EQ(judge_stress(measured(0.021, 0.022, 0.023), &nominal).outcome, worse);
}

TEST(StressRule, the_fault_is_named) {
  const StressMeasure nominal = measured(0.01, 0.01, 0.01);
  StressMeasure leaking = measured(0.3, 0.4, 0.5);
  leaking.run.diagnosis->faults.by_class[static_cast<size_t>(FaultClass::geometric_leak)].mean_abs_error =
      0.1;
  const StressCell cell = judge_stress(leaking, &nominal);
  EXPECT_EQ(cell.how, "geometric_leak");
  EXPECT_EQ(words_for(cell.outcome, cell.how), "leak");
}

TEST(StressRule, what_cannot_be_judged_is_not) {
  const StressMeasure nominal = measured(0.01, 0.01, 0.01);
  EXPECT_EQ(judge_stress(measured(0.3, 0.4, 0.5), nullptr).outcome, unjudged);
  StressMeasure dark = nominal;
  dark.run.error->rmse.reset();
  EXPECT_EQ(judge_stress(dark, &nominal).outcome, nothing);
  StressMeasure broken;
  broken.run.failure = Failure{ErrorKind::input, "channel 'visibility' is nan"};
  EXPECT_EQ(judge_stress(broken, &nominal).outcome, bad_value);
}

TEST(StressOutcomes, failures_are_told_apart) {
  EXPECT_EQ(outcome_of({ErrorKind::input, "technique 'x' gives visibility nan at pixel (1, 2)"}), bad_value);
  EXPECT_EQ(outcome_of({ErrorKind::input, "'map_size' = 8 is too small"}), refused);
  EXPECT_EQ(outcome_of({ErrorKind::internal, "pass: OpenGL reported GL_INVALID_VALUE"}), gl_error);
  EXPECT_EQ(outcome_of({ErrorKind::internal, "assertion"}), bug);
  EXPECT_EQ(outcome_of({ErrorKind::environment, "64 MiB do not fit"}), environment);
}

TEST(StressOutcomes, names_go_there_and_back) {
  std::set<std::string_view> names;
  for (size_t k = 0; k < kStressOutcomes; ++k) {
    const auto outcome = static_cast<StressOutcome>(k);
    names.insert(name_of(outcome));
    EXPECT_EQ(stress_outcome(name_of(outcome)), outcome);
  }
  EXPECT_EQ(names.size(), kStressOutcomes);
}

StressCell cell_of(size_t value, StressOutcome outcome, const std::string& row = "hard") {
  StressCell cell;
  cell.axis = "x";
  cell.row = row;
  cell.value = value;
  cell.outcome = outcome;
  cell.how = outcome == worse ? "acne" : "";
  return cell;
}

/// An axis of seven values, the middle one nominal.
StressResults results_of(const std::vector<StressOutcome>& outcomes) {
  StressResults results;
  StressAxis axis;
  axis.name = "x";
  axis.values = numbers({1, 2, 3, 4, 5, 6, 7});
  axis.nominal = 3;
  results.plan.axes = {axis};
  results.rows = {"hard"};
  for (size_t value = 0; value < outcomes.size(); ++value)
    results.cells.push_back(cell_of(value, outcomes[value]));
  return results;
}

std::string range_of_seven(const std::vector<StressOutcome>& outcomes) {
  const StressResults results = results_of(outcomes);
  return range_text(range_of(results, results.plan.axes[0], "hard"), results.plan.axes[0]);
}

TEST(StressRange, ends_at_the_first_break_on_either_side) {
  EXPECT_EQ(range_of_seven({ok, ok, ok, ok, ok, ok, ok}), "all");
  EXPECT_EQ(range_of_seven({ok, ok, ok, ok, ok, worse, ok}), "1 to 5; acne at 6");
  EXPECT_EQ(range_of_seven({ok, crash, ok, ok, worse, worse, ok}), "3 to 4; crash at 2; acne at 5");
  EXPECT_EQ(range_of_seven({ok, ok, bad_value, ok, hang, ok, ok}), "4; bad value at 3; hang at 5");
}

TEST(StressRange, silent_values_neither_break_nor_widen) {
  EXPECT_EQ(range_of_seven({rightly_refused, nothing, ok, ok, ok, nothing, rightly_refused}), "all");
  const StressResults results = results_of({nothing, nothing, ok, ok, ok, nothing, worse});
  const StressRange range = range_of(results, results.plan.axes[0], "hard");
  EXPECT_EQ(range.first, 2u);
  EXPECT_EQ(range.last, 4u);
  EXPECT_EQ(range.after->value, 6u);
  EXPECT_EQ(range.values, 4u);
  EXPECT_EQ(range.held, 3u);
}

TEST(StressRange, without_a_nominal_value_nothing_applies) {
  const StressResults results = results_of({ok, ok, ok, refused, ok, ok, ok});
  EXPECT_FALSE(range_of(results, results.plan.axes[0], "hard").applies);
}

TEST(StressRules, broken_ones_fail_the_run) {
  EXPECT_TRUE(results_of({ok, worse, other_surfaces, ok, environment, nothing, rightly_refused}).passes());
  for (const StressOutcome outcome : {accepted, wrong_truth, bad_value, gl_error, bug, crash, hang})
    EXPECT_FALSE(results_of({ok, ok, ok, ok, outcome, ok, ok}).passes()) << name_of(outcome);
  EXPECT_FALSE(results_of({ok, ok, ok, ok, refused, ok, ok}).passes());  // without a sentence
}

TEST(StressJournal, keeps_what_was_done_and_what_was_begun) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "journal.jsonl";
  EXPECT_TRUE(read_journal(file).cells.empty());
  {
    JournalWriter writer(file);
    writer.start({"truth", 2});
    StressCell cell = cell_of(2, worse, "truth");
    cell.rmse = Interval{0.2, 0.1, 0.3};
    cell.warnings = {"a", "b"};
    writer.finish(cell);
    writer.start({"hard", 2});
  }
  std::ofstream(file, std::ios::app) << "{\"start\": \"pcss\", \"val";
  JournalWriter(file).finish(cell_of(3, crash));  // by whom saw the end of it
  ASSERT_EQ(read_journal(file).cells.size(), 2u);
  EXPECT_FALSE(read_journal(file).open);
  JournalWriter(file).start({"hard", 2});
  const JournalState state = read_journal(file);
  EXPECT_EQ(state.cells[0].rmse->high, 0.3);
  EXPECT_EQ(state.cells[0].warnings.size(), 2u);
  EXPECT_EQ(state.cells[0].outcome, worse);
  ASSERT_TRUE(state.open);
  EXPECT_EQ(state.open->row, "hard");
  EXPECT_NE(state.find("truth", 2), nullptr);
  EXPECT_EQ(state.find("hard", 2), nullptr);
}

TEST(StressJournal, is_read_while_it_grows) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "journal.jsonl";
  JournalTail tail(file);
  EXPECT_TRUE(tail.take().empty());
  JournalWriter writer(file);
  writer.start({"hard", 0});
  writer.finish(cell_of(0, ok));
  EXPECT_EQ(tail.take().size(), 1u);
  EXPECT_TRUE(tail.take().empty());
  writer.finish(cell_of(1, ok));
  std::ofstream(file, std::ios::app) << "{\"axis\":";  // cut off
  const std::vector<StressCell> cells = tail.take();
  ASSERT_EQ(cells.size(), 1u);
  EXPECT_EQ(cells[0].value, 1u);
}

TEST(StressCells, WhatTheMachineDidIsNotKept) {
  const TemporaryFolder folder;
  LazyStore store(folder.path() / "out");
  Answers answers(store, true);
  StressAxis axis;
  axis.name = "size";
  axis.values = numbers({1.0, 2.0, 3.0});
  const StressKeys keys{
      {.width_px = 8, .height_px = 8, .samples_per_pixel = 4}, {fake_technique("hard")}, {}, false};
  keep_cell(answers, axis, keys, cell_of(0, ok));
  keep_cell(answers, axis, keys, cell_of(1, hang));
  keep_cell(answers, axis, keys, cell_of(2, crash));
  const std::vector<StressCell> cells = kept_cells(answers, axis, keys);
  ASSERT_EQ(cells.size(), 1u);
  EXPECT_EQ(cells[0].row, "hard");
  axis.values.insert(axis.values.begin(), numbers({0.5}).front());
  axis.nominal = 1;
  ASSERT_EQ(kept_cells(answers, axis, keys).size(), 1u);
  EXPECT_EQ(kept_cells(answers, axis, keys)[0].value, 1u) << "its place on the axis as that is now";
  axis.nominal = 2;
  EXPECT_TRUE(kept_cells(answers, axis, keys).empty()) << "it was judged beside another nominal value";
}

TEST(StressAxes, are_well_formed) {
  std::set<std::string> names;
  for (const StressAxis& axis : stress_axes()) {
    EXPECT_TRUE(names.insert(axis.name).second) << axis.name;
    ASSERT_LT(axis.nominal, axis.values.size()) << axis.name;
    EXPECT_FALSE(axis.doc.empty()) << axis.name;
    EXPECT_FALSE(axis.point(axis.values[axis.nominal]).must_be_refused) << axis.name;
    for (const StressValue& value : axis.values) EXPECT_FALSE(axis.point(value).scene.empty()) << axis.name;
    EXPECT_EQ(walking_order(axis).front(), axis.nominal);
  }
  EXPECT_GE(names.size(), 30u);
}

std::string error_of(const std::string& suite) {
  try {
    parse_stress_suite(suite, "s.toml");
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    return error.what();
  }
  return {};
}

TEST(StressSuite, chooses_axes_values_and_parameters) {
  const StressPlan plan = parse_stress_suite(
      "schema = 1\nwidth_px = 32\ntechniques = [\"hard\"]\n[[axis]]\nname = \"contact_gap\"\nvalues = [0, "
      "1]\n"
      "[[axis]]\nparameter = \"bias_world\"\nvalues = [0, 0.5]\n",
      "s.toml");
  EXPECT_EQ(plan.picture.width_px, 32);
  ASSERT_EQ(plan.axes.size(), 2u);
  EXPECT_EQ(plan.axes[0].nominal, 1u);
  EXPECT_EQ(plan.axes[1].name, "bias_world");
  EXPECT_THAT(plan.axes[1].point(plan.axes[1].values[1]).assignments, testing::Contains("bias_world=0.5"));
  EXPECT_EQ(parse_stress_suite("schema = 1\n", "s.toml").axes.size(), stress_axes().size());
}

TEST(StressSuite, bad_ones_get_a_sentence) {
  EXPECT_THAT(error_of("schema = 2\n"), HasSubstr("'schema' is 2"));
  EXPECT_THAT(error_of("schema = 1\nwidht_px = 3\n"), HasSubstr("width_px"));
  EXPECT_THAT(error_of("schema = 1\nwidth_px = 0\n"), HasSubstr("'width_px' is 0"));
  EXPECT_THAT(error_of("schema = 1\n[[axis]]\nname = \"contact_gpa\"\n"), HasSubstr("contact_gap"));
  EXPECT_THAT(error_of("schema = 1\n[[axis]]\nname = \"contact_gap\"\nvalues = [0]\n"), HasSubstr("lack 1"));
  EXPECT_THAT(error_of("schema = 1\n[[axis]]\nname = \"mesh\"\nvalues = [\"clean\", \"dirty\"]\n"),
              HasSubstr("'dirty'"));
  EXPECT_THAT(error_of("schema = 1\n[[axis]]\nvalues = [1]\n"), HasSubstr("either 'name' or 'parameter'"));
}

TEST(StressOutput, says_the_same_in_every_form) {
  StressResults results = results_of({ok, ok, ok, ok, ok, worse, bad_value});
  results.rows.push_back("a|b<c>");
  for (size_t value = 0; value < 7; ++value) results.cells.push_back(cell_of(value, ok, "a|b<c>"));
  EXPECT_THAT(stress_text(results), HasSubstr("1 to 5; acne at 6: hard"));
  EXPECT_THAT(stress_text(results), HasSubstr("x at 7, hard: bad value"));
  EXPECT_THAT(stress_markdown(results), HasSubstr("| 1 to 5; acne at 6 | hard |"));
  EXPECT_THAT(stress_markdown(results), HasSubstr("a\\|b<c>"));
  const auto json = nlohmann::json::parse(stress_json(results));
  EXPECT_EQ(json["passes"], false);
  EXPECT_EQ(json["ranges"][0]["break_after"]["value"], "6");
  EXPECT_EQ(json["ranges"][0]["break_after"]["how"], "acne");
  EXPECT_TRUE(json["ranges"][1]["break_after"].is_null());
}

}  // namespace
}  // namespace umbrameter
