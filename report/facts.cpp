// SPDX-License-Identifier: Apache-2.0
#include "report/facts.h"

#include "results/catalogue.h"
#include "results/causes_format.h"
#include "results/diagnosis_format.h"
#include "results/format.h"
#include "results/judgement_format.h"
#include "results/metadata.h"
#include "results/similarity_format.h"

#include <fmt/format.h>

namespace umbrameter {
namespace {

void append(TermLines& lines, const TermLines& more) {
  lines.insert(lines.end(), more.begin(), more.end());
}

std::string region_text(const RegionError& region) {
  if (region.pixels == 0) return "no pixels";
  return fmt::format("{} of scored pixels, RMSE {}, mean error {}", format_share(region.share),
                     format_error(region_rmse(region)), format_signed_error(region.bias));
}

TermLines error_lines(const TechniqueResult& run) {
  if (!run.error) return {};
  const VisibilityError& error = *run.error;
  TermLines lines = metric_lines(run, "error");
  append(lines, {{"lit", region_text(error.lit)},
                 {"penumbra", region_text(error.penumbra)},
                 {"umbra", region_text(error.umbra)},
                 {"scored", fmt::format("{} pixels", error.scored_pixels)},
                 {"beyond the scale", format_share(run.clipped_share)}});
  append(lines, judgement_lines(run.judgement));
  if (run.similarity) append(lines, similarity_lines(*run.similarity));
  return lines;
}

void append_diagnosis(TermLines& lines, const TechniqueResult& run) {
  if (!run.diagnosis) return;
  append(lines, penumbra_lines(*run.diagnosis));
  append(lines, fault_lines(*run.diagnosis));
  if (run.fault_causes) append(lines, substitution_lines(*run.fault_causes));
  append(lines, cause_lines(*run.diagnosis));
}

void append_times(TermLines& lines, const TechniqueResult& run) {
  for (const PassTime& time : run.pass_times) lines.emplace_back("pass " + time.pass, format_time(time));
  if (!run.pass_times.empty()) lines.emplace_back("timer", run.timer);
}

}  // namespace

TermLines reference_facts(const SceneResult& scene) {
  const ReferenceResult& reference = *scene.reference;
  TermLines lines{{"samples", fmt::format("{:.0f} per pixel on average", reference.mean_sample_count)},
                  {"standard error", fmt::format("{:.2g} on average, {:.2g} at most",
                                                 reference.mean_visibility_se, reference.max_visibility_se)},
                  {"model gap", fmt::format("{} (irradiance ratio less visibility), {} of the lit picture",
                                            format_error(reference.model_gap_rmse),
                                            format_error(reference.model_gap_lit_rmse))}};
  if (scene.quantity != "visibility") lines.emplace_back("quantity", scene.quantity + " ratio");
  lines.emplace_back("device", reference.device);
  lines.emplace_back("time", fmt::format("{:.2f} s", reference.wall_time_s));
  lines.emplace_back("file", reference.image_file);
  return lines;
}

TermLines run_facts(const TechniqueResult& run) {
  TermLines lines = error_lines(run);
  append_diagnosis(lines, run);
  if (run.frames_before > 0) lines.emplace_back("history", format_history(run));
  if (run.temporal) lines.emplace_back("over time", format_temporal(*run.temporal));
  append_times(lines, run);
  append(lines, {{"parameters", to_text(run.parameters)},
                 {"technique hash", run.hash},
                 {"device", run.device},
                 {"file", run.image_file}});
  return lines;
}

}  // namespace umbrameter
