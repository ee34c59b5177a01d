// SPDX-License-Identifier: Apache-2.0
// Without these tests a saved figure could lack a picture or its context, the histogram could count other pixels than those in
// sight, the slider or two fingers could do nothing, and a worst place could name the wrong cause.

#include "tests/support/lab/fakes.h"
#include "tests/unit/report/visit.h"

#include "core/files.h"
#include "core/image_io.h"

#include <gmock/gmock.h>

namespace umbrameter {
namespace {

using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;

class ReportFigure : public ReportVisit {};

size_t count(const std::string& text, const std::string& what) {
  size_t found = 0;
  for (size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

TEST_F(ReportFigure, HasEveryPictureWithItsNumberAsSvgAndPng) {
  std::filesystem::create_directory(place("saved"));
  const std::string svg = (place("saved") / "plate-figure.svg").string();
  const std::string png = (place("saved") / "plate-figure.png").string();
  const Json seen = visit({{{"downloads", place("saved").string()}, {"before", true}},
                           evaluate(ready(1)),
                           evaluate("document.querySelector('.figure-maker').open = true"),
                           {{"click", "[data-role='figure-svg']"}},
                           {{"await", svg}},
                           {{"click", "[data-role='figure-png']"}},
                           {{"await", png}}});
  EXPECT_EQ(seen["console"], Json::array());
  ASSERT_TRUE(std::filesystem::exists(svg));
  const std::string text = read_file(svg);
  // Truth and run, a detail of each, the run's errors as a whole and in the detail, and the colours' ramp.
  EXPECT_EQ(count(text, "<image "), 7u);
  EXPECT_THAT(text, HasSubstr("RMSE 0.0"));
  EXPECT_THAT(text, HasSubstr("+0.25 too bright"));
  EXPECT_THAT(text, HasSubstr("Scene 0123456789abcdef, seed 7"));
  EXPECT_THAT(text, Not(HasSubstr("NaN")));
  ASSERT_TRUE(std::filesystem::exists(png));
  const Image picture = read_image(png);
  EXPECT_EQ(picture.width, 1005);  // two cells of 320 with three gaps of 10, times 1.5
}

TEST_F(ReportFigure, DetailLiesInsideTheWindowAboutTheCursor) {
  const Json seen = visit(
      Json::array({evaluate("[insetWindow({x: 0, y: 0}, {x: 10, y: 20, width: 100, height: 60}, 4 / 3),"
                            "insetWindow({x: 60, y: 50}, {x: 10, y: 20, width: 100, height: 60}, 4 / 3),"
                            "insetWindow({x: 500, y: 500}, {x: 10, y: 20, width: 100, height: 60}, 4 / 3)]"
                            ".map(w => [w.x, w.y, w.width, w.height])")}));
  EXPECT_EQ(seen["values"].back(), Json::parse("[[10, 20, 20, 15], [50, 43, 20, 15], [90, 65, 20, 15]]"));
}

TEST_F(ReportFigure, HistogramCountsThePixelsInSight) {
  const char* histogram =
      "(({counts, scored, beyond}) => [counts[20], counts[28], scored, beyond, "
      "counts.reduce((a, b) => a + b)])(viewers.get(0).histogram)";
  const Json seen =
      visit({evaluate(ready(1)), evaluate("drawHistogram(viewers.get(0))"), evaluate(histogram),
             evaluate("setErrorScale(viewers.get(0), 0.05)"), evaluate("drawHistogram(viewers.get(0))"),
             evaluate("viewers.get(0).histogram.beyond"), evaluate("zoomAt(viewers.get(0), 8, 5, 7)"),
             evaluate("drawHistogram(viewers.get(0))"),
             evaluate("(s => (s.right - s.left) * (s.bottom - s.top))(pixelsInSight(viewers.get(0)))"),
             evaluate("viewers.get(0).histogram.scored")});
  EXPECT_EQ(seen["console"], Json::array());
  const int wrong = 19 * kFakeHeight_px, right = 20 * kFakeHeight_px;  // columns 1 to 19, and 20 to 39
  EXPECT_EQ(seen["values"][0], Json({right, wrong, right + wrong, 0, right + wrong}));
  EXPECT_EQ(seen["values"][1], wrong);  // .1 is beyond .05
  EXPECT_EQ(seen["values"][2], seen["values"][3]);
}

TEST_F(ReportFigure, PixelsShowTheirValuesWhenTheyAreLarge) {
  const Json seen =
      visit({evaluate("[0.42, -0.08, 1, 0, 0.001, -0.0001, 12.5].map(value => shortNumber(value))"),
             evaluate(ready(1)), evaluate("zoomAt(viewers.get(0), 8, 5, 7)"), next_frame(),
             evaluate("['run', 'other', 'map'].map(pane => paneValue(viewers.get(0), pane)(7 * 40 + 5))")});
  EXPECT_EQ(seen["console"], Json::array());
  EXPECT_EQ(seen["values"][0], Json({".42", "-.08", "1", "0", "0", "0", "12.50"}));
  EXPECT_EQ(seen["values"][1], Json({".600", ".500", ".100"}));
}

TEST_F(ReportFigure, ThePictureMovesItsSliderAndTwoFingersZoom) {
  const Json seen = visit({evaluate(ready(1)),
                           press("3"),
                           next_frame(),
                           {{"drag", "[data-pane='run'] canvas"}, {"by", {60, 0}}},
                           evaluate("viewers.get(0).divider"),
                           evaluate("60 / document.querySelector(`[data-pane='run'] canvas`).clientWidth"),
                           press("1"),
                           {{"touch", true}},
                           next_frame(),
                           {{"pinch", "[data-pane='run'] canvas"}, {"by", 3}},
                           next_frame(),
                           evaluate("viewers.get(0).view.zoom")});
  EXPECT_EQ(seen["console"], Json::array());
  EXPECT_NEAR(seen["values"][0].get<double>(), 0.5 + seen["values"][1].get<double>(), 0.01);
  EXPECT_NEAR(seen["values"][2].get<double>(), 3.0, 0.2);
}

TEST_F(ReportFigure, WorstPlacesSayWhatIsWrongWhyAndWhatMendsIt) {
  const std::string given =
      "const scene = {name: 'plate'}, run = {technique: 'pcf', parameters: {bias: 0.1, width: 3}, error: "
      "{mae: "
      "0.02}, fault_causes: {faults: [{fault: 'acne', sentence: 'no bias is too small'}]}};"
      "const tuning = (scenes, ratio, width) => ({file: 'tune.json', technique: 'pcf', scenes, objective: "
      "'rmse', tuned: ['bias', 'width'], sensitivity: [{parameter: 'width', rise_below: 0.5, rise_above: "
      "null}, "
      "{parameter: 'bias', rise_below: null, rise_above: 0.1}], best: {ratio, parameters: {bias: 0.2, "
      "width}}, "
      "others: []});";
  const Json seen = visit(
      {evaluate("{" + given + "page.tunings = []; worstSentences(scene, run, {name: 'acne', part: 0.01})}"),
       evaluate("{" + given +
                "page.tunings = [tuning(['fence'], 0.3, 5), tuning(['plate'], 0.25, 7)]; "
                "tuningSentence(scene, run)}"),
       evaluate("{" + given + "page.tunings = [tuning(['fence'], 0.999, 5)]; tuningSentence(scene, run)}")});
  EXPECT_EQ(seen["values"][0], Json({"Acne: dark on lit ground; 50 % of the mean |error| 0.0200.",
                                     "Why: no bias is too small."}));
  EXPECT_EQ(seen["values"][1],
            "Tuning mends it: width 3 to 7, bias 0.1 to 0.2 leaves 25 % of the rmse (tune.json).");
  EXPECT_EQ(seen["values"][2], "Tuning on fence found no parameters that mend it (tune.json).");
}

TEST_F(ReportFigure, FrontIsOfTechniquesThatWereMeasuredEverywhere) {
  const Json seen = visit(Json::array(
      {evaluate("(() => { const run = (rmse, ms) => ({measurements: {rmse}, pass_times: [{median_ms: "
                "ms}]});"
                "results.scenes = [{techniques: [run(0.1, 1), run(0.2, 2), run(0.01, 9)]}, {techniques: "
                "[run(0.3, 3), run(0.4, 4)]}];"
                "const {points, scenes, leftOut} = frontPoints([{label: 'a', places: [0, 0]}, {label: 'b', "
                "places: [1, 1]}, {label: 'c', places: [2]}]);"
                "return [points.map(point => point.label), scenes, leftOut, points.map(point => "
                "isBehind(point, points))]; })()")}));
  EXPECT_EQ(seen["values"].back(), Json::parse(R"([["a", "b"], 2, 1, [false, true]])"));
}

}  // namespace
}  // namespace umbrameter
