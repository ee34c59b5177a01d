// SPDX-License-Identifier: Apache-2.0
// Without these tests the page could break in a browser: scripts that fail, numbers that are not those of
// results.json, a table that cannot be sorted, a layout wider than a narrow screen.

#include "tests/support/lab/fakes.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

#include "core/files.h"
#include "report/report.h"
#include "results/json/results_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <regex>

namespace umbrameter {
namespace {

using testing::HasSubstr;
using testing::Not;

class ReportBrowser : public testing::Test {
 protected:
  void SetUp() override {
    if (run_process({"chromium", "--version"}).exit_code != 0) GTEST_SKIP() << "chromium is not installed";
    const Results results = fake_results(folder_.path());
    write_file_atomically(folder_.path() / "results.json", to_json_text(results));
    write_report(folder_.path(), page());
  }

  std::filesystem::path page() const { return folder_.path() / "report.html"; }

  /// The page's DOM after its scripts and `extra_script` ran.
  ProcessResult open_page(const std::string& extra_script = {}, const std::string& window = "1200,900") {
    std::string html = read_file(page());
    if (!extra_script.empty()) {
      html.insert(html.rfind("</body>"),
                  "<script>window.addEventListener('load', () => {" + extra_script + "});</script>");
    }
    write_file_atomically(folder_.path() / "opened.html", html);
    return run_process({"chromium", "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                        "--enable-logging=stderr", "--window-size=" + window,
                        "--user-data-dir=" + (folder_.path() / "profile").string(), "--dump-dom",
                        "file://" + (folder_.path() / "opened.html").string()});
  }

  TemporaryFolder folder_;
};

/// The cell of `column` in the row of `technique`: its data-value and its text.
std::pair<std::string, std::string> cell(const std::string& dom, const std::string& technique,
                                         const std::string& column) {
  const size_t row = dom.find("<tr data-scene=\"plate\" data-technique=\"" + technique + "\">");
  if (row == std::string::npos) return {};
  const std::string cells = dom.substr(row, dom.find("</tr>", row) - row);
  const std::regex pattern("data-column=\"" + column + "\" data-value=\"([^\"]*)\">([^<]*)<");
  std::smatch match;
  return std::regex_search(cells, match, pattern) ? std::pair(match.str(1), match.str(2))
                                                  : std::pair<std::string, std::string>();
}

double worst_part(const nlohmann::json& faults) {
  const auto& worst = faults["worst"];
  return worst.is_null() ? 0.0 : faults["classes"][worst.get<std::string>()]["mean_abs_error"].get<double>();
}

TEST_F(ReportBrowser, ShowsTheNumbersOfResultsJsonAndLogsNoError) {
  const ProcessResult result = open_page();
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, Not(HasSubstr("CONSOLE")));
  EXPECT_THAT(result.out,
              testing::ContainsRegex("<html lang=\"en\" data-theme=\"(light|dark)\">"));  // the script ran
  const auto json = nlohmann::json::parse(read_file(folder_.path() / "results.json"));
  for (const auto& run : json["scenes"][0]["techniques"]) {
    if (run["error"].is_null()) continue;
    const auto& error = run["error"];
    const std::vector<std::pair<std::string, double>> expected{
        {"rmse", error["rmse"]["value"]},
        {"bias", error["bias"]},
        {"over_shadowing", error["over_shadowing"]},
        {"under_shadowing", error["under_shadowing"]},
        {"penumbra_rmse", error["penumbra"]["rmse"]},
        {"worst_fault", worst_part(run["faults"])},
        {"total_ms", run["pass_times"].back()["median_ms"]},
        {"memory_bytes", run["memory_bytes"]}};
    for (const auto& [column, value] : expected) {
      const auto [data, text] = cell(result.out, run["label"], column);
      ASSERT_FALSE(data.empty()) << run["label"] << " " << column;
      EXPECT_EQ(std::stod(data), value) << column;
      if (column == "memory_bytes" || column == "worst_fault") continue;  // in MiB; after a word
      EXPECT_NEAR(std::stod(text), value, 0.5e-3) << column;
    }
  }
}

TEST_F(ReportBrowser, WouldNoticeAScriptThatFails) {
  EXPECT_THAT(open_page("throw new Error('on purpose');").err, HasSubstr("CONSOLE"));
}

TEST_F(ReportBrowser, SortsByAColumnWithAbsentValuesLast) {
  const std::string click = "document.querySelectorAll('#results thead button')[3].click();";
  const std::string ascending = open_page(click).out;
  EXPECT_LT(ascending.find("data-technique=\"exact\""), ascending.find("data-technique=\"off\""));
  EXPECT_LT(ascending.find("data-technique=\"off\""), ascending.find("data-technique=\"broken\""));
  const std::string descending = open_page(click + click).out;
  EXPECT_LT(descending.find("data-technique=\"off\""), descending.find("data-technique=\"exact\""));
  EXPECT_LT(descending.find("data-technique=\"exact\""), descending.find("data-technique=\"broken\""));
  EXPECT_THAT(descending, HasSubstr("aria-sort=\"descending\""));
}

TEST_F(ReportBrowser, FitsANarrowScreen) {
  const std::string measure =
      "document.body.dataset.overflow = String(document.documentElement.scrollWidth - window.innerWidth);";
  const std::string dom = open_page(measure, "500,900").out;
  std::smatch match;
  ASSERT_TRUE(std::regex_search(dom, match, std::regex("data-overflow=\"(-?[0-9]+)\"")))
      << dom.substr(0, 500);
  EXPECT_LE(std::stoi(match.str(1)), 0);
}

}  // namespace
}  // namespace umbrameter
