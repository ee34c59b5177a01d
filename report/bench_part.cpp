// SPDX-License-Identifier: Apache-2.0
#include "report/bench_part.h"

#include "core/html.h"
#include "report/bench_tables.h"
#include "report/facts.h"

#include <fmt/format.h>

namespace umbrameter {
namespace {

using Json = nlohmann::ordered_json;

std::string names(const Json& labels) {
  std::string text;
  for (const Json& label : labels) text += (text.empty() ? "" : ", ") + label.get<std::string>();
  return text.empty() ? "none" : text;
}

/// What was asked and what came of it, of a scene.
std::string answers(const Json& scene, const Json& study) {
  std::string text;
  if (!scene.at("recommended").is_null())
    text += fmt::format("Recommended, by the least product of time and RMSE: {}. ",
                        text_of(scene, "recommended"));
  if (scene.contains("best_under"))
    text += fmt::format("Best under {:g} ms: {}. ", study.at("best_under_ms").get<double>(),
                        names(scene.at("best_under")));
  if (scene.contains("cheapest_below_rmse"))
    text += fmt::format("Cheapest below RMSE {:g}: {}. ", study.at("rmse_limit").get<double>(),
                        names(scene.at("cheapest_below_rmse")));
  return text.empty() ? "" : "<p>" + escape_html(text) + "</p>\n";
}

std::string canvas(const char* role, const std::string& name, const std::string& note) {
  return fmt::format(
      "<div class=\"plot\"><h4>{0}</h4>{2}<div class=\"plot-area\"><canvas data-role=\"{1}\" role=\"img\" "
      "aria-label=\"{0}; the numbers are in the table below\"></canvas></div></div>\n",
      escape_html(name), role, note.empty() ? "" : "<p class=\"note\">" + escape_html(note) + "</p>");
}

std::string scene_figure(const Json& scene, const Json& study, size_t number) {
  std::string html = fmt::format(
      "<figure class=\"bench\" id=\"bench-{}\"><figcaption>{}: {}</figcaption>"
      "<p class=\"context\">{} triangles; {} light; scene hash {}; truth by {}</p>\n",
      number, escape_html(text_of(scene, "name")), escape_html(text_of(scene, "title")),
      scene.at("triangles").get<uint64_t>(), escape_html(text_of(scene, "light")),
      escape_html(text_of(scene, "hash")), escape_html(text_of(scene, "reference_device")));
  if (!scene.at("failure").is_null())
    html += "<p class=\"problem\">" + escape_html(text_of(scene.at("failure"), "message")) + "</p>\n";
  const auto warnings = scene.at("warnings").get<std::vector<std::string>>();
  if (!warnings.empty()) html += "<ul class=\"warnings\">" + list_items(warnings) + "</ul>\n";
  html += "<div class=\"plots\">" + canvas("bench", "Time against error", text_of(study, "note"));
  const std::string truth = bench_truth_table(scene);
  if (!truth.empty()) html += canvas("truth", "The truth's own time against error", {});
  return html + "</div>\n" + answers(scene, study) + bench_runs_table(scene) + truth +
         bench_claims_table(scene) + "</figure>\n";
}

std::string overall(const Json& study) {
  const Json& best = study.at("recommended");
  if (best.is_null() || best.at("scenes").get<size_t>() < 2) return {};
  return fmt::format(
      "<p>Recommended over {} scenes: {} (time x RMSE is {:.3g} times each scene's least).</p>\n",
      best.at("scenes").get<size_t>(), escape_html(text_of(best, "label")), best.at("cost").get<double>());
}

std::string study_heading(const Json& study, const std::string& file) {
  return fmt::format(
      "<h3>{}</h3><p>{}</p><p class=\"context\">{}: study {}; umbrameter {} ({}); {} x {} px, {} samples a "
      "pixel; up to {} frames a run</p>\n",
      escape_html(text_of(study, "title")), escape_html(text_of(study, "doc")), escape_html(file),
      escape_html(text_of(study, "study")), escape_html(text_of(study, "version")),
      escape_html(text_of(study, "commit")), study.at("width_px").get<int>(),
      study.at("height_px").get<int>(), study.at("samples_per_pixel").get<int>(),
      study.at("wanted_frames").get<int>());
}

Json plot_json(const Json& scene, const Json& study) {
  Json runs = Json::array();
  for (const Json& run : scene.at("runs")) {
    if (run.at("time_ms").is_null() || run.at("rmse").is_null()) continue;
    runs.push_back({{"label", run.at("label")},
                    {"time_ms", run.at("time_ms")},
                    {"rmse", run.at("rmse")},
                    {"is_on_front", run.at("is_on_front")}});
  }
  return {{"runs", runs},
          {"recommended", scene.at("recommended")},
          {"note", study.at("note")},
          {"truth", scene.contains("truth") ? scene.at("truth") : Json(nullptr)}};
}

void add_study(const Json& study, const std::string& file, SidePart& part) {
  part.html += study_heading(study, file) + overall(study);
  for (const Json& scene : study.at("scenes")) {
    part.plots.push_back(plot_json(scene, study));
    part.html += scene_figure(scene, study, part.plots.size());
  }
}

}  // namespace

SidePart bench_part(const std::filesystem::path& folder) {
  SidePart part;
  for_side_files(folder, "bench", [&](const Json& document, const std::string& file) {
    const Json studies = document.contains("studies") ? document.at("studies") : Json::array({document});
    for (const Json& study : studies) add_study(study, file, part);
  });
  if (part.html.empty()) return part;
  part.html =
      "<section id=\"bench\"><h2>Time against error</h2>\n"
      "<p>Frames of all runs timed in turn. Bars are 95 % intervals of the median time and of the debiased "
      "RMSE. A run is "
      "behind another when both of the other's intervals lie below its own; the rest is the front.</p>\n" +
      part.html + "</section>\n";
  return part;
}

}  // namespace umbrameter
