#include "report/scene_section.h"

#include "core/files.h"
#include "report/html.h"
#include "report/table.h"
#include "study/diagnosis_format.h"
#include "study/format.h"
#include "study/judgement_format.h"
#include "study/metadata.h"

#include <fmt/format.h>

namespace umbrameter {
namespace {

std::string line(const std::string& term, const std::string& text) {
  return fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", escape_html(term), escape_html(text));
}

std::string picture(const std::filesystem::path& folder, const std::string& file, const std::string& title,
                    const std::string& alternative, const std::string& context) {
  if (file.empty()) return {};
  const std::string data = encode_base64(read_file(folder / file));
  return fmt::format(
      "<figure><figcaption>{}</figcaption><img src=\"data:image/png;base64,{}\" alt=\"{}\" "
      "decoding=\"async\"><dl>{}</dl></figure>\n",
      escape_html(title), data, escape_html(alternative), context);
}

std::string common_context(const Results& results, const SceneResult& scene) {
  return line("scene hash", scene.hash) + line("seed", std::to_string(results.seed)) +
         line("resolution", fmt::format("{} x {} px", results.width_px, results.height_px));
}

std::string reference_figures(const Results& results, const SceneResult& scene,
                              const std::filesystem::path& folder) {
  std::string html;
  if (scene.reference) {
    const ReferenceResult& reference = *scene.reference;
    const std::string context =
        line("samples", fmt::format("{:.0f} a pixel on average", reference.mean_sample_count)) +
        line("standard error", fmt::format("{:.2g} on average, {:.2g} at most", reference.mean_visibility_se,
                                           reference.max_visibility_se)) +
        line("device", reference.device) + line("time", fmt::format("{:.2f} s", reference.wall_time_s)) +
        line("file", reference.image_file) + common_context(results, scene);
    html += picture(folder, reference.picture_file, "Reference visibility",
                    "Reference visibility of " + scene.name, context);
  }
  if (scene.parity) {
    html += picture(folder, scene.parity->picture_file, "Parity of the two renderers",
                    "Where the two renderers see other surfaces in " + scene.name,
                    line("parity", format_parity(*scene.parity)) + common_context(results, scene));
  }
  return html;
}

std::string pass_lines(const TechniqueResult& run) {
  std::string lines;
  for (const PassTime& time : run.pass_times) lines += line("pass " + time.pass, format_time(time));
  if (!run.pass_times.empty()) lines += line("timer", run.timer);
  return lines;
}

std::string region_text(const RegionError& region) {
  if (region.pixels == 0) return "no pixels";
  return fmt::format("{} of scored pixels, RMSE {}, bias {}", format_share(region.share),
                     format_error(region_rmse(region)), format_signed_error(region.bias));
}

std::string term_lines(const TermLines& lines) {
  std::string html;
  for (const auto& [term, text] : lines) html += line(term, text);
  return html;
}

std::string error_lines(const TechniqueResult& run) {
  if (!run.error) return {};
  const VisibilityError& error = *run.error;
  return line("RMSE", format_interval(error.rmse)) + line("mean error", format_signed_error(error.bias)) +
         line("mean |error|", format_error(error.mae)) +
         line("largest |error|", format_error(error.max_error)) + line("lit", region_text(error.lit)) +
         line("penumbra", region_text(error.penumbra)) + line("umbra", region_text(error.umbra)) +
         line("scored", fmt::format("{} pixels", error.scored_pixels)) +
         line("beyond the scale", format_share(run.clipped_share)) +
         term_lines(judgement_lines(run.judgement)) +
         (run.diagnosis ? term_lines(penumbra_lines(*run.diagnosis)) : "");
}

std::string technique_figures(const Results& results, const SceneResult& scene, const TechniqueResult& run,
                              const std::filesystem::path& folder) {
  const std::string context = line("parameters", to_text(run.parameters)) + line("technique hash", run.hash) +
                              line("device", run.device) + common_context(results, scene);
  std::string html = fmt::format("<h3>{}</h3><p>{}</p>", escape_html(run.label), escape_html(run.title));
  if (run.failure) html += fmt::format("<p class=\"problem\">{}</p>", escape_html(run.failure->message));
  if (!run.warnings.empty()) html += "<ul class=\"warnings\">" + list_items(run.warnings) + "</ul>";
  html += "<div class=\"figures\">";
  html += picture(folder, run.picture_file, run.label + ": visibility", "Visibility by " + run.label,
                  pass_lines(run) + line("file", run.image_file) + context);
  html += picture(folder, run.error_picture_file, run.label + ": error against the reference",
                  "Signed visibility error of " + run.label, error_lines(run) + context);
  if (!run.diagnosis) return html + "</div>\n";
  html += picture(folder, run.fault_picture_file, run.label + ": faults",
                  "Class of every wrong pixel of " + run.label,
                  term_lines(fault_lines(*run.diagnosis)) + context);
  return html + "</div>\n";
}

}  // namespace

std::string list_items(const std::vector<std::string>& texts) {
  std::string items;
  for (const std::string& text : texts) items += "<li>" + escape_html(text) + "</li>";
  return items;
}

std::string scene_section(const Results& results, size_t scene_index, const std::filesystem::path& folder) {
  const SceneResult& scene = results.scenes.at(scene_index);
  std::string html = fmt::format(
      "<section id=\"{}\"><h2>{}: {}</h2><p>{}</p><p>{} triangles; {} light '{}'; scene hash {}</p>\n",
      scene_anchor(scene_index), escape_html(scene.name), escape_html(scene.title), escape_html(scene.doc),
      scene.triangles, escape_html(scene.light_type), escape_html(scene.light_name), escape_html(scene.hash));
  if (scene.failure) html += fmt::format("<p class=\"problem\">{}</p>", escape_html(scene.failure->message));
  if (scene.parity) {
    html += fmt::format("<p class=\"{}\">Parity: {}</p>", scene.parity->passes ? "parity" : "problem",
                        escape_html(format_parity(*scene.parity)));
  }
  std::vector<std::string> warnings = scene.warnings;
  if (scene.reference)
    warnings.insert(warnings.end(), scene.reference->warnings.begin(), scene.reference->warnings.end());
  if (!warnings.empty()) html += "<ul class=\"warnings\">" + list_items(warnings) + "</ul>";
  html += "<div class=\"figures\">" + reference_figures(results, scene, folder) + "</div>\n";
  for (const TechniqueResult& run : scene.techniques) html += technique_figures(results, scene, run, folder);
  return html + "</section>\n";
}

}  // namespace umbrameter
