// SPDX-License-Identifier: Apache-2.0
#include "cli/tune_text.h"

#include "cli/console.h"
#include "results/format.h"
#include "results/tune/tune_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

std::string ratio_text(const std::optional<double>& ratio) {
  return ratio && std::isfinite(*ratio) ? fmt::format("{:.3f}", *ratio) : kNotApplicable;
}

std::string objective_text(const std::optional<ObjectiveValue>& objective) {
  if (!objective) return "failed";
  return objective->interval ? format_interval(objective->interval) : format_error(objective->value);
}

std::string gain_text(const std::optional<Interval>& gain) {
  if (!gain) return kNotApplicable;
  const char* verdict = gain->low > 0.0 ? "won" : gain->high < 0.0 ? "lost" : "tied";
  return fmt::format("{:+.3f} [{:+.3f}, {:+.3f}] {}", gain->value, gain->low, gain->high, verdict);
}

std::vector<std::string> row(const TuneResult& result, const Candidate& candidate) {
  std::vector<std::string> cells{candidate.name};
  if (result.scenes.size() == 1) cells.push_back(objective_text(candidate.scores.front().objective));
  cells.push_back(ratio_text(candidate.ratio));
  cells.push_back(ratio_text(candidate.held_out_ratio));
  cells.push_back(gain_text(candidate.held_out_gain));
  return cells;
}

std::string ranking(const TunePlan& plan, const TuneResult& result) {
  std::vector<const Candidate*> order{&result.best};
  for (const Candidate& candidate : result.others) order.push_back(&candidate);
  std::ranges::stable_sort(order, {}, [](const Candidate* candidate) { return candidate->ratio; });
  std::vector<std::vector<std::string>> rows;
  for (const Candidate* candidate : order) rows.push_back(row(result, *candidate));
  std::vector<std::string> headings{"settings"};
  if (result.scenes.size() == 1)
    headings.push_back(fmt::format("{} [95 %], its camera", name_of(plan.objective)));
  headings.insert(headings.end(), {"of default", "held out", "tuned is better by"});
  return format_table(headings, rows);
}

std::string end_text(const SafeWindow& window, double end, double texel_world) {
  const auto texels = in_texels(window.unit, end, texel_world);
  const auto world = in_world_units(window.unit, end, texel_world);
  if (texels && world) return fmt::format("{:.3g} texels ({:.3g} world)", *texels, *world);
  return window.unit == "none" ? fmt::format("{:.3g}", end) : fmt::format("{:.3g} {}", end, window.unit);
}

/// What is wrong below and above a window.
struct EndWords {
  const char *always_too_low, *always_too_high, *too_low, *too_high;
};
constexpr EndWords kBiasWords{"there is acne at any bias", "shadows are detached at any bias", "acne",
                              "detached shadows"};
constexpr EndWords kFallingBiasWords{"shadows are detached at any bias", "there is acne at any bias",
                                     "detached shadows", "acne"};
constexpr EndWords kSizeWords{"penumbrae are too hard at any size", "penumbrae are too soft at any size",
                              "too hard", "too soft"};

std::string window_text(const SafeWindow& window, double texel_world) {
  const EndWords& words = window.kind != WindowKind::bias ? kSizeWords
                          : window.falls                  ? kFallingBiasWords
                                                          : kBiasWords;
  if (!window.is_complete) return "not measured, the time was up";
  if (window.points.empty()) return "not measured, no picture has what it is measured by";
  if (!window.from) return fmt::format("empty, {}", words.always_too_low);
  if (!window.to) return fmt::format("empty, {}", words.always_too_high);
  const std::string from = end_text(window, *window.from, texel_world);
  const std::string to = end_text(window, *window.to, texel_world);
  if (window.has_window()) return fmt::format("{} to {}", from, to);
  return fmt::format("empty, {} up to {}, {} from {}", words.too_low, from, words.too_high, to);
}

std::string window_lines(const TuneResult& result) {
  std::string text;
  for (const SafeWindow& window : result.windows) {
    text += fmt::format("safe window of {}, the rest as {}: {}\n", window.parameter,
                        window.is_at_tuned ? "tuned" : "given", window_text(window, result.texel_world));
  }
  return text;
}

std::string percent(const std::optional<double>& share) {
  return share ? fmt::format("{:+.2f} %", 100.0 * *share) : kNotApplicable;
}

std::string sensitivities(const TuneResult& result) {
  std::vector<std::vector<std::string>> rows;
  for (const Sensitivity& one : result.sensitivities) {
    rows.push_back({one.parameter, to_text(result.best.values.at(one.parameter)), percent(one.rise_below),
                    percent(one.rise_above), fmt::format("{:.3g}", one.relative_spread)});
  }
  return format_table({"parameter", "tuned", "a step below", "a step above", "spread"}, rows);
}

}  // namespace

std::string tune_text(const TunePlan& plan, const TuneResult& result) {
  std::string text =
      fmt::format("{} on {}, {} x {} px, seed {}: {} evaluations, {} of them coarse, in {:.1f} s{}\n\n{}\n",
                  plan.technique.id, fmt::join(result.scenes, ", "), plan.full.width_px, plan.full.height_px,
                  plan.seed, result.evaluations, result.coarse_evaluations, result.wall_time_s,
                  result.is_converged ? "" : " (the budget ended the search)", ranking(plan, result));
  text += sensitivities(result) + "\n";
  text += window_lines(result);
  if (result.grid) {
    text += fmt::format("dense grid of {} evaluations: best {:.4f} of default, tuned {:.4f}\n",
                        result.grid->evaluations, result.grid->best_ratio, result.best.ratio);
  }
  for (const std::string& note : result.notes) text += "note: " + note + "\n";
  return text + "\n" + engine_block(result);
}

std::string lit_sum_text(const std::vector<LitSum>& sums) {
  std::string text;
  for (const LitSum& sum : sums) {
    text +=
        fmt::format("all lights of {} together: lit RMSE [95 %] {} as given, {} tuned by light: {}\n",
                    sum.scene, format_interval(sum.before), format_interval(sum.after), name_of(sum.outcome));
  }
  return text;
}

}  // namespace umbrameter
