#include "cli/validation_text.h"

#include "cli/console.h"
#include "study/diagnosis_format.h"
#include "study/format.h"
#include "study/judgement_format.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <map>

namespace umbrameter {
namespace {

std::string verdict_cell(const SceneResult& scene, const TechniqueResult& run) {
  const bool is_baseline = std::ranges::any_of(scene.techniques, [&](const TechniqueResult& other) {
    return other.judgement.verdict && other.judgement.verdict->baseline == run.label;
  });
  return is_baseline ? "baseline" : format_verdict(run.judgement.verdict);
}

std::vector<std::string> row(const SceneResult& scene, const TechniqueResult& run) {
  std::string time = format_time(total_time(run.pass_times));
  if (run.is_reused && total_time(run.pass_times)) time += " stored";
  const std::string memory = run.memory_bytes > 0 ? format_bytes(run.memory_bytes) : kNotApplicable;
  if (!run.error) {
    const char* reason = run.failure ? "failed" : scene.parity ? "void" : "not compared";
    return {scene.name, run.label, reason, "", "", "", "", "", "", time, memory};
  }
  const VisibilityError& error = *run.error;
  return {scene.name,
          run.label,
          format_interval(error.rmse),
          format_signed_error(error.bias),
          format_error(error.over_shadowing),
          format_error(error.under_shadowing),
          format_error(region_rmse(error.penumbra)),
          format_worst_fault(run.diagnosis),
          verdict_cell(scene, run),
          time,
          memory};
}

std::string table(const Results& results) {
  std::vector<std::vector<std::string>> rows;
  for (const SceneResult& scene : results.scenes) {
    for (const TechniqueResult& run : scene.techniques) rows.push_back(row(scene, run));
  }
  return format_table({"scene", "technique", "RMSE [95 %]", "mean", "over", "under", "penumbra",
                       "worst fault", "verdict", "time", "memory"},
                      rows);
}

/// Scenes where a run leaves out the same share a line.
std::string left_out_list(const Results& results) {
  std::map<std::string, size_t> scenes;
  for (const SceneResult& scene : results.scenes) {
    for (const TechniqueResult& run : scene.techniques) {
      if (!run.left_out.empty()) ++scenes[fmt::format("{}: {}", run.label, fmt::join(run.left_out, ", "))];
    }
  }
  std::string text;
  for (const auto& [part, count] : scenes)
    text += fmt::format("not needed in {} of {} scenes, {}\n", count, results.scenes.size(), part);
  return text;
}

std::string scene_lists(const Results& results) {
  std::string text;
  for (const SceneResult& scene : results.scenes) {
    if (scene.parity) text += fmt::format("{}: {}\n", scene.name, format_parity(*scene.parity));
    for (const std::string& warning : scene.warnings)
      text += fmt::format("{}: warning: {}\n", scene.name, warning);
    for (const TechniqueResult& run : scene.techniques) {
      for (const auto& [term, meaning] : judgement_lines(run.judgement)) {
        text += fmt::format("{}, {}: {}: {}\n", scene.name, run.label, term, meaning);
      }
      if (run.temporal)
        text += fmt::format("{}, {}: {}\n", scene.name, run.label, format_temporal(*run.temporal));
      for (const std::string& warning : run.warnings) {
        text += fmt::format("{}, {}: warning: {}\n", scene.name, run.label, warning);
      }
    }
  }
  for (const Skip& skip : results.skipped) {
    const std::string saved = skip.saved_s ? fmt::format(" (saves about {:.2g} s)", *skip.saved_s) : "";
    text += fmt::format("skipped {}{}{}: {}{}\n", skip.scene, skip.technique.empty() ? "" : ", ",
                        skip.technique, skip.reason, saved);
  }
  return text + left_out_list(results);
}

}  // namespace

std::string scene_line(const SceneResult& scene) {
  if (scene.failure) return fmt::format("{}: failed", scene.name);
  const std::string parity = scene.parity ? format_share(scene.parity->agreement) : kNotApplicable;
  return fmt::format("{}: done, parity {}", scene.name, parity);
}

std::string work_line(const WorkDone& work) {
  return fmt::format("{} runs and {} truths rendered; {} runs and {} truths reused", work.rendered,
                     work.references_rendered, work.reused, work.references_reused);
}

std::string validation_text(const Results& results) {
  return fmt::format("quality {}, {} x {} px, {} samples a pixel, seed {}\n\n{}\n{}", results.quality,
                     results.width_px, results.height_px, results.samples_per_pixel, results.seed,
                     table(results), scene_lists(results));
}

}  // namespace umbrameter
