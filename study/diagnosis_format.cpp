#include "study/diagnosis_format.h"

#include "study/format.h"

#include <fmt/format.h>

#include <algorithm>

namespace umbrameter {
namespace {

std::string words(std::string_view name) {
  std::string text(name);
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

std::string spread_text(const std::optional<Spread>& spread, std::string_view unit) {
  if (!spread) return kNotApplicable;
  return fmt::format("{:+.3g} {}, 5 % to 95 %: [{:+.3g}, {:+.3g}]", spread->median, unit, spread->p5,
                     spread->p95);
}

std::string profiles_text(const PenumbraNumbers& penumbra) {
  std::string text = fmt::format("{} accepted, {} rejected", penumbra.accepted(), penumbra.rejected());
  std::string separator = " (";
  for (size_t k = 1; k < kProfileOutcomes; ++k) {
    if (penumbra.outcomes[k] == 0) continue;
    text += fmt::format("{}{} {}", separator, penumbra.outcomes[k],
                        words(name_of(static_cast<ProfileOutcome>(k))));
    separator = ", ";
  }
  return penumbra.rejected() > 0 ? text + ")" : text;
}

std::string hardening_text(const ContactHardening& hardening) {
  const std::string basis =
      fmt::format("{} profiles over {:.2g} octaves", hardening.profiles, hardening.octaves);
  if (!hardening.slope || !hardening.intercept_octaves) return "not identifiable: " + basis;
  return fmt::format("slope {:.3g}, {:+.3g} octaves at the median width ({})", *hardening.slope,
                     *hardening.intercept_octaves, basis);
}

/// A part of the mean absolute error that is there never reads as 0.
std::string part_text(double mean_abs_error) {
  if (mean_abs_error == 0.0) return "0";
  return mean_abs_error < 1e-5 ? "< 0.00001" : format_error(mean_abs_error);
}

}  // namespace

std::string format_fault(FaultClass fault) {
  return words(name_of(fault));
}

std::string format_worst_fault(const std::optional<Diagnosis>& diagnosis) {
  if (!diagnosis) return kNotApplicable;
  const auto worst = worst_fault(diagnosis->faults);
  if (!worst) return "none";
  return format_fault(*worst) + " " + part_text(diagnosis->faults.of(*worst).mean_abs_error);
}

TermLines penumbra_lines(const Diagnosis& diagnosis) {
  return {{"penumbra width", spread_text(diagnosis.penumbra.width_octaves, "octaves")},
          {"edge offset", spread_text(diagnosis.penumbra.offset_world, "world units")},
          {"profiles", profiles_text(diagnosis.penumbra)},
          {"contact hardening", hardening_text(diagnosis.contact_hardening)}};
}

TermLines fault_lines(const Diagnosis& diagnosis) {
  TermLines lines{{"worst fault", format_worst_fault(diagnosis)}};
  for (size_t k = static_cast<size_t>(FaultClass::explained); k < kFaultClasses; ++k) {
    const FaultShare& share = diagnosis.faults.by_class[k];
    if (share.pixels == 0) continue;
    const auto fault = static_cast<FaultClass>(k);
    const std::string places =
        fault == FaultClass::explained ? "" : fmt::format(" in {} places", share.components);
    lines.emplace_back(format_fault(fault),
                       fmt::format("{} of mean |error|, {} pixels{}", part_text(share.mean_abs_error),
                                   share.pixels, places));
  }
  if (!diagnosis.faults.peter_panning_gap_world) return lines;
  lines.emplace_back("contact gap",
                     fmt::format("{:.3g} world units", *diagnosis.faults.peter_panning_gap_world));
  return lines;
}

}  // namespace umbrameter
