// SPDX-License-Identifier: Apache-2.0
#include "cli/bench_text.h"

#include "cli/console.h"
#include "results/bench/recommend.h"
#include "results/format.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace umbrameter {
namespace {

using Rows = std::vector<std::vector<std::string>>;

/// "1.234 ms [1.221, 1.249]"; without an interval the median alone.
std::string time_text(const BenchEntry& entry, const std::optional<PassTime>& total) {
  if (!total) return kNotApplicable;
  if (!entry.time_ms) return fmt::format("{:.4g} ms", total->median_ms);
  return fmt::format("{:.4g} ms [{:.4g}, {:.4g}]", entry.time_ms->value, entry.time_ms->low,
                     entry.time_ms->high);
}

std::string front_text(const BenchEntry& entry) {
  if (!entry.has_place) return kNotApplicable;
  return entry.dominated_by ? "no: " + *entry.dominated_by : "yes";
}

std::string label_text(const BenchEntry& entry, const BenchResults& results) {
  const auto& runs = results.plan.runs;
  const bool has_one_seed =
      std::ranges::all_of(runs, [&](const BenchRun& run) { return run.seed == runs.front().seed; });
  return has_one_seed ? entry.label : fmt::format("{} (seed {})", entry.label, entry.seed);
}

std::string run_table(const BenchResults& results) {
  Rows rows;
  for (const BenchScene& scene : results.scenes) {
    for (const BenchEntry& entry : scene.entries) {
      const std::string label = label_text(entry, results);
      if (entry.failure) {
        rows.push_back({scene.name, label, "failed", "", "", "", "", ""});
        continue;
      }
      const auto total = total_time(summarise(entry.times));
      rows.push_back({scene.name, label, time_text(entry, total),
                      total ? fmt::format("{:.2g}", total->mad_ms) : "",
                      total ? std::to_string(total->frames) : "0", format_interval(entry.rmse()),
                      format_bytes(entry.memory_bytes), front_text(entry)});
    }
  }
  return format_table(
      {"scene", "run", "time [95 %]", "MAD", "frames", "RMSE [95 %]", "memory", "on the front"}, rows);
}

std::string pass_table(const BenchResults& results) {
  Rows rows;
  for (const BenchScene& scene : results.scenes) {
    for (const BenchEntry& entry : scene.entries) {
      for (const PassTime& time : summarise(entry.times))
        rows.push_back({scene.name, label_text(entry, results), time.pass, format_time(time)});
    }
  }
  return format_table({"scene", "run", "pass", "time"}, rows);
}

std::string ratio_text(const std::optional<Interval>& ratio) {
  if (!ratio) return kNotApplicable;
  if (ratio->low == ratio->high) return fmt::format("{:.3g}", ratio->value);
  return fmt::format("{:.3g} [{:.3g}, {:.3g}]", ratio->value, ratio->low, ratio->high);
}

std::string claim_table(const BenchResults& results) {
  Rows rows;
  for (const BenchScene& scene : results.scenes) {
    for (const ClaimResult& result : scene.claims) {
      const Claim& claim = results.plan.claims.at(result.claim);
      std::string verdict(verdict_text(result));
      if (!result.reason.empty()) verdict += ": " + result.reason;
      rows.push_back({scene.name, claim.source, claim.text, std::string(to_text(claim.quantity)),
                      format_compares(result), format_paper(result.paper), ratio_text(result.ours), verdict});
    }
  }
  if (rows.empty()) return {};
  return "\n" + format_table({"scene", "source", "claim", "ratio of", "compares per pixel", "paper",
                              "ours [95 %]", "verdict"},
                             rows);
}

std::string answer_line(const std::string& question, const Ranking& ranking, const BenchScene& scene) {
  if (ranking.empty()) return fmt::format("{}, {}: none\n", scene.name, question);
  const BenchEntry& best = scene.entries[ranking.front()];
  std::string line =
      fmt::format("{}, {}: {} ({}, RMSE {})", scene.name, question, best.label,
                  time_text(best, total_time(summarise(best.times))), format_interval(best.rmse()));
  for (size_t i = 1; i < ranking.size(); ++i)
    line += fmt::format("{}{}", i == 1 ? "; not told apart: " : ", ", scene.entries[ranking[i]].label);
  return line + "\n";
}

std::string answers(const BenchResults& results, const BenchQueries& queries) {
  std::string text;
  for (const BenchScene& scene : results.scenes) {
    if (const auto& limit = queries.best_under_ms)
      text +=
          answer_line(fmt::format("best under {:g} ms", *limit), best_under(scene.entries, *limit), scene);
    if (const auto& limit = queries.cheapest_below_rmse)
      text += answer_line(fmt::format("cheapest below RMSE {:g}", *limit),
                          cheapest_below_rmse(scene.entries, *limit), scene);
  }
  return text.empty() ? text : "\n" + text;
}

std::string recommendations(const BenchResults& results) {
  std::string text;
  for (const BenchScene& scene : results.scenes) {
    if (const auto best = recommended(scene.entries)) text += answer_line("recommended", {*best}, scene);
  }
  const auto overall = recommended_overall(results.scenes);
  if (overall && results.scenes.size() > 1)
    text += fmt::format("over {} scenes, recommended: {} (time x RMSE is {:.3g} times each scene's least)\n",
                        overall->scenes, overall->label, overall->cost);
  return text.empty() ? text : "\n" + text;
}

std::string notes(const BenchResults& results) {
  std::string text;
  for (const BenchScene& scene : results.scenes) {
    if (scene.parity && !scene.parity->passes)
      text += fmt::format("{}: {}\n", scene.name, format_parity(*scene.parity));
    for (const std::string& warning : scene.warnings)
      text += fmt::format("{}: warning: {}\n", scene.name, warning);
    for (const BenchEntry& entry : scene.entries) {
      for (const std::string& warning : entry.warnings)
        text += fmt::format("{}, {}: warning: {}\n", scene.name, entry.label, warning);
    }
  }
  for (const Skip& skip : results.skipped) text += fmt::format("skipped {}\n", format_skip(skip));
  return text.empty() ? text : "\n" + text;
}

std::string devices(const BenchResults& results) {
  std::set<std::string> texts;
  for (const BenchScene& scene : results.scenes) {
    for (const BenchEntry& entry : scene.entries) {
      if (!entry.device.empty()) texts.insert(fmt::format("{}; {}", entry.device, entry.timer));
    }
  }
  std::string text;
  for (const std::string& device : texts) text += device + "\n";
  return is_software(results) ? text + kSoftwareNote + "\n" : text;
}

}  // namespace

std::string scene_line(const BenchScene& scene) {
  return fmt::format("{}: {}, {} runs", scene.name, scene.failure ? "no truth" : "done",
                     scene.entries.size());
}

std::string bench_text(const BenchResults& results, const BenchQueries& queries, bool with_passes) {
  const BenchPlan& plan = results.plan;
  const std::string title = plan.doc.empty() ? plan.title : plan.title + "\n" + plan.doc;
  std::string text = fmt::format("{}\n{} x {} px, {} samples per pixel, frames in turn\n{}\n{}", title,
                                 plan.picture.width_px, plan.picture.height_px,
                                 plan.picture.samples_per_pixel, devices(results), run_table(results));
  if (with_passes) text += "\n" + pass_table(results);
  return text + claim_table(results) + answers(results, queries) + recommendations(results) + notes(results);
}

}  // namespace umbrameter
