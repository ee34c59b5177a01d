// SPDX-License-Identifier: Apache-2.0
// Without these tests the viewer could open to an error, ignore its keys, show other numbers than results.json and the
// metrics, or not fit a narrow screen. A real browser opens the page from disk and gets real key presses.

#include "tests/support/lab/fakes.h"
#include "tests/unit/report/visit.h"

#include "core/files.h"
#include "core/image_io.h"
#include "metrics/statistics/significance.h"

namespace umbrameter {
namespace {

using Json = nlohmann::json;

class ReportViewer : public ReportVisit {};

TEST_F(ReportViewer, ReadsOutWhatWasMeasured) {
  const Json seen =
      visit({evaluate(ready(1)), evaluate("viewers.get(0).cursor = {x: 5, y: 7}; draw(viewers.get(0))"),
             next_frame(), evaluate("pixelValues(viewers.get(0))"),
             evaluate("deviateAt(viewers.get(0).shown, 7 * 40 + 5)")});
  EXPECT_EQ(seen["console"], Json::array());
  ASSERT_EQ(seen["values"].size(), 2u) << seen;
  const Image test = read_image(folder_.path() / "images/plate/off.exr");
  const double v = test.plane("visibility")[7 * 40 + 5];
  const Json& pixel = seen["values"][0];
  EXPECT_NEAR(std::stod(pixel["v"].get<std::string>()), v, 0.5 / 4095 + 5e-5);
  EXPECT_NEAR(std::stod(pixel["error"].get<std::string>()), 0.1, 0.5 / 4095 + 1e-4);
  EXPECT_EQ(pixel["pixel"], "5, 7");
  const double z = normal_deviate(v, 0.5, 0.0, 0.0, {});
  EXPECT_NEAR(seen["values"][1].get<double>(), z, 0.2);  // a step of V is .24 of the floor's .001
}

TEST_F(ReportViewer, ObeysItsKeys) {
  const Json seen =
      visit({evaluate(ready(0)),
             evaluate("viewers.get(0).cursor = {x: 20, y: 15}; undefined"),
             press("ArrowRight"),
             press("ArrowDown"),
             evaluate("[viewers.get(0).cursor.x, viewers.get(0).cursor.y]"),
             press("+"),
             press("+"),
             evaluate("viewers.get(0).view.zoom"),
             press("0"),
             evaluate("viewers.get(0).view.zoom"),
             press("3"),
             press("]"),
             evaluate("[viewers.get(0).mode, viewers.get(0).divider.toFixed(2)]"),
             press(" "),
             next_frame(),
             evaluate("[viewers.get(0).mode, viewers.get(0).root.querySelector('[data-pane=run] "
                      ".pane-title').textContent]"),
             press("n"),
             evaluate(ready(1)),
             evaluate("viewers.get(0).runIndex"),
             press("?"),
             evaluate("document.getElementById('keys').open")});
  EXPECT_EQ(seen["console"], Json::array());
  EXPECT_EQ(seen["values"],
            Json::parse(R"([[21, 16], 4, 1, ["slider", "0.55"], ["flip", "Reference"], 1, true])"));
}

TEST_F(ReportViewer, PaintsTheErrorAtItsScaleOnEveryPane) {
  const Json seen =
      visit({evaluate(ready(1)), evaluate("layers.error.colour(viewers.get(0).shown, 7 * 40 + 5)"),
             evaluate("layers.error.colour(viewers.get(0).shown, 7 * 40 + 30)"),
             evaluate("[...document.querySelectorAll('[data-pane] canvas')].map(canvas => "
                      "canvas.getContext('2d').getImageData(canvas.width >> 2, 20, 1, 1).data[3])")});
  const double share = 0.1 / 0.25;  // of the way from white to {190, 10, 30}
  EXPECT_NEAR(seen["values"][0][0].get<double>(), 255 + share * (190 - 255), 1.0);
  EXPECT_NEAR(seen["values"][0][1].get<double>(), 255 + share * (10 - 255), 1.0);
  EXPECT_EQ(seen["values"][1], Json({255, 255, 255}));
  EXPECT_EQ(seen["values"][2], Json({255, 255, 255}));  // opaque: all three were drawn
}

TEST_F(ReportViewer, LoadsPixelsThatLieBesideThePage) {
  const Json seen = visit({evaluate(ready(1)), evaluate("viewers.get(0).shown.run.visibility.length")}, 0);
  EXPECT_EQ(seen["console"], Json::array());
  EXPECT_EQ(seen["values"], Json({kFakeWidth_px * kFakeHeight_px}));
}

TEST_F(ReportViewer, FiltersTheTable) {
  const Json seen =
      visit({evaluate("{const box = document.getElementById('filter'); box.value = 'plate OFF';"
                      "box.dispatchEvent(new Event('input'))}"),
             evaluate("[...document.querySelectorAll('#results tbody tr')].filter(row => !row.hidden)"
                      ".map(row => row.dataset.technique)")});
  EXPECT_EQ(seen["values"].back(), Json({"off"}));
}

TEST_F(ReportViewer, FitsANarrowScreenAndAnswersAFinger) {
  const Json seen = visit({{{"size", {360, 740}}, {"before", true}},
                           {{"touch", true}, {"before", true}},
                           evaluate(ready(1)),
                           evaluate("document.documentElement.scrollWidth"),
                           evaluate("viewers.get(0).view.x"),
                           {{"click", "[data-role='zoom-in']"}},
                           {{"click", "[data-role='zoom-in']"}},
                           {{"swipe", "[data-pane='run'] canvas"}, {"by", {-60, 0}}},
                           next_frame(),
                           evaluate("viewers.get(0).view.x")});
  EXPECT_EQ(seen["console"], Json::array());
  EXPECT_LE(seen["values"][0].get<int>(), 360);
  EXPECT_GT(seen["values"][2].get<double>(), seen["values"][1].get<double>() + 1.0);  // dragged to the left
}

TEST_F(ReportViewer, PansWithTheMouseAndZoomsWithTheWheelAboutThePointer) {
  const char* view = "(({x, y, zoom}) => [x, y, zoom])(viewers.get(0).view)";
  const char* canvas = "[data-pane='run'] canvas";
  const Json seen = visit({evaluate(ready(1)),
                           {{"wheel", canvas}, {"by", -100}},
                           {{"wheel", canvas}, {"by", -100}},
                           {{"wheel", canvas}, {"by", -100}},
                           next_frame(),
                           evaluate(view),
                           {{"drag", canvas}, {"by", {40, 0}}},
                           next_frame(),
                           evaluate(view),
                           evaluate("document.querySelector(`[data-pane='run'] canvas`).clientWidth")});
  ASSERT_EQ(seen["console"], Json::array());
  const Json &zoomed = seen["values"][0], &panned = seen["values"][1];
  EXPECT_NEAR(zoomed[2].get<double>(), 1.25 * 1.25 * 1.25, 1e-9);
  EXPECT_NEAR(zoomed[0].get<double>(), kFakeWidth_px / 2, 0.1);  // about the middle
  const double pixels = 40.0 * kFakeWidth_px / seen["values"][2].get<double>() / zoomed[2].get<double>();
  EXPECT_NEAR(panned[0].get<double>(), zoomed[0].get<double>() - pixels, 0.05);
}

TEST_F(ReportViewer, SavesWhatIsSeenAsPng) {
  std::filesystem::create_directory(place("saved"));
  const std::string file = (place("saved") / "plate-off.png").string();
  const Json seen = visit({{{"downloads", place("saved").string()}, {"before", true}},
                           evaluate(ready(1)),
                           press("4"),
                           next_frame(),
                           {{"click", "[data-role='save']"}},
                           {{"await", file}},
                           evaluate("document.querySelector(`[data-pane='map'] canvas`).width")});
  EXPECT_EQ(seen["console"], Json::array());
  ASSERT_TRUE(std::filesystem::exists(file));
  const Image picture = read_image(file);
  EXPECT_GE(picture.width,
            seen["values"].back().get<int>());  // the map with its margin, and the context below
  EXPECT_GT(picture.height, picture.width * kFakeHeight_px / kFakeWidth_px);
}

TEST_F(ReportViewer, ReachesEveryControlByTab) {
  const std::string missed =
      "[...document.querySelectorAll('button, select, input, a[href], summary, "
      "[tabindex=\"0\"]')].filter(control => "
      "control.checkVisibility() && !control.disabled && !('reached' in control.dataset)).map(control => "
      "control.outerHTML.slice(0, 90))";
  const Json seen = visit({evaluate(ready(1)), {{"tabs", 130}}, evaluate(missed)});
  EXPECT_EQ(seen["values"], Json({Json::array()}));
}

TEST_F(ReportViewer, FollowsTheThemeAndIsReadableOnPaper) {
  const char* ink = "getComputedStyle(document.body).color";
  const Json seen = visit({{{"dark", true}, {"before", true}},
                           evaluate(ready(1)),
                           evaluate(ink),
                           press("t"),
                           evaluate(ink),
                           {{"media", "print"}},
                           evaluate(ink),
                           evaluate("document.querySelector('.tools').checkVisibility()"),
                           {{"pdf", place("page.pdf").string()}}});
  EXPECT_EQ(seen["console"], Json::array());
  EXPECT_EQ(seen["values"], Json({"rgb(230, 232, 236)", "rgb(27, 31, 39)", "rgb(0, 0, 0)", false}));
  EXPECT_GT(std::filesystem::file_size(place("page.pdf")), 10'000u);
}

}  // namespace
}  // namespace umbrameter
