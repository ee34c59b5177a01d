// SPDX-License-Identifier: Apache-2.0
// Without these tests the report could show other numbers of bench, stress and regress than their files, leave a section out, or
// lose its map to the keyboard.

#include "tests/support/lab/fakes.h"
#include "tests/unit/report/visit.h"

#include "core/error.h"
#include "core/files.h"
#include "report/before.h"
#include "report/regress_output.h"
#include "report/report.h"
#include "report/required_fields.h"
#include "report/side_data.h"
#include "report/stress_output.h"
#include "report/tune_files.h"
#include "results/bench/bench_json.h"
#include "results/json/results_json.h"
#include "results/json/schemas.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::ThrowsMessage;
using Json = nlohmann::json;

BenchEntry entry(const std::string& label, double ms, double rmse) {
  BenchEntry one;
  one.label = one.technique = label;
  one.is_software = true;
  one.times = {{"map"}, std::vector<std::vector<double>>(6, {ms})};
  one.time_ms = Interval{ms, 0.9 * ms, 1.1 * ms};
  one.error.emplace().rmse = Interval{rmse, 0.9 * rmse, 1.1 * rmse};
  return one;
}

/// Two runs on the front, one behind; and the truth's curve, as 'bench' may add it.
std::string bench_text() {
  BenchResults results;
  results.plan.title = "Grid & <b>more";
  BenchScene scene;
  scene.name = "plate";
  scene.entries = {entry("fast", 1.0, 0.08), entry("slow", 4.0, 0.01), entry("late", 8.0, 0.0987)};
  find_front(scene.entries);
  results.scenes = {scene};
  Json json = Json::parse(to_json_text(results, {}));
  json["scenes"][0]["truth"] = Json::parse(R"({"exponent": -0.5, "points": [
      {"kind": "samples", "setting": 16, "cpu_s": 0.1, "cpu_mad_s": 0.01, "rays_per_pixel": 9, "rmse": 0.04, "rmse_low": 0.03, "rmse_high": 0.05},
      {"kind": "samples", "setting": 64, "cpu_s": 0.4, "cpu_mad_s": 0.01, "rays_per_pixel": 36, "rmse": 0.02, "rmse_low": 0.01, "rmse_high": 0.03}]})");
  return json.dump();
}

StressCell cell(const std::string& row, size_t value, StressOutcome outcome, double rmse,
                const std::string& how = {}) {
  StressCell one;
  one.axis = "world_offset";
  one.row = row;
  one.value = value;
  one.outcome = outcome;
  one.how = how;
  one.rmse = Interval{rmse, rmse, rmse};
  return one;
}

std::string stress_text() {
  StressResults results;
  StressAxis axis;
  axis.name = "world_offset";
  axis.unit = "world units";
  axis.doc = "far from the origin";
  axis.values = numbers({0, 1e4, 1e7});
  results.plan.axes = {axis};
  results.rows = {"truth", "pcss"};
  for (size_t k = 0; k < 3; ++k) results.cells.push_back(cell("truth", k, StressOutcome::ok, 0.0));
  results.cells.push_back(cell("pcss", 0, StressOutcome::ok, 0.01));
  results.cells.push_back(cell("pcss", 1, StressOutcome::ok, 0.012));
  results.cells.push_back(cell("pcss", 2, StressOutcome::worse, 0.345, "geometric_leak"));
  return stress_json(results);
}

std::string regress_text_of(CaseOutcome outcome) {
  RegressResults results = {"small", 192, 108, 1, {}, {}, {}};
  RegressCase one;
  one.scene = "plate";
  one.label = "off";
  one.verdict.outcome = outcome;
  one.verdict.kind = "acne";
  one.verdict.message = "speckle & <more>";
  one.verdict.gate.measures = {{GateClass::acne, 0.0123, 0.001, 0.004},
                               {GateClass::noise, std::nullopt, 0.1, 0.2}};
  BaselineRun run;
  run.numbers.mse = {0.0004, 0.0003, 0.0005};
  one.before = run;
  run.numbers.mse = {0.01, 0.009, 0.011};
  one.now = run;
  results.cases = {one};
  return regress_json(results);
}

TEST(ReportParts, AreEmptyWithoutTheirFilesAndRefuseMalformedOnes) {
  const TemporaryFolder folder;
  const Json nothing = side_data(folder.path());
  EXPECT_EQ(nothing, Json::parse(R"({"benches": [], "stresses": [], "regressions": []})"));
  for (const auto& [name, message] : {std::pair("bench-x.json", "bench-x.json: not what 'bench' writes"),
                                      std::pair("stress.json", "stress.json: not what 'stress' writes"),
                                      std::pair("regress.json", "regress.json: not what 'regress' writes")}) {
    const auto file = folder.path() / name;
    const int schema = std::string_view(name).starts_with("bench") ? kBenchSchema.number : 1;
    write_file_atomically(file,
                          Json{{"schema", schema}, {"scenes", 3}, {"axes", {1}}, {"cases", {1}}}.dump());
    EXPECT_THAT([&] { side_data(folder.path()); }, ThrowsMessage<Error>(HasSubstr(message)));
    write_file_atomically(file, "{}");
    EXPECT_THAT([&] { side_data(folder.path()); }, ThrowsMessage<Error>(HasSubstr(message)));
    std::filesystem::remove(file);
  }
  Json unknown = Json::parse(stress_text());
  unknown["cells"][5]["outcome"] = "melted";
  write_file_atomically(folder.path() / "stress.json", unknown.dump());
  EXPECT_THAT([&] { side_data(folder.path()); }, ThrowsMessage<Error>(HasSubstr("'melted'")));
}

TEST(ReportParts, RefuseAnotherSchemaWithNumberFileAndHint) {
  const TemporaryFolder folder;
  const auto refuses = [&](const char* name, const auto& read, const FileSchema& schema) {
    const int older = schema.number - 1;
    write_file_atomically(folder.path() / name, Json{{"schema", older}}.dump());
    const std::string numbers =
        fmt::format("{} of schema {}; this version reads {} (", schema.what, older, schema.number);
    EXPECT_THAT([&] { read(folder.path()); },
                ThrowsMessage<Error>(AllOf(HasSubstr(name), HasSubstr(numbers), HasSubstr(schema.again))));
    std::filesystem::remove(folder.path() / name);
  };
  refuses("bench.json", side_data, kBenchSchema);
  refuses("stress.json", side_data, kStressSchema);
  refuses("regress.json", side_data, kRegressSchema);
  refuses("tune.json", read_tunings, kTuneSchema);
  refuses("tune.json", read_bias_sweeps, kTuneSchema);
}

TEST(ReportParts, RefuseAFieldThatIsMissingOrOfAnotherType) {
  const auto check = [](const char* text, std::string_view field) {
    require_fields(nlohmann::ordered_json::parse(text), std::array{field});
  };
  const std::string_view field = "runs[].rmse?.value:number";
  EXPECT_NO_THROW(check(R"({"runs": []})", field));
  EXPECT_NO_THROW(check(R"({"runs": [{"rmse": null}, {"rmse": {"value": 1}}]})", field));
  EXPECT_THROW(check(R"({"runs": [{"rmse": {"value": "1"}}]})", field), Json::exception);
  EXPECT_THROW(check(R"({"runs": [{}]})", field), Json::exception);
  EXPECT_THROW(check(R"({"runs": {}})", field), Json::exception);
  EXPECT_THROW(check(R"({})", field), Json::exception);
  EXPECT_THROW(check(R"({"names": ["a", 1]})", "names[]:text"), Json::exception);
}

TEST(ReportParts, MakeAPageWithoutResults) {
  const TemporaryFolder folder;
  const auto page = folder.path() / "report.html";
  EXPECT_THROW(write_report(folder.path(), page), Error);
  write_file_atomically(folder.path() / "bench.json", bench_text());
  write_report(folder.path(), page);
  EXPECT_THAT(read_file(page), HasSubstr("\"texts\":null"));
  EXPECT_THAT(read_file(page), HasSubstr("Grid & \\u003cb>more"));
}

class ReportPartsVisit : public ReportVisit {
 protected:
  void SetUp() override {
    ReportVisit::SetUp();
    if (IsSkipped()) return;
    write_file_atomically(place("bench.json"), bench_text());
    write_file_atomically(place("stress.json"), stress_text());
    write_file_atomically(place("regress.json"), regress_text_of(CaseOutcome::fail));
  }
};

TEST_F(ReportPartsVisit, PlotTimesWithTheFrontTheRecommendedRunAndTheTruth) {
  const Json seen =
      visit({evaluate("benchCharts[0].charts.bench.data.datasets.map(set => [set.label, set.data.map(point "
                      "=> point.label)])"),
             evaluate("benchCharts[0].charts.bench.data.datasets[0].data[0].bars"),
             evaluate("benchCharts[0].charts.truth.data.datasets.map(set => set.label)"),
             evaluate("benchCharts[0].charts.truth.data.datasets[0].data.map(point => point.y)"),
             evaluate("[...document.querySelectorAll('#contents a')].map(link => link.textContent)")});
  EXPECT_EQ(seen["console"], Json::array());
  EXPECT_EQ(
      seen["values"][0],
      Json::parse(
          R"([["front", ["fast", "slow"]], ["dominated", ["late"]], ["recommended: slow", ["slow"]], ["", [null, null]]])"));
  EXPECT_EQ(seen["values"][1], Json({{"x", {0.9 * 1.0, 1.1 * 1.0}}, {"y", {0.9 * 0.08, 1.1 * 0.08}}}));
  EXPECT_EQ(seen["values"][2], Json({"samples: RMSE as their number to the power -0.50"}));
  EXPECT_EQ(seen["values"][3], Json({0.04, 0.02}));
  EXPECT_EQ(seen["values"][4], Json({"Regression", "Overview", "Summary", "plate", "Time against error",
                                     "Stability map", "Scales", "Skipped"}));
}

/// The text of everything that `selector` finds.
Json texts(const std::string& selector) {
  return evaluate("[...document.querySelectorAll(`" + selector + "`)].map(found => found.textContent)");
}

TEST_F(ReportPartsVisit, OfBenchSayWhatItMeasured) {
  const Json seen = visit({texts("#bench h3"), texts("#bench .note"), texts("#bench [data-column=rmse]"),
                           texts("#bench figure > p"), texts("#bench tbody th"),
                           evaluate("document.querySelectorAll('#bench b').length")});
  EXPECT_EQ(seen["values"][0], Json({"Grid & <b>more"}));
  EXPECT_EQ(seen["values"][1], Json({"software rasteriser: ratios are not a GPU's"}));
  EXPECT_EQ(seen["values"][2][2], "0.09870 [0.08883, 0.10857]");
  EXPECT_THAT(seen["values"][3].dump(), HasSubstr("by the least product of time and RMSE: slow."));
  EXPECT_EQ(seen["values"][4], Json({"fast", "slow", "late", "samples 16", "samples 64"}));
  EXPECT_EQ(seen["values"][5], 0);  // texts are no markup
}

TEST_F(ReportPartsVisit, OfStressSayTheErrorOfEveryValue) {
  const Json seen = visit({texts("#stress [role=gridcell]"), texts("#stress details td"),
                           evaluate("document.querySelector('#stress td.worse').title")});
  EXPECT_EQ(seen["values"][0], Json({"all", "2/3"}));
  EXPECT_EQ(seen["values"][1][5], "0.34500 leak");
  EXPECT_EQ(seen["values"][2], "geometric_leak");
}

TEST_F(ReportPartsVisit, OfRegressShowBeforeNowAndTheGate) {
  const char* number =
      "[...document.querySelectorAll('#regress [data-value]')].map(cell => [cell.dataset.column, "
      "cell.dataset.value, cell.textContent])";
  const Json seen = visit({texts("#regress-verdict .problem"), texts("#regress .outcome"), evaluate(number),
                           texts("#regress tbody td:nth-child(7)"),
                           evaluate("document.querySelector('#regress tbody a').getAttribute('href')")});
  EXPECT_EQ(seen["console"], Json::array());
  EXPECT_THAT(seen["values"][0].dump(), HasSubstr("small: 1 cases, 0 pass, 0 better, 0 undecided, 1 fail"));
  EXPECT_EQ(seen["values"][1], Json({"fail: acne"}));
  EXPECT_EQ(seen["values"][2][0], Json({"rmse_before", "0.02", "0.02000 [0.01732, 0.02236]"}));
  EXPECT_EQ(seen["values"][2][1][1], "0.1");
  EXPECT_EQ(seen["values"][2][7], Json({"allowed", "0.004", "0.004"}));
  EXPECT_EQ(seen["values"][3], Json({"speckle & <more>"}));
  EXPECT_EQ(seen["values"][4], "#scene-1-run-2");
}

TEST_F(ReportPartsVisit, SlideBetweenBeforeAndNow) {
  const TemporaryFolder before;
  const Results old = fake_results(before.path());
  write_file_atomically(before.path() / "results.json", to_json_text(old));
  write_report(place(""), place("with-before.html"), kPageBudget_bytes, {}, before.path());
  EXPECT_THAT(read_file(place("with-before.html")), HasSubstr("off (before)"));
  Results now = old;
  add_before(now, place(""), old, before.path());
  const size_t runs = old.scenes[0].techniques.size();
  ASSERT_EQ(now.scenes[0].techniques.size(), 2 * runs);
  EXPECT_EQ(now.scenes[0].techniques[runs].label, old.scenes[0].techniques[0].label + kBeforeMark);
  EXPECT_TRUE(std::filesystem::exists(place("") / now.scenes[0].techniques[runs].image_file));
  now = old;
  now.scenes[0].hash = "another";
  add_before(now, place(""), old, before.path());
  EXPECT_EQ(now.scenes[0].techniques.size(), runs);
  EXPECT_THAT(now.scenes[0].warnings.back(), HasSubstr("the scene has changed"));
  now.scenes[0].name = "other";
  EXPECT_THROW(add_before(now, place(""), old, before.path()), Error);
}

TEST_F(ReportPartsVisit, WalkTheMapByKeysAndSayWhatACellHolds) {
  const char* detail = "document.querySelector('.map-detail').textContent";
  const Json seen = visit({evaluate("document.querySelector('[role=grid] [tabindex=\"0\"]').focus()"),
                           evaluate(detail),
                           press("ArrowDown"),
                           evaluate(detail),
                           press("ArrowDown"),
                           evaluate("document.querySelectorAll('[role=grid] [tabindex=\"0\"]').length"),
                           press("Enter"),
                           evaluate("document.getElementById('stress-1-world_offset').open"),
                           {{"hover", "[role=grid] [data-detail]"}},
                           evaluate(detail)});
  EXPECT_EQ(seen["console"], Json::array());
  const std::string truth = "truth, world_offset: holds from 0 to 1e+07 world units (3 of 3 values)";
  EXPECT_EQ(
      seen["values"],
      Json({truth, "pcss, world_offset: holds from 0 to 10000 world units (2 of 3 values); leak at 1e+07", 1,
            true, truth}));
}

TEST_F(ReportPartsVisit, FitANarrowScreenAndSortTheirTables) {
  const Json seen =
      visit({{{"size", {360, 740}}, {"before", true}},
             evaluate("document.documentElement.scrollWidth"),
             evaluate("document.querySelectorAll('#bench table.sortable')[0].querySelectorAll('thead "
                      "button')[2].click()"),
             evaluate("[...document.querySelector('#bench table.sortable').tBodies[0].rows].map(row => "
                      "row.cells[0].textContent)")});
  EXPECT_LE(seen["values"][0].get<int>(), 360);
  EXPECT_EQ(seen["values"][1], Json({"slow", "fast", "late"}));
}

}  // namespace
}  // namespace umbrameter
