// SPDX-License-Identifier: Apache-2.0
#include "study/score.h"

#include "cli/console.h"
#include "cli/light_option.h"
#include "cli/score_inputs.h"
#include "cli/score_results.h"
#include "cli/verbs.h"
#include "core/image_io.h"
#include "study/diagnosis_format.h"
#include "study/format.h"
#include "study/judgement_format.h"
#include "study/results_json.h"
#include "study/similarity_format.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

struct ScoreOptions {
  ScoreInputOptions inputs;
  std::string report;
  std::string baseline;
  std::string metrics;
  std::optional<double> limit_rmse;
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

std::string score_text(const Score& score) {
  std::string text =
      score.has_surfaces
          ? "parity           " +
                format_parity(parity_numbers(score.parity, ParityTolerance{}.required_agreement)) + "\n"
          : "parity           not checked: the image has no surface channels\n";
  if (!score.error) return text;
  const VisibilityError& error = *score.error;
  text += fmt::format("scored pixels    {}\n", error.scored_pixels);
  text += "RMSE [95 %]      " + format_interval(error.rmse) + "\n";
  text += "mean error       " + format_signed_error(error.bias) + "\n";
  text += "mean |error|     " + format_error(error.mae) + "\n";
  text += "over-shadowing   " + format_error(error.over_shadowing) + "\n";
  text += "under-shadowing  " + format_error(error.under_shadowing) + "\n";
  text += "largest |error|  " + format_error(error.max_error) + "\n";
  text += region_line("lit", error.lit) + region_line("penumbra", error.penumbra) +
          region_line("umbra", error.umbra);
  text += term_lines(judgement_lines(score.judgement));
  if (score.similarity) text += term_lines(similarity_lines(*score.similarity));
  if (!score.diagnosis) return text;
  return text + term_lines(penumbra_lines(*score.diagnosis)) + term_lines(fault_lines(*score.diagnosis)) +
         term_lines(cause_lines(*score.diagnosis));
}

void add_verdict(const std::string& baseline_file, const Image& test, const Image& reference,
                 const glm::dvec3& eye_world, Score& score) {
  const Image baseline = with_visibility(read_image(baseline_file), baseline_file);
  const ScoreSettings error_only = {choose_metrics("error"), {}};
  const Score baseline_score = score_image(baseline, reference, eye_world, error_only);
  if (!score.error || !baseline_score.error) return;
  score.judgement.verdict =
      judge_against({test, score.mask}, {baseline, baseline_score.mask}, baseline_file, reference);
}

std::string json_text(const Score& score, const ScoreInputs& inputs) {
  auto json = nlohmann::ordered_json::parse(to_json_text(score, inputs.test_name, inputs.reference_name));
  json["notes"] = inputs.notes;
  json["mean_square_rounding"] = inputs.mean_square_rounding;
  return json.dump(2) + "\n";
}

bool is_above_limit(const Score& score) {
  return score.judgement.limit && score.judgement.limit->outcome == LimitOutcome::fail;
}

int score(const ScoreOptions& options, const GlobalOptions& global) {
  if (options.maps && global.out.empty()) fail_input("--maps needs a folder", {}, "give --out DIR");
  const ScoreInputs inputs = load_score_inputs(options.inputs, global);
  const Image &test = inputs.test, &reference = inputs.reference;
  const ScoreSettings settings = {choose_metrics(options.metrics), options.limit_rmse,
                                  options.maps && !global.out.empty()};
  Score result = score_image(test, reference, inputs.eye_world, settings);
  if (result.error) widen_by_rounding(inputs.mean_square_rounding, *result.error);
  if (settings.limit_rmse && result.error)
    result.judgement.limit = judge_against(*settings.limit_rmse, *result.error, reference, result.mask);
  if (!options.baseline.empty()) add_verdict(options.baseline, test, reference, inputs.eye_world, result);
  for (const std::string& note : inputs.notes) print_note(note);
  if (!options.report.empty() || !global.out.empty())
    write_score_results(inputs, settings, options.report, global.out);
  print_answer(global.json ? json_text(result, inputs) : score_text(result));
  if (result.no_diagnosis) print_error("the faults could not be told apart: " + result.no_diagnosis->message);
  if (is_above_limit(result)) print_error("the RMSE is above --limit");
  if (result.parity.passes) return is_above_limit(result) ? kExitGateFailed : kExitFine;
  print_error("the image and the reference show other surfaces; no score");
  return kExitGateFailed;
}

}  // namespace

void add_score(CLI::App& app, CommandLine& line) {
  auto options = std::make_shared<ScoreOptions>();
  CLI::App* verb = app.add_subcommand("score",
                                      "score a picture of any engine against the truth "
                                      "(docs/your-engine.md); --out writes what validate does");
  verb->fallthrough();
  add_score_input_options(*verb, options->inputs);
  verb->add_option("--report", options->report, "also write the page of 'report' to this file (.html)");
  verb->add_option("--baseline", options->baseline, "another image to compare with, pixel by pixel");
  add_one_light_option(*verb, line.global);
  verb->add_option("--limit", options->limit_rmse, "RMSE to keep; exit code 1 when it is above for certain")
      ->check(CLI::PositiveNumber);
  verb->add_option("--metrics", options->metrics, kMetricsHelp);
  verb->add_flag("--maps", options->maps, kMapsHelp);
  verb->callback([options, &line] { line.verb = [options, &line] { return score(*options, line.global); }; });
}

}  // namespace umbrameter
