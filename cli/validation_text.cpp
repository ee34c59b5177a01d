// SPDX-License-Identifier: Apache-2.0
#include "cli/validation_text.h"

#include "cli/console.h"
#include "results/catalogue.h"
#include "results/causes_format.h"
#include "results/diagnosis_format.h"
#include "results/format.h"
#include "results/judgement_format.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <map>

namespace umbrameter {
namespace {

/// What grew against the run's baseline; empty for the baseline itself.
std::string growth_cell(const SceneResult& scene, const TechniqueResult& run) {
  if (!run.judgement.verdict) return "";
  const auto baseline =
      std::ranges::find(scene.techniques, run.judgement.verdict->baseline, &TechniqueResult::label);
  return baseline == scene.techniques.end() ? "" : format_growth(run.diagnosis, baseline->diagnosis);
}

std::string verdict_cell(const SceneResult& scene, const TechniqueResult& run) {
  const bool is_baseline = std::ranges::any_of(scene.techniques, [&](const TechniqueResult& other) {
    return other.judgement.verdict && other.judgement.verdict->baseline == run.label;
  });
  return is_baseline ? "baseline" : format_verdict(run.judgement.verdict);
}

/// The rows of the catalogue that have a column.
std::vector<const Metric*> metric_columns() {
  std::vector<const Metric*> columns;
  for (const Metric& metric : metric_catalogue()) {
    if (!metric.heading.empty()) columns.push_back(&metric);
  }
  return columns;
}

std::vector<std::string> row(const SceneResult& scene, const TechniqueResult& run) {
  std::vector<std::string> cells{scene.name, run.label};
  for (const Metric* metric : metric_columns()) cells.push_back(run.error ? format_metric(*metric, run) : "");
  const char* reason = run.failure ? "failed" : scene.parity ? "void" : "not compared";
  if (!run.error) cells[2] = reason;
  cells.push_back(run.error ? format_faults(run.diagnosis) : "");
  cells.push_back(run.error ? verdict_cell(scene, run) : "");
  cells.push_back(run.error ? growth_cell(scene, run) : "");
  std::string time = format_time(total_time(run.pass_times));
  if (run.is_reused && total_time(run.pass_times)) time += " stored";
  cells.push_back(time);
  cells.push_back(run.memory_bytes > 0 ? format_bytes(run.memory_bytes) : kNotApplicable);
  return cells;
}

std::string table(const Results& results) {
  std::vector<std::vector<std::string>> rows;
  for (const SceneResult& scene : results.scenes) {
    for (const TechniqueResult& run : scene.techniques) rows.push_back(row(scene, run));
  }
  std::vector<std::string> head{"scene", "technique"};
  for (const Metric* metric : metric_columns()) head.push_back(metric->heading);
  head.insert(head.end(), {"faults", "verdict", "grew", "time", "memory"});
  return format_table(head, rows);
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

/// The same warning of several runs a line.
std::string warning_list(const Results& results) {
  std::vector<std::pair<std::string, std::vector<std::string>>> warnings;
  const auto add = [&](const std::string& text, const std::string& who) {
    auto known = std::ranges::find(warnings, text, [](const auto& entry) { return entry.first; });
    if (known == warnings.end()) known = warnings.insert(known, {text, {}});
    known->second.push_back(who);
  };
  for (const SceneResult& scene : results.scenes) {
    for (const std::string& text : scene.warnings) add(text, scene.name);
    for (const TechniqueResult& run : scene.techniques) {
      const std::string subject = fmt::format("technique '{}': ", run.technique);
      for (const std::string& text : run.warnings) {
        add(text.starts_with(subject) ? text.substr(subject.size()) : text, scene.name + ", " + run.label);
      }
    }
  }
  std::string list;
  for (const auto& [text, who] : warnings) {
    const std::string others = who.size() > 1 ? fmt::format(" and {} more", who.size() - 1) : "";
    list += fmt::format("warning: {}{}: {}\n", who.front(), others, text);
  }
  return list;
}

/// What no technique that gives visibility can mend.
std::string model_gaps(const Results& results) {
  std::string text;
  for (const SceneResult& scene : results.scenes) {
    if (!scene.reference || !scene.reference->model_gap_rmse) continue;
    text += fmt::format(
        "{}: model gap {} (irradiance ratio less visibility of the truth), {} of the lit picture\n",
        scene.name, format_error(scene.reference->model_gap_rmse),
        format_error(scene.reference->model_gap_lit_rmse));
  }
  return text;
}

/// What was asked for, and verdicts that more samples would decide.
std::string findings(const Results& results) {
  std::string text;
  for (const SceneResult& scene : results.scenes) {
    for (const TechniqueResult& run : scene.techniques) {
      const auto add = [&](const std::string& line) {
        text += fmt::format("{}, {}: {}\n", scene.name, run.label, line);
      };
      const auto& [significance, verdict, limit] = run.judgement;
      if (limit) add(limit_line(*limit));
      if (verdict && verdict->more_samples) add(verdict_line(*verdict));
      if (run.temporal) add(format_temporal(*run.temporal));
    }
  }
  return text;
}

/// What mends the faults, a line each.
std::string causes(const Results& results) {
  std::string text, first_reason;
  size_t skipped = 0;
  for (const SceneResult& scene : results.scenes) {
    for (const TechniqueResult& run : scene.techniques) {
      if (!run.fault_causes) continue;
      for (const std::string& sentence : cause_sentences(*run.fault_causes))
        text += fmt::format("{}, {}: {}\n", scene.name, run.label, sentence);
      if (!run.fault_causes->skipped) continue;
      if (skipped++ == 0)
        first_reason = fmt::format("{}, {}: {}", scene.name, run.label, *run.fault_causes->skipped);
    }
  }
  if (skipped == 0) return text;
  return text + fmt::format("causes of {} {} not looked for ({})\n", skipped, skipped == 1 ? "run" : "runs",
                            first_reason);
}

/// Every substitution of every run that has any.
std::string cause_tables(const Results& results) {
  std::string text;
  for (const SceneResult& scene : results.scenes) {
    for (const TechniqueResult& run : scene.techniques) {
      if (!run.fault_causes || run.fault_causes->skipped) continue;
      std::vector<std::vector<std::string>> rows = cause_table(*run.fault_causes);
      const std::vector<std::string> head = rows.front();
      rows.erase(rows.begin());
      text += fmt::format("{}, {}, removed of each fault:\n{}\n", scene.name, run.label,
                          format_table(head, rows));
    }
  }
  return text;
}

std::string details(const Results& results) {
  std::string text = cause_tables(results);
  for (const SceneResult& scene : results.scenes) {
    if (scene.parity) text += fmt::format("{}: {}\n", scene.name, format_parity(*scene.parity));
    for (const TechniqueResult& run : scene.techniques) {
      for (const auto& [term, meaning] : judgement_lines(run.judgement))
        text += fmt::format("{}, {}: {}: {}\n", scene.name, run.label, term, meaning);
    }
  }
  return text + left_out_list(results);
}

/// What pictures with history are of.
std::string histories(const Results& results) {
  std::string text;
  for (const SceneResult& scene : results.scenes) {
    for (const TechniqueResult& run : scene.techniques) {
      if (run.frames_before > 0)
        text += fmt::format("{}, {}: {}\n", scene.name, run.label, format_history(run));
    }
  }
  return text;
}

std::string skip_list(const Results& results) {
  std::string text;
  for (const Skip& skip : results.skipped) text += fmt::format("skipped {}\n", format_skip(skip));
  return text;
}

}  // namespace

std::string scene_line(const SceneResult& scene) {
  if (scene.failure) return fmt::format("{}: failed", scene.name);
  const std::string parity = scene.parity ? format_share(scene.parity->agreement) : kNotApplicable;
  return fmt::format("{}: done, parity {}", scene.name, parity);
}

std::string work_line(const WorkDone& work) {
  const auto count = [](size_t number, const char* what) {
    return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
  };
  return fmt::format("{} and {} rendered; {} and {} reused", count(work.rendered, "run"),
                     count(work.references_rendered, "truth"), count(work.reused, "run"),
                     count(work.references_reused, "truth"));
}

std::string validation_text(const Results& results, bool with_details) {
  return fmt::format(
      "quality {}, {} x {} px, {} samples per pixel, seed {}\n\n{}\n{}{}{}{}{}{}{}", results.quality,
      results.picture.width_px, results.picture.height_px, results.picture.samples_per_pixel,
      results.picture.seed, table(results), model_gaps(results), histories(results), causes(results),
      with_details ? details(results) : "", findings(results), warning_list(results), skip_list(results));
}

}  // namespace umbrameter
