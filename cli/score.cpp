// SPDX-License-Identifier: Apache-2.0
#include "lab/score.h"

#include "cli/console.h"
#include "cli/positive_number.h"
#include "cli/scene_options.h"
#include "cli/score_inputs.h"
#include "cli/score_results.h"
#include "cli/verbs.h"
#include "lab/pictures/picture_json.h"
#include "results/catalogue.h"
#include "results/diagnosis_format.h"
#include "results/format.h"
#include "results/judgement_format.h"
#include "results/measured.h"
#include "results/similarity_format.h"

#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

struct ScoreOptions {
  ScoreInputOptions inputs;
  std::string quantity;
  std::string report;
  std::string metrics;
  std::optional<double> limit_rmse;
  double min_scored = kMinScored;
  bool maps = false;
};

std::string region_line(const char* name, const RegionError& region) {
  return fmt::format("{:<17}{} of scored pixels, RMSE {}, mean error {}\n", name, format_share(region.share),
                     format_error(region_rmse(region)),
                     format_signed_error(region_rmse(region) ? std::optional(region.bias) : std::nullopt));
}

std::string term_lines(const TermLines& lines) {
  std::string text;
  for (const auto& [term, meaning] : lines) text += fmt::format("{:<16} {}\n", term, meaning);
  return text;
}

std::string quantity_line(const PictureScore& picture) {
  const char* name = picture.quantity == ShadowQuantity::visibility ? "visibility" : "irradiance ratio";
  if (picture.is_quantity_given || !picture.other_rmse) return fmt::format("quantity         {}\n", name);
  const char* other = picture.quantity == ShadowQuantity::visibility ? "the irradiance ratio" : "visibility";
  return fmt::format("quantity         {} (as {} the RMSE is {}); --quantity names it\n", name, other,
                     format_interval(picture.other_rmse));
}

std::string score_text(const PictureScore& picture) {
  const Score& score = picture.score;
  std::string text = quantity_line(picture);
  text += score.has_surfaces ? "parity           " + format_parity(parity_numbers(score.parity)) + "\n"
                             : "parity           not checked: the picture has no surface channels\n";
  if (!score.error) return text;
  const VisibilityError& error = *score.error;
  text += fmt::format("scored pixels    {} of {}\n", error.scored_pixels, score.scorable_pixels);
  text += term_lines(metric_lines(result_of(score), "error"));
  text += region_line("lit", error.lit) + region_line("penumbra", error.penumbra) +
          region_line("umbra", error.umbra);
  text += term_lines(judgement_lines(score.judgement));
  if (score.similarity) text += term_lines(similarity_lines(*score.similarity));
  if (!score.diagnosis) return text;
  return text + term_lines(penumbra_lines(*score.diagnosis)) + term_lines(fault_lines(*score.diagnosis)) +
         term_lines(cause_lines(*score.diagnosis));
}

void add_verdict(const EnginePicture& picture, const EnginePicture& baseline,
                 const PictureScore& baseline_score, PictureScore& score) {
  if (!score.score.error || !baseline_score.score.error) return;
  score.score.judgement.verdict =
      judge_against({picture.test, score.score.mask}, {baseline.test, baseline_score.score.mask},
                    baseline.name, baseline_score.reference);
}

/// The sentence that makes the exit code 1; absent when the score is fine.
std::optional<std::string> objection(const PictureScore& picture, double min_scored) {
  const Score& score = picture.score;
  if (!score.parity.passes) return "the picture and the reference show other surfaces; no score";
  if (auto reason = unmeasured(score.error->scored_pixels, score.scorable_pixels, min_scored)) return reason;
  const auto& [significance, verdict, limit] = score.judgement;
  std::vector<std::string> reasons;
  if (limit && limit->outcome == LimitOutcome::fail) reasons.push_back("the RMSE is above --limit");
  if (verdict && verdict->outcome == Comparison::worse)
    reasons.push_back(fmt::format("worse than the baseline '{}'", verdict->baseline));
  if (reasons.empty()) return std::nullopt;
  return fmt::format("{}", fmt::join(reasons, ", and "));
}

/// What a pair shows is known only to who made it; a gate must not guess.
void require_quantity(const ScoreOptions& options, const ScoreInputs& inputs) {
  const bool is_gate = options.limit_rmse || inputs.baseline;
  if (!is_gate || !options.quantity.empty() || !inputs.pictures.front().is_pair) return;
  fail_input(
      fmt::format("{} needs to know what the pair's ratio is", options.limit_rmse ? "--limit" : "--baseline"),
      {},
      "--quantity irradiance for renderers that integrate the light, visibility for shadow maps that are "
      "multiplied into the light");
}

void print_scores(const ScoreInputs& inputs, const std::vector<PictureScore>& scores, bool as_json) {
  auto all = nlohmann::ordered_json::array();
  std::string text;
  for (size_t i = 0; i < scores.size(); ++i) {
    const std::string& name = inputs.pictures[i].name;
    if (as_json) all.push_back(picture_json(scores[i], name, inputs.reference_name));
    if (!as_json && scores.size() > 1) text += fmt::format("{}{}\n", i == 0 ? "" : "\n", name);
    if (!as_json) text += score_text(scores[i]);
  }
  if (!as_json) return print_answer(text);
  if (scores.size() == 1) return print_json(all.front());
  print_json({{"pictures", std::move(all)}});
}

ScoreSettings settings_of(const ScoreOptions& options, const GlobalOptions& global) {
  ScoreSettings settings;
  settings.metrics = choose_metrics(options.metrics);
  settings.limit_rmse = options.limit_rmse;
  settings.maps = options.maps && !global.out.empty();
  return settings;
}

void write_results(const ScoreOptions& options, const GlobalOptions& global, const ScoreInputs& inputs,
                   const std::vector<PictureScore>& scores, const std::optional<PictureScore>& baseline) {
  if (options.report.empty() && global.out.empty()) return;
  ValidationPlan plan;
  plan.metrics = choose_metrics(options.metrics);
  plan.limit_rmse = options.limit_rmse;
  std::vector<ScoredPicture> all;
  for (size_t i = 0; i < scores.size(); ++i) all.push_back({inputs.pictures[i], scores[i]});
  if (baseline) all.push_back({*inputs.baseline, *baseline});
  write_score_results(inputs, all, plan, options.report, global.out);
}

int score(const ScoreOptions& options, const GlobalOptions& global) {
  if (options.maps && global.out.empty()) fail_input("--maps needs a folder", {}, "give --out DIR");
  std::optional<ShadowQuantity> quantity;
  if (!options.quantity.empty()) quantity = parse_shadow_quantity(options.quantity);
  const ScoreSettings settings = settings_of(options, global);
  const ScoreInputs inputs = load_score_inputs(options.inputs, global);
  require_quantity(options, inputs);
  std::vector<PictureScore> scores;
  for (const EnginePicture& picture : inputs.pictures)
    scores.push_back(score_picture(picture, inputs.reference, inputs.eye_world, settings, quantity));
  std::optional<PictureScore> baseline;
  if (inputs.baseline) {
    baseline = score_picture(*inputs.baseline, inputs.reference, inputs.eye_world, settings,
                             scores.front().quantity);
    for (size_t i = 0; i < scores.size(); ++i)
      add_verdict(inputs.pictures[i], *inputs.baseline, *baseline, scores[i]);
  }
  int code = kExitFine;
  for (size_t i = 0; i < scores.size(); ++i) {
    const std::string prefix = scores.size() > 1 ? inputs.pictures[i].name + ": " : "";
    for (const std::string& note : scores[i].notes) print_note(prefix + note);
  }
  print_scores(inputs, scores, global.json);
  for (size_t i = 0; i < scores.size(); ++i) {
    const std::string prefix = scores.size() > 1 ? inputs.pictures[i].name + ": " : "";
    if (const auto& failure = scores[i].score.no_diagnosis)
      print_error(prefix + "the faults could not be told apart: " + failure->message);
    const auto reason = objection(scores[i], options.min_scored);
    if (!reason) continue;
    print_error(prefix + *reason);
    code = kExitGateFailed;
  }
  write_results(options, global, inputs, scores, baseline);
  return code;
}

}  // namespace

void add_score(CLI::App& app, CommandLine& line) {
  auto options = std::make_shared<ScoreOptions>();
  CLI::App* verb = app.add_subcommand("score",
                                      "score pictures of any engine against the truth "
                                      "(docs/your-engine.md); --out writes what validate does");
  verb->fallthrough();
  add_score_input_options(*verb, options->inputs);
  verb->add_option("--report", options->report, "also write the page of 'report' to this file (.html)");
  verb->add_option(
      "--baseline", options->inputs.baseline,
      "another picture to compare with, pixel by pixel; exit code 1 when a picture is worse for certain");
  verb->add_option("--quantity", options->quantity,
                   "what the picture or the pair's ratio is: visibility or irradiance (docs/your-engine.md)");
  verb->add_option("--min-scored", options->min_scored,
                   "share of the pixels that the truth can score that must be scored, else exit code 1")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  add_one_view_options(*verb, line.global);
  verb->add_option("--limit", options->limit_rmse, "RMSE to keep; exit code 1 when it is above for certain")
      ->check(positive_number());
  verb->add_option("--metrics", options->metrics, kMetricsHelp);
  verb->add_flag("--maps", options->maps, kMapsHelp);
  verb->callback([options, &line] { line.verb = [options, &line] { return score(*options, line.global); }; });
}

}  // namespace umbrameter
