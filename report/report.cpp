// SPDX-License-Identifier: Apache-2.0
#include "report/report.h"

#include "core/error.h"
#include "core/files.h"
#include "lab/stored_results.h"
#include "report/assets.h"
#include "report/before.h"
#include "report/html.h"
#include "report/page_data.h"
#include "report/side_files.h"
#include "results/json/results_json.h"
#include "store/store.h"

#include <fmt/format.h>

#include <limits>
#include <optional>

namespace umbrameter {
namespace {

/// Scripts in the order in which they need each other.
std::string scripts() {
  std::string text;
  for (const char* name : {"planes.js",        "noise.js",       "layers.js",
                           "lit.js",           "viewer.js",      "viewer_draw.js",
                           "viewer_values.js", "viewer_keys.js", "viewer_pointer.js",
                           "figure.js",        "figure_save.js", "profile.js",
                           "histogram.js",     "charts.js",      "make_table.js",
                           "sweeps.js",        "bench.js",       "bench_part.js",
                           "regress.js",       "stress_map.js",  "stress.js",
                           "table.js",         "metrics.js",     "overview.js",
                           "front.js",         "worst.js",       "summary.js",
                           "scene_section.js", "page.js"}) {
    text += report_asset(name);
  }
  return text;
}

/// Where results.json with its pictures lies, and what other verbs left (report/side_files.h).
struct Places {
  std::filesystem::path folder, beside;
};

std::string page_html(const std::optional<Results>& results, const Places& places, PlaneStore& store) {
  const std::string data = page_data(results, places.folder, places.beside, store);
  return fill_template(report_asset("page.html"), {{"file_scripts", store.has_files() ? " file:" : ""},
                                                   {"style", std::string(report_asset("page.css"))},
                                                   {"chart", std::string(report_asset("chart.min.js"))},
                                                   {"script", scripts()},
                                                   {"data", data},
                                                   {"planes", store.blocks()}});
}

}  // namespace

std::string report_html(const Results& results, const std::filesystem::path& folder) {
  PlaneStore store({}, std::numeric_limits<size_t>::max());
  return page_html(results, {folder, folder}, store);
}

namespace {

/// results.json of `folder`, or the runs of its store; absent where there is neither and `may_be_absent`.
std::optional<Results> results_of(const std::filesystem::path& folder, bool may_be_absent) {
  const std::filesystem::path file = folder / "results.json";
  if (!std::filesystem::exists(file) && has_store(folder)) {
    Store runs(folder, Database::Mode::read);
    if (auto results = stored_results(runs)) return results;
  }
  if (may_be_absent && !std::filesystem::exists(file)) return std::nullopt;
  if (std::filesystem::is_directory(folder) && !std::filesystem::exists(file))
    fail_input(fmt::format("'{}' has nothing that a page shows", folder.string()), {},
               "validate, score, sweep, bench, tune, stress and regress leave something there with --out");
  return parse_results(read_file(file), file.string());
}

}  // namespace

void write_report(const std::filesystem::path& folder, const std::filesystem::path& html_file,
                  size_t budget_bytes, const std::filesystem::path& beside,
                  const std::filesystem::path& before) {
  const Places places{folder, beside.empty() ? folder : beside};
  std::optional<Results> results = results_of(folder, !side_files(places.beside).empty());
  if (results && !before.empty()) add_before(*results, folder, *results_of(before, false), before);
  PlaneStore store(data_folder(html_file), budget_bytes);
  write_file_atomically(html_file, page_html(results, places, store));
}

std::filesystem::path data_folder(const std::filesystem::path& html_file) {
  return html_file.parent_path() / (html_file.stem().string() + "-data");
}

}  // namespace umbrameter
