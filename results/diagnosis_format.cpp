// SPDX-License-Identifier: Apache-2.0
#include "results/diagnosis_format.h"

#include "results/format.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

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
  if (penumbra.rejected() > 0) text += ")";
  return penumbra.partial > 0 ? fmt::format("{}, {} by a stretch", text, penumbra.partial) : text;
}

std::string hardening_text(const ContactHardening& hardening) {
  const std::string basis =
      fmt::format("{} profiles over {:.2g} octaves", hardening.profiles, hardening.octaves);
  if (!hardening.slope || !hardening.intercept_octaves) return "not identifiable: " + basis;
  const std::string margin = hardening.slope_margin ? fmt::format(" +- {:.2g}", *hardening.slope_margin) : "";
  return fmt::format("slope {:.3g}{}, {:+.3g} octaves at the median width ({})", *hardening.slope, margin,
                     *hardening.intercept_octaves, basis);
}

/// A part of the mean absolute error that is there never reads as 0.
std::string part_text(double mean_abs_error) {
  if (mean_abs_error == 0.0) return "0";
  return mean_abs_error < 1e-5 ? "< 0.00001" : format_error(mean_abs_error);
}

std::string moire_text(const Moire& moire) {
  if (!moire.cycles_per_px) return "not identifiable";
  const std::string texels = moire.cycles_per_texel
                                 ? fmt::format("{:.2f} cycles per texel", *moire.cycles_per_texel)
                                 : std::string("cycles per texel not identifiable");
  return fmt::format("{:.3f} cycles per pixel, {} ({} tiles)", *moire.cycles_per_px, texels, moire.tiles);
}

/// Of the error where a texel is larger than a pixel.
double coarse_part(const ErrorCauses& causes) {
  double part = 0.0;
  for (size_t k = 0; k < kFootprintBinsPx.size(); ++k) {
    if (kFootprintBinsPx[k] >= 1.0) part += causes.by_footprint[k].mean_abs_error;
  }
  return part;
}

struct FaultPart {
  FaultClass fault;
  double part = 0.0;  // of the mean absolute error
};

/// `part_of` every class that is a fault, the largest first; those below the share of `mean_abs_error` are left out.
template <class PartOf>
std::vector<FaultPart> named_parts(double mean_abs_error, const PartOf& part_of) {
  std::vector<FaultPart> parts;
  for (size_t k = static_cast<size_t>(FaultClass::explained) + 1; k < kFaultClasses; ++k) {
    const auto fault = static_cast<FaultClass>(k);
    const double part = part_of(fault);
    if (part > 0.0 && part >= kNamedShare * mean_abs_error) parts.push_back({fault, part});
  }
  std::ranges::stable_sort(parts, std::ranges::greater{}, &FaultPart::part);
  return parts;
}

std::string list_of(const std::vector<FaultPart>& parts, std::string_view sign) {
  std::string text;
  for (const FaultPart& part : parts) {
    text += fmt::format("{}{}{} {}", text.empty() ? "" : ", ", sign, words(name_of(part.fault)),
                        part_text(part.part));
  }
  return text;
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

std::string format_faults(const std::optional<Diagnosis>& diagnosis) {
  if (!diagnosis) return kNotApplicable;
  const auto parts = named_parts(diagnosis->faults.mean_abs_error.value_or(0.0), [&](FaultClass fault) {
    return diagnosis->faults.of(fault).mean_abs_error;
  });
  return parts.empty() ? format_worst_fault(diagnosis) : list_of(parts, "");
}

std::string format_growth(const std::optional<Diagnosis>& diagnosis,
                          const std::optional<Diagnosis>& baseline) {
  if (!diagnosis || !baseline) return kNotApplicable;
  const auto parts = named_parts(diagnosis->faults.mean_abs_error.value_or(0.0), [&](FaultClass fault) {
    return diagnosis->faults.of(fault).mean_abs_error - baseline->faults.of(fault).mean_abs_error;
  });
  return parts.empty() ? "nothing" : list_of(parts, "+");
}

TermLines penumbra_lines(const Diagnosis& diagnosis) {
  TermLines lines{{"penumbra width", spread_text(diagnosis.penumbra.width_octaves, "octaves")},
                  {"edge offset", spread_text(diagnosis.penumbra.offset_world, "world units")}};
  if (diagnosis.penumbra.offset_texels)
    lines.emplace_back("offset in texels", spread_text(diagnosis.penumbra.offset_texels, "texels"));
  lines.emplace_back("profiles", profiles_text(diagnosis.penumbra));
  lines.emplace_back("contact hardening", hardening_text(diagnosis.contact_hardening));
  return lines;
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
  if (diagnosis.faults.peter_panning_gap_world) {
    lines.emplace_back("contact gap",
                       fmt::format("{:.3g} world units", *diagnosis.faults.peter_panning_gap_world));
  }
  if (diagnosis.faults.of(FaultClass::acne).pixels > 0) {
    lines.emplace_back("acne frequency", moire_text(diagnosis.moire));
  }
  return lines;
}

TermLines cause_lines(const Diagnosis& diagnosis) {
  const ErrorCauses& causes = diagnosis.causes;
  TermLines lines;
  if (causes.median_footprint_px) {
    lines.emplace_back("texel footprint",
                       fmt::format("{:.2g} px at the median, {} of mean |error| above 1 px",
                                   *causes.median_footprint_px, part_text(coarse_part(causes))));
  }
  if (causes.stair_texels) {
    lines.emplace_back(
        "stairs", fmt::format("{:.2g} texels over {} profiles", *causes.stair_texels, causes.stair_profiles));
  }
  if (causes.banding) {
    lines.emplace_back("banding", fmt::format("{:.2f}, {:.3g} levels at the median of {} penumbrae",
                                              *causes.banding, *causes.levels, causes.banding_profiles));
  }
  if (causes.noise && causes.reference_noise) {
    lines.emplace_back(
        "noise", fmt::format("{:.2g} in penumbrae, truth {:.2g}", *causes.noise, *causes.reference_noise));
  }
  return lines;
}

}  // namespace umbrameter
