// SPDX-License-Identifier: Apache-2.0
#include "study/stress/stress_scene.h"

#include "core/files.h"
#include "core/guard.h"
#include "metrics/error/truth_check.h"
#include "scenes/load_scene.h"

#include <fmt/format.h>

#include <algorithm>

namespace umbrameter {
namespace {

using enum StressOutcome;

/// The files as a user would write them, read back.
std::optional<StressCell> load(const StressPoint& point, const std::filesystem::path& place, Scene& scene) {
  create_folder(place);
  for (const auto& [name, bytes] : point.files) write_file_atomically(place / name, bytes);
  write_file_atomically(place / "scene.toml", point.scene);
  const auto failure = guarded([&] { scene = load_scene(place / "scene.toml", {}); });
  if (!failure && point.must_be_refused) return stress_failure(accepted, "this must be refused");
  if (!failure) {
    scene.active_light = point.active_light;
    return std::nullopt;
  }
  const bool is_right = point.must_be_refused && failure->kind == ErrorKind::input;
  return stress_failure(is_right ? rightly_refused : outcome_of(*failure), failure->message);
}

void judge_truth(const Image& surfaces, const TruthOracle& oracle, StressScene& out) {
  const glm::dvec3& eye_world = out.scene.camera.eye_world;
  const Parity alone = compare_surfaces(out.reference, out.reference, eye_world);
  const std::vector<uint8_t> mask = scored_mask(alone, out.reference);
  out.truth.scored_pixels = static_cast<size_t>(std::ranges::count(mask, 1));
  if (out.truth.scored_pixels == 0) out.truth.outcome = nothing;
  const TruthCheck check = check_truth(out.scene, out.reference, mask, oracle);
  out.truth.exact_points = check.points;
  // Lights may be too small for a penumbra here, and edge-on ones are cut into exact halves.
  const TruthSettings settings = {.least_spread_ratio = 0.0, .partial_per_edge = 0.0};
  const std::vector<std::string> problems = truth_problems(out.reference, mask, settings);
  const std::optional<std::string> problem =
      check.objection || problems.empty() ? check.objection : std::optional(problems.front());
  if (problem) {
    out.truth.outcome = wrong_truth;
    out.truth.how = *problem;
  }
  const Parity parity = compare_surfaces(surfaces, out.reference, eye_world);
  out.is_usable = parity.passes;
  if (parity.passes || problem) return;
  out.truth.outcome = other_surfaces;
  out.truth.how =
      fmt::format("the renderers agree in {:.2f} % of {} covered pixels, {:.1f} % are required",
                  100.0 * parity.agreement, parity.covered, 100.0 * ParityTolerance{}.required_agreement);
}

}  // namespace

StressCell stress_failure(StressOutcome outcome, const std::string& how) {
  StressCell cell;
  cell.outcome = outcome;
  cell.how = how;
  return cell;
}

StressScene make_stress_scene(const StressPoint& point, const std::filesystem::path& place,
                              const RenderRequest& request, const StressTools& tools, Progress& progress) {
  StressScene out;
  if (const auto ended = load(point, place, out.scene)) {
    out.truth = *ended;
    return out;
  }
  Image surfaces;
  const auto failure = guarded([&] {
    surfaces = tools.realtime(point.edits).render(out.scene, request, progress).image;
    out.reference = tools.reference.render(out.scene, request, progress).image;
  });
  if (failure) {
    out.truth = stress_failure(outcome_of(*failure), failure->message);
    return out;
  }
  const auto unmeasured = guarded([&] { judge_truth(surfaces, tools.oracle, out); });
  if (unmeasured) {
    const bool is_input = unmeasured->kind == ErrorKind::input;  // the metrics' word for NaN
    out.truth = stress_failure(is_input ? bad_value : outcome_of(*unmeasured), unmeasured->message);
  }
  out.truth.warnings = out.scene.warnings;
  return out;
}

}  // namespace umbrameter
