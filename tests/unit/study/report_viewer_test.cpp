// Without these tests the viewer could open to an error, ignore its keys, show other numbers than results.json and the
// metrics, or not fit a narrow screen. A real browser opens the page from disk and gets real key presses.

#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/study/fakes.h"

#include "core/files.h"
#include "core/image_io.h"
#include "metrics/significance.h"
#include "report/report.h"
#include "study/results_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>

namespace umbrameter {
namespace {

using Json = nlohmann::json;

/// Shows run `run` of scene 0 against the reference and resolves when it is drawn; the viewer has the focus then.
std::string ready(int run) {
  return "(async () => { const viewer = makeViewer(0); if (viewer.runIndex !== " + std::to_string(run) +
         ") show(viewer, " + std::to_string(run) + ", -1); while (viewer.root.dataset.ready !== '" +
         std::to_string(run) +
         " -1') await new Promise(done => setTimeout(done, 20)); await new Promise(requestAnimationFrame);"
         "await new Promise(requestAnimationFrame); viewer.root.focus(); })()";
}

Json evaluate(const std::string& script) {
  return {{"eval", script}};
}

Json press(const std::string& key) {
  return {{"key", key}};
}

/// What is drawn is drawn with the next frame.
Json next_frame() {
  return evaluate("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done())))");
}

class ReportViewer : public testing::Test {
 protected:
  void SetUp() override {
    if (run_process({"chromium", "--version"}).exit_code != 0) GTEST_SKIP() << "chromium is not installed";
    write_file_atomically(folder_.path() / "results.json", to_json_text(fake_results(folder_.path())));
  }

  /// Console and values of a visit; values without those that are null.
  Json visit(const Json& steps, size_t budget_bytes = kPageBudget_bytes) {
    write_report(folder_.path(), folder_.path() / "report.html", budget_bytes);
    write_file_atomically(folder_.path() / "steps.json", steps.dump());
    const ProcessResult result =
        run_process({"python3", UMBRAMETER_SOURCE_DIR "/tests/support/browser.py",
                     (folder_.path() / "report.html").string(), (folder_.path() / "steps.json").string(),
                     (folder_.path() / "profile").string()});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    Json seen = result.exit_code == 0 ? Json::parse(result.out) : Json{{"console", {"no visit"}}};
    Json values = Json::array();
    for (const Json& value : seen["values"])
      if (!value.is_null()) values.push_back(value);
    seen["values"] = values;
    return seen;
  }

  TemporaryFolder folder_;
};

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

TEST_F(ReportViewer, FitsANarrowScreen) {
  const Json seen = visit({{{"size", {360, 740}}, {"before", true}},
                           evaluate(ready(1)),
                           evaluate("document.documentElement.scrollWidth")});
  EXPECT_LE(seen["values"][0].get<int>(), 360);
}

}  // namespace
}  // namespace umbrameter
