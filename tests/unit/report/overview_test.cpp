// SPDX-License-Identifier: Apache-2.0
// Without these tests the first screen could show other numbers than results.json, lead to the wrong picture, call the
// slowest run best, or hide its numbers on a narrow screen.

#include "tests/support/lab/fakes.h"
#include "tests/unit/report/visit.h"

#include "core/files.h"
#include "core/image_io.h"

namespace umbrameter {
namespace {

using Json = nlohmann::json;

class ReportOverview : public ReportVisit {};

const std::string kRows =
    "[...document.querySelectorAll('#overview-map tbody tr')].map(row => [...row.cells].map(cell => "
    "cell.textContent))";

std::string overview_ready() {
  return "(async () => { while (document.getElementById('overview').dataset.ready !== 'yes') await new "
         "Promise(done => setTimeout(done, 20)); })()";
}

TEST_F(ReportOverview, ShowsEveryRunOnceSortedByItsError) {
  const Json seen = visit({evaluate(overview_ready()), evaluate(kRows)});
  EXPECT_EQ(seen["console"], Json::array());
  const Json results = Json::parse(read_file(place("results.json")));
  std::vector<std::pair<double, std::string>> expected;
  for (const auto& run : results["scenes"][0]["techniques"]) {
    if (!run["error"].is_null()) expected.emplace_back(run["error"]["rmse"]["value"], run["label"]);
  }
  std::ranges::sort(expected);
  const Json& rows = seen["values"].back();
  ASSERT_EQ(rows.size(), results["scenes"][0]["techniques"].size());
  for (size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(rows[i][0], expected[i].second);
    EXPECT_NEAR(std::stod(rows[i][1].get<std::string>()), expected[i].first, 0.5e-3 + 1e-9);
  }
  EXPECT_EQ(rows.back()[1], "n/a");  // what failed comes last
}

TEST_F(ReportOverview, ShowsAnyMetricThatWasMeasuredAndNoOther) {
  const std::string choose =
      "(name => { const menu = document.getElementById('overview-metric'); menu.value = name; "
      "menu.dispatchEvent(new Event('input')); return " +
      kRows + "; })";
  const Json seen =
      visit({evaluate(overview_ready()),
             evaluate("[...document.getElementById('overview-metric').options].map(one => one.value)"),
             evaluate(choose + "('max_error')"), evaluate(choose + "('memory_bytes')")});
  EXPECT_EQ(seen["console"], Json::array());
  const Json results = Json::parse(read_file(place("results.json")));
  const auto has = [&](const char* name) {
    return std::ranges::find(seen["values"][0], Json(name)) != seen["values"][0].end();
  };
  EXPECT_TRUE(has("rmse") && has("penumbra.rmse") && has("max_error") && has("worst_fault_error") &&
              has("time_ms") && has("memory_bytes"));
  EXPECT_FALSE(has("flicker")) << "no sequence was rendered";
  for (const Json& row : seen["values"][1]) {
    for (const auto& run : results["scenes"][0]["techniques"]) {
      if (run["label"] != row[0] || run["error"].is_null()) continue;
      EXPECT_NEAR(std::stod(row[1].get<std::string>()), run["error"]["max_error"], 0.5e-3 + 1e-9) << row;
    }
  }
}

TEST_F(ReportOverview, LeadsFromACellToItsPicture) {
  const Json seen =
      visit({evaluate(overview_ready()),
             evaluate("[...document.querySelectorAll('#overview-map tbody tr')].find(row => "
                      "row.cells[0].textContent === 'off').cells[1].firstChild.click()"),
             evaluate(ready(1)), evaluate("results.scenes[0].techniques[viewers.get(0).runIndex].label")});
  EXPECT_EQ(seen["values"].back(), "off");
}

TEST_F(ReportOverview, BestIsTheClosestWithinTheTimeThatIsAllowed) {
  const std::string scene =
      "const run = (rmse, ms) => ({measurements: {rmse}, pass_times: ms === null ? [] : [{median_ms: "
      "ms}]});"
      "const scene = {techniques: [run(0.1, 1), run(0.02, 8), run(0.001, 500), {error: null, pass_times: "
      "[]}]};";
  const Json seen = visit(
      {evaluate("{" + scene +
                "[bestAffordable(scene, 2), bestAffordable(scene, 10), bestAffordable(scene, Infinity)]}"),
       evaluate("bestAffordable({techniques: [{error: null, pass_times: []}]}, 10)"),
       evaluate("bestAffordable({techniques: [{measurements: {rmse: 1}, pass_times: []}]}, 10)"),
       evaluate("bestAffordable({techniques: [{measurements: {rmse: 0.1}, quantity: 'irradiance', "
                "pass_times: []}, "
                "{measurements: {rmse: 1}, quantity: 'visibility', pass_times: []}]}, 10)")});
  EXPECT_EQ(seen["values"], Json::parse("[[0, 1, 2], -1, 0, 1]"));
}

TEST_F(ReportOverview, NobodyIsBestForATimeThatWasNotMeasured) {
  const std::string texts =
      "[document.getElementById('overview-best').textContent, "
      "document.getElementById('overview-budget').parentElement.hidden]";
  const Json seen = visit(
      {evaluate(overview_ready()), evaluate(texts),
       evaluate("results.scenes.forEach(scene => scene.techniques.forEach(run => { run.pass_times = []; "
                "if (run.measurements) delete run.measurements.time_ms; })); drawOverview()"),
       evaluate(texts)});
  EXPECT_TRUE(seen["values"][0][0].get<std::string>().starts_with("Best for the time (framed): "));
  EXPECT_EQ(seen["values"][0][1], false);
  EXPECT_TRUE(seen["values"].back()[0].get<std::string>().starts_with("Closest to the truth (framed): "));
  EXPECT_EQ(seen["values"].back()[1], true);
}

TEST_F(ReportOverview, CropsHoldTheWorstPixels) {
  const Json seen = visit(Json::array(
      {evaluate("(() => { const entry = {width: 40, height: 30}, n = 1200; const planes = {visibility: "
                "new Float32Array(n)}, run = {visibility: new Float32Array(n), faults: new Uint8Array(n)};"
                "for (const [x, y, e, c] of [[3, 3, 1, 2], [30, 20, 0.6, 5], [31, 21, 0.6, 5]]) {"
                "run.visibility[y * 40 + x] = e; run.faults[y * 40 + x] = c; }"
                "const w = worstWindow(entry, planes, run, 5, {width: 8, height: 6});"
                "return [w.x <= 30 && w.x + 8 > 31, w.y <= 20 && w.y + 6 > 21, w.sum.toFixed(2)]; })()")}));
  EXPECT_EQ(seen["values"].back(), Json::parse(R"([true, true, "1.20"])"));
}

TEST_F(ReportOverview, LitPictureIsVisibilityTimesIrradiance) {
  const Json seen = visit(
      {evaluate(ready(1)), evaluate("viewers.get(0).picture"),
       evaluate("(() => { const scene = {hit: [1, 1, 1, 0], unshadowed: [1, 1, 0.25, 1]}, v = {visibility: "
                "[1, 0, 1, 1]};"
                "const colour = litColour(v, scene, 1); return [0, 1, 2, 3].map(i => colour(i)); })()")});
  EXPECT_EQ(seen["values"][0], "lit");
  const Json& colours = seen["values"][1];
  EXPECT_GT(colours[0][0], colours[2][0]);  // more light
  EXPECT_GT(colours[2][0], colours[1][0]);  // than in shadow
  EXPECT_GT(colours[1][0], 0);              // whose shapes can be told apart
  EXPECT_NE(colours[3][0], colours[3][2]);  // the background is no grey
}

TEST_F(ReportOverview, ALinkBringsTheViewBack) {
  const Json seen = visit(
      {evaluate(ready(1)),
       evaluate("{const v = viewers.get(0); v.cursor = {x: 12, y: 9}; setMode(v, 'slider'); setErrorScale(v, "
                "0.05); "
                "setPicture(v, 'visibility'); zoomAt(v, 4, 12.5, 9.5); linkHere(v);}"),
       evaluate(
           "{const v = viewers.get(0); v.cursor = {x: 0, y: 0}; setMode(v, 'panes'); setErrorScale(v, 0.25); "
           "setPicture(v, 'lit'); fit(v); followLink();}"),
       evaluate(ready(1)),
       evaluate(
           "(v => [v.cursor.x, v.cursor.y, v.mode, v.errorScale, v.picture, v.view.zoom])(viewers.get(0))"),
       evaluate("{location.hash = '#scene-1-run-2?zoom=nonsense&cursor=9e9,1&map=none&mode=x'; undefined}"),
       evaluate(ready(1)), next_frame(),
       evaluate("(v => [v.mode, v.errorScale, v.view.zoom, v.cursor.x < v.entry.width])(viewers.get(0))")});
  EXPECT_EQ(seen["console"], Json::array());
  EXPECT_EQ(seen["values"],
            Json::parse(R"([[12, 9, "slider", 0.05, "visibility", 4], ["slider", 0.05, 4, true]])"));
}

TEST_F(ReportOverview, TextsAreNoMarkup) {
  const std::string attack = "<b>bold</b><img src=x onerror='window.attacked = true'>";
  Json results = Json::parse(read_file(place("results.json")));
  Json& scene = results["scenes"][0];
  for (const char* key : {"title", "doc", "hash"}) scene[key] = attack;
  scene["warnings"] = {attack};
  for (Json& run : scene["techniques"]) {
    run["label"] = attack + run["label"].get<std::string>();
    run["title"] = run["hash"] = attack;
    run["warnings"] = {attack};
  }
  write_file_atomically(place("results.json"), results.dump());
  const Json seen =
      visit({evaluate(overview_ready()), evaluate(ready(1)),
             evaluate("document.querySelectorAll('details').forEach(folded => { folded.open = true; }); new "
                      "Promise(done => setTimeout(done, 200))"),
             evaluate("[document.querySelectorAll('main b, main img').length, window.attacked ?? false, "
                      "document.querySelector('#scene-1 h2').textContent]")});
  EXPECT_EQ(seen["console"], Json::array());
  EXPECT_EQ(seen["values"].back(), Json({0, false, "plate: " + attack}));
}

TEST_F(ReportOverview, ShowsNumbersOnANarrowScreen) {
  const Json seen = visit(
      {{{"size", {390, 844}}, {"before", true}},
       evaluate(overview_ready()),
       evaluate("document.documentElement.scrollWidth"),
       evaluate("document.querySelector('#overview-map tbody td').getBoundingClientRect().right <= 390"),
       evaluate("document.getElementById('overview').getBoundingClientRect().top < 844")});
  EXPECT_LE(seen["values"][0].get<int>(), 390);
  EXPECT_EQ(seen["values"][1], true);
  EXPECT_EQ(seen["values"][2], true);
}

}  // namespace
}  // namespace umbrameter
