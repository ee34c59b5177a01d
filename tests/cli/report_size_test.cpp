// SPDX-License-Identifier: Apache-2.0
// Without this test the report of a large validation could grow too large to send, or open to viewers that fail.

#include "tests/cli/cli_fixture.h"
#include "tests/support/source_dir.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <iostream>

namespace umbrameter {
namespace {

using Json = nlohmann::json;

class ReportSize : public CliTest {
 protected:
  void SetUp() override {
    require_gl();
    if (run_process({"chromium", "--version"}).exit_code != 0) GTEST_SKIP() << "chromium is not installed";
  }
  std::string path(const std::string& name) const { return (folder() / name).string(); }
};

TEST_F(ReportSize, FourteenScenesOf21RunsStayUnder15MBAndOpenEveryViewer) {
  const ProcessResult validated = umbrameter(
      {"validate", "colonnade", "contact_hardening", "fence", "--technique", "hard", "--technique", "pcf",
       "--technique", "vsm", "--technique", "pcss", "--quality", "quick", "--frames", "1", "--out", "out"},
      {.timeout_s = 400});
  ASSERT_EQ(validated.exit_code, 0) << validated.err;
  const std::string support = source_dir().string() + "/tests/support/";
  ASSERT_EQ(run_process({"python3", support + "repeat_results.py", path("out"), "14", "21"}).exit_code, 0);
  const ProcessResult report = umbrameter({"report", "out", "--out", "report.html"}, {.timeout_s = 400});
  ASSERT_EQ(report.exit_code, 0) << report.err;
  const auto size = std::filesystem::file_size(folder() / "report.html");
  EXPECT_LT(size, 15'000'000u);
  // A viewer opens with the run that is best for the time, whichever that is.
  const char* open_all =
      "(async () => { for (let s = 0; s < 14; ++s) { const viewer = makeViewer(s); while "
      "(viewer.root.dataset.ready !== `${viewer.runIndex} -1`) { "
      "const problem = part(viewer, 'message').textContent; if (problem) throw new Error(problem); "
      "await new Promise(done => setTimeout(done, 10)); } } return [viewers.size, "
      "page.results.scenes[13].techniques.length]; })()";
  write("steps.json", Json({{{"eval", open_all}}}).dump());
  const ProcessResult visit = run_process(
      {"python3", support + "browser.py", path("report.html"), path("steps.json"), path("profile")});
  ASSERT_EQ(visit.exit_code, 0) << visit.err;
  const Json seen = Json::parse(visit.out);
  EXPECT_EQ(seen["console"], Json::array());
  EXPECT_EQ(seen["values"], Json({{14, 21}}));
  std::cout << size << " bytes, loaded in " << seen["load_ms"] << " ms\n";
}

}  // namespace
}  // namespace umbrameter
