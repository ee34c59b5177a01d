// SPDX-License-Identifier: Apache-2.0
#include "results/format.h"

#include "results/catalogue.h"

#include <fmt/format.h>

#include <cmath>

namespace umbrameter {
namespace {

/// Four significant digits, but no powers of ten.
std::string milliseconds_text(double ms) {
  return ms < 1000.0 ? fmt::format("{:.4g}", ms) : fmt::format("{:.0f}", ms);
}

/// What the light alone disagrees on shows the same surfaces.
bool is_other_light(const ParityNumbers& parity) {
  const size_t other = parity.coverage_mismatch + parity.surface_mismatch;
  return static_cast<double>(parity.covered - other) >=
         parity.required_agreement * static_cast<double>(parity.covered);
}

}  // namespace

std::string format_error(const std::optional<double>& value) {
  return value ? fmt::format("{:.5f}", *value) : kNotApplicable;
}

std::string format_signed_error(const std::optional<double>& value) {
  return value ? fmt::format("{:+.5f}", *value) : kNotApplicable;
}

std::string format_interval(const std::optional<Interval>& interval) {
  if (!interval) return kNotApplicable;
  return fmt::format("{:.5f} [{:.5f}, {:.5f}]", interval->value, interval->low, interval->high);
}

std::string format_time(const std::optional<PassTime>& time) {
  if (!time) return kNotApplicable;
  if (time->frames == 1) return fmt::format("{} ms (1 frame)", milliseconds_text(time->median_ms));
  return fmt::format("{} ± {} ms ({} frames)", milliseconds_text(time->median_ms),
                     milliseconds_text(time->mad_ms), time->frames);
}

std::string format_bytes(uint64_t bytes) {
  return fmt::format("{:.1f} MiB", static_cast<double>(bytes) / (1024.0 * 1024.0));
}

std::string format_share(double share) {
  return fmt::format("{:.3f} %", std::floor(share * 1e5) / 1e3);
}

std::string format_parity(const ParityNumbers& parity) {
  if (parity.covered == 0) return "no pixel is covered, so there is nothing to compare";
  return fmt::format(
      "agreement {} of {} covered pixels (needs {}): {}; disagreeing: {} coverage, {} surface, {} "
      "irradiance; "
      "median relative depth error {:.2g}",
      format_share(parity.agreement), parity.covered, format_share(parity.required_agreement),
      parity.passes ? "passes"
      : is_other_light(parity)
          ? "FAILS, the same surfaces under another light, so no number of this scene counts"
          : "FAILS, other surfaces, so no number of this scene counts",
      parity.coverage_mismatch, parity.surface_mismatch, parity.irradiance_mismatch,
      parity.median_relative_depth_error);
}

std::string format_skip(const Skip& skip) {
  const std::string saved = skip.saved_s ? fmt::format(" (saves about {:.2g} s)", *skip.saved_s) : "";
  return fmt::format("{}{}{}: {}{}", skip.scene, skip.technique.empty() ? "" : ", ", skip.technique,
                     skip.reason, saved);
}

std::string format_temporal(const TemporalNumbers& temporal) {
  const auto text = [](const std::optional<double>& value) {
    return value ? fmt::format("{:.2g}", *value) : std::string(kNotApplicable);
  };
  return fmt::format("flicker {} (truth {}) under a moving camera, {} under a moving light, {} over seeds",
                     text(temporal.camera.test), text(temporal.camera.reference), text(temporal.light.rms),
                     text(temporal.seed_noise));
}

std::string format_history(const TechniqueResult& run) {
  std::string text = fmt::format("after {} frames ({})", run.frames_before, run.motion);
  const char* separator = ": ";
  for (const char* key : {"ghosting", "convergence_frames"}) {
    const Metric& metric = *find_metric(key);
    if (!metric.of(run)) continue;
    text += fmt::format("{}{} {}", separator, metric.label, format_metric(metric, run));
    separator = ", ";
  }
  return text;
}

}  // namespace umbrameter
