// SPDX-License-Identifier: Apache-2.0
#include "tests/unit/report/visit.h"

#include "tests/support/lab/fakes.h"
#include "tests/support/process.h"

#include "core/files.h"
#include "report/report.h"
#include "results/json/results_json.h"
#include "tests/support/source_dir.h"

namespace umbrameter {

using Json = nlohmann::json;

Json evaluate(const std::string& script) {
  return {{"eval", script}};
}

Json press(const std::string& key) {
  return {{"key", key}};
}

Json next_frame() {
  return evaluate("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done())))");
}

std::string ready(int run) {
  return "(async () => { const viewer = makeViewer(0); if (viewer.runIndex !== " + std::to_string(run) +
         ") show(viewer, " + std::to_string(run) + ", -1); while (viewer.root.dataset.ready !== '" +
         std::to_string(run) +
         " -1') await new Promise(done => setTimeout(done, 20)); await new Promise(requestAnimationFrame);"
         "await new Promise(requestAnimationFrame); viewer.root.focus(); })()";
}

void ReportVisit::SetUp() {
  if (run_process({"chromium", "--version"}).exit_code != 0) GTEST_SKIP() << "chromium is not installed";
  write_file_atomically(place("results.json"), to_json_text(fake_results(folder_.path())));
}

Json ReportVisit::visit(const Json& steps, size_t budget_bytes) {
  write_report(folder_.path(), place("report.html"), budget_bytes);
  write_file_atomically(place("steps.json"), steps.dump());
  const ProcessResult result =
      run_process({"python3", source_dir().string() + "/tests/support/browser.py",
                   place("report.html").string(), place("steps.json").string(), place("profile").string()});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  Json seen = result.exit_code == 0 ? Json::parse(result.out) : Json{{"console", {"no visit"}}};
  Json values = Json::array();
  for (const Json& value : seen["values"])
    if (!value.is_null()) values.push_back(value);
  seen["values"] = values;
  return seen;
}

}  // namespace umbrameter
