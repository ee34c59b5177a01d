// SPDX-License-Identifier: Apache-2.0
#include "report/facts.h"

#include "core/html.h"
#include "study/causes/causes_format.h"
#include "study/diagnosis_format.h"
#include "study/format.h"
#include "study/judgement_format.h"
#include "study/metadata.h"
#include "study/similarity_format.h"

#include <fmt/format.h>

namespace umbrameter {
namespace {

std::string line(const std::string& term, const std::string& text) {
  return fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", escape_html(term), escape_html(text));
}

std::string term_lines(const TermLines& lines) {
  std::string html;
  for (const auto& [term, text] : lines) html += line(term, text);
  return html;
}

std::string common_context(const Results& results, const SceneResult& scene) {
  return line("scene hash", scene.hash) + line("seed", std::to_string(results.picture.seed)) +
         line("resolution", fmt::format("{} x {} px", results.picture.width_px, results.picture.height_px)) +
         line("version", fmt::format("umbrameter {} ({})", results.version, results.commit));
}

std::string region_text(const RegionError& region) {
  if (region.pixels == 0) return "no pixels";
  return fmt::format("{} of scored pixels, RMSE {}, bias {}", format_share(region.share),
                     format_error(region_rmse(region)), format_signed_error(region.bias));
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
         (run.similarity ? term_lines(similarity_lines(*run.similarity)) : "");
}

std::string diagnosis_lines(const TechniqueResult& run) {
  if (!run.diagnosis) return {};
  return term_lines(penumbra_lines(*run.diagnosis)) + term_lines(fault_lines(*run.diagnosis)) +
         (run.fault_causes ? term_lines(substitution_lines(*run.fault_causes)) : "") +
         term_lines(cause_lines(*run.diagnosis));
}

std::string time_lines(const TechniqueResult& run) {
  std::string lines;
  for (const PassTime& time : run.pass_times) lines += line("pass " + time.pass, format_time(time));
  if (!run.pass_times.empty()) lines += line("timer", run.timer);
  return lines;
}

}  // namespace

std::string reference_facts(const Results& results, const SceneResult& scene) {
  const ReferenceResult& reference = *scene.reference;
  return line("samples", fmt::format("{:.0f} per pixel on average", reference.mean_sample_count)) +
         line("standard error", fmt::format("{:.2g} on average, {:.2g} at most", reference.mean_visibility_se,
                                            reference.max_visibility_se)) +
         line("model gap", fmt::format("{} (irradiance ratio less visibility), {} of the lit picture",
                                       format_error(reference.model_gap_rmse),
                                       format_error(reference.model_gap_lit_rmse))) +
         (scene.quantity == "visibility" ? "" : line("quantity", scene.quantity + " ratio")) +
         (scene.parity ? line("parity", format_parity(*scene.parity)) : "") +
         line("device", reference.device) + line("time", fmt::format("{:.2f} s", reference.wall_time_s)) +
         line("file", reference.image_file) + common_context(results, scene);
}

std::string run_facts(const Results& results, const SceneResult& scene, const TechniqueResult& run) {
  return error_lines(run) + diagnosis_lines(run) +
         (run.temporal ? line("over time", format_temporal(*run.temporal)) : "") + time_lines(run) +
         line("parameters", to_text(run.parameters)) + line("technique hash", run.hash) +
         line("device", run.device) + line("file", run.image_file) + common_context(results, scene);
}

std::string list_items(const std::vector<std::string>& texts) {
  std::string items;
  for (const std::string& text : texts) items += "<li>" + escape_html(text) + "</li>";
  return items;
}

}  // namespace umbrameter
