// SPDX-License-Identifier: Apache-2.0
#include "report/report.h"

#include "core/files.h"
#include "core/html.h"
#include "report/assets.h"
#include "report/bench_part.h"
#include "report/facts.h"
#include "report/html.h"
#include "report/legend.h"
#include "report/page_data.h"
#include "report/regress_part.h"
#include "report/scene_section.h"
#include "report/stress_part.h"
#include "report/summary.h"
#include "report/table.h"
#include "study/results_json.h"
#include "study/store/store.h"
#include "study/sweep/stored_results.h"

#include <fmt/format.h>

#include <limits>
#include <optional>
#include <set>

namespace umbrameter {
namespace {

std::string skipped_list(const Results& results) {
  if (results.skipped.empty()) return "<p>Nothing was skipped.</p>";
  std::vector<std::string> texts;
  for (const Skip& skip : results.skipped) {
    texts.push_back(fmt::format("{}{}{}: {}", skip.scene, skip.technique.empty() ? "" : ", ", skip.technique,
                                skip.reason));
  }
  return "<ul>" + list_items(texts) + "</ul>";
}

std::string devices(const Results& results) {
  std::set<std::string> names;
  for (const SceneResult& scene : results.scenes) {
    if (scene.reference) names.insert(scene.reference->device);
    for (const TechniqueResult& run : scene.techniques) {
      if (run.device.empty()) continue;
      names.insert(run.timer.empty() ? run.device : run.device + ", timed by " + run.timer);
    }
  }
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : "; ") + name;
  return text;
}

std::string context(const Results& results) {
  const std::string target =
      results.picture.target_se ? fmt::format(", until standard error {}", *results.picture.target_se) : "";
  return fmt::format("umbrameter {} ({}); quality {}, {} x {} px, {} samples per pixel{}, seed {}; {}",
                     results.version, results.commit, results.quality, results.picture.width_px,
                     results.picture.height_px, results.picture.samples_per_pixel, target,
                     results.picture.seed, devices(results));
}

/// Scripts in the order in which they need each other.
std::string scripts() {
  std::string text;
  for (const char* name : {"planes.js", "noise.js", "layers.js", "lit.js", "viewer.js", "viewer_draw.js",
                           "viewer_keys.js", "profile.js", "charts.js", "sweeps.js", "bench.js", "stress.js",
                           "table.js", "overview.js", "worst.js", "page.js"}) {
    text += report_asset(name);
  }
  return text;
}

/// Where results.json with its pictures lies, and what other verbs left (report/side_files.h).
struct Places {
  std::filesystem::path folder, beside;
};

std::string page_html(const std::optional<Results>& given, const Places& places, PlaneStore& store) {
  const Results results = given.value_or(Results());
  const SidePart bench = bench_part(places.beside);
  const RegressPart regress = regress_part(places.beside, results);
  const std::string data = page_data(results, places.folder, places.beside, bench.plots, store);
  std::string scenes;
  for (size_t i = 0; i < results.scenes.size(); ++i) scenes += scene_section(results, i);
  return fill_template(report_asset("page.html"),
                       {{"file_scripts", store.has_files() ? " file:" : ""},
                        {"style", std::string(report_asset("page.css"))},
                        {"chart", std::string(report_asset("chart.min.js"))},
                        {"script", scripts()},
                        {"context", given ? escape_html(context(results))
                                          : "No results.json here: numbers of other commands alone."},
                        {"hidden", given ? "" : " hidden"},
                        {"verdict", regress.verdict + summary_verdicts(results)},
                        {"rows", summary_rows(results)},
                        {"regress", regress.html},
                        {"bench", bench.html},
                        {"stress", stress_part(places.beside)},
                        {"legend", legend()},
                        {"skipped", skipped_list(results)},
                        {"data", data},
                        {"planes", store.blocks()},
                        {"scenes", scenes}});
}

}  // namespace

std::string report_html(const Results& results, const std::filesystem::path& folder) {
  PlaneStore store({}, std::numeric_limits<size_t>::max());
  return page_html(results, {folder, folder}, store);
}

void write_report(const std::filesystem::path& folder, const std::filesystem::path& html_file,
                  size_t budget_bytes, const std::filesystem::path& beside) {
  const Places places{folder, beside.empty() ? folder : beside};
  const std::filesystem::path results_file = folder / "results.json";
  std::optional<Results> results;
  if (!std::filesystem::exists(results_file) && has_store(folder)) {
    Store runs(folder, Database::Mode::read);
    results = stored_results(runs);
  }
  if (!results && (std::filesystem::exists(results_file) || side_files(places.beside).empty()))
    results = parse_results(read_file(results_file), results_file.string());
  PlaneStore store(data_folder(html_file), budget_bytes);
  write_file_atomically(html_file, page_html(results, places, store));
}

std::filesystem::path data_folder(const std::filesystem::path& html_file) {
  return html_file.parent_path() / (html_file.stem().string() + "-data");
}

}  // namespace umbrameter
