// SPDX-License-Identifier: Apache-2.0
// Without these tests a scene's title could run as script, a picture could be missing, or the page could ask
// the network for something.

#include "report/report.h"

#include "tests/support/lab/fakes.h"
#include "tests/support/temporary_folder.h"

#include "core/error.h"
#include "core/files.h"
#include "report/assets.h"
#include "report/html.h"
#include "results/json/results_json.h"
#include "results/pictures/pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::ThrowsMessage;

TEST(EncodeBase64, MatchesRfc4648) {
  EXPECT_EQ(encode_base64(""), "");
  EXPECT_EQ(encode_base64("f"), "Zg==");
  EXPECT_EQ(encode_base64("fo"), "Zm8=");
  EXPECT_EQ(encode_base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(encode_base64("\xFF\xFE"), "//4=");
}

TEST(FillTemplate, DoesNotFillWhatItFilledIn) {
  EXPECT_EQ(fill_template("a {{x}} b", {{"x", "{{y}}"}, {"y", "no"}}), "a {{y}} b");
  EXPECT_THROW(fill_template("{{z}}", {}), Error);
}

class Report : public testing::Test {
 protected:
  TemporaryFolder folder_;
};

TEST_F(Report, EscapesEveryTextOfTheResults) {
  Results results = fake_results(folder_.path());
  const std::string attack = "\"><script>alert(1)</script>";
  results.quality = results.version = results.commit = attack;
  results.skipped.push_back({attack, attack, attack});
  SceneResult& scene = results.scenes[0];
  scene.name = scene.title = scene.doc = scene.hash = scene.light_name = scene.light_type = attack;
  scene.warnings = {attack};
  scene.failure = Failure{ErrorKind::input, attack};
  scene.reference->device = attack;
  scene.reference->warnings = {attack};
  for (TechniqueResult& run : scene.techniques) {
    run.label = run.title = run.hash = run.device = run.timer = attack;
    run.parameters["name"] = attack;
    run.warnings = {attack};
    if (run.failure) run.failure->message = attack;
    for (PassTime& time : run.pass_times) time.pass = attack;
  }
  const std::string html = report_html(results, folder_.path());
  EXPECT_THAT(html, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(html, HasSubstr("\\u003cscript>alert(1)"));
}

TEST_F(Report, NeedsNoNetwork) {
  std::string html = report_html(fake_results(folder_.path()), folder_.path());
  const std::string_view chart =
      report_asset("chart.min.js");  // names its home page; the browser test sees requests
  html.erase(html.find(chart), chart.size());
  for (const char* reach : {"http:", "https:", "src=\"/", "url(", "@import", "fetch("}) {
    EXPECT_THAT(html, Not(HasSubstr(reach)));
  }
}

TEST_F(Report, ShowsEveryPictureWithItsContextAndSaysWhatIsMissing) {
  const std::string html = report_html(fake_results(folder_.path()), folder_.path());
  for (const char* id : {"s0", "s0-r0", "s0-r1"}) {  // the reference and the two that ran
    EXPECT_THAT(html, HasSubstr(fmt::format("<script type=\"application/json\" id=\"{}\">", id)));
  }
  EXPECT_THAT(html, Not(HasSubstr("id=\"s0-r2\"")));
  EXPECT_THAT(html, HasSubstr("fit=visible radius_texels=2.5 taps=16"));
  EXPECT_THAT(html, HasSubstr("broken/resolve.frag:7:3: does not compile"));
  EXPECT_THAT(html, HasSubstr("plate, sun-only: does not support rect lights"));
  EXPECT_THAT(html, HasSubstr("[\"contact hardening\",\"not identifiable: 0 profiles"));
  for (const FaultLegend& entry : fault_legend())
    EXPECT_THAT(html, HasSubstr(nlohmann::json(entry.text).dump()));
}

TEST_F(Report, OfStoredResultsIsTheSameBytes) {
  const Results results = fake_results(folder_.path());
  write_file_atomically(folder_.path() / "results.json", to_json_text(results));
  write_report(folder_.path(), folder_.path() / "page.html");
  EXPECT_EQ(read_file(folder_.path() / "page.html"), report_html(results, folder_.path()));
}

TEST_F(Report, OfAMissingPictureOrFolderIsBadInputAndWritesNothing) {
  const Results results = fake_results(folder_.path());
  write_file_atomically(folder_.path() / "results.json", to_json_text(results));
  std::filesystem::remove(folder_.path() / results.scenes[0].reference->image_file);
  EXPECT_THAT([&] { write_report(folder_.path(), folder_.path() / "page.html"); },
              ThrowsMessage<Error>(HasSubstr("reference.exr")));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "page.html"));
  EXPECT_THROW(write_report(folder_.path() / "none", folder_.path() / "page.html"), Error);
}

}  // namespace
}  // namespace umbrameter
