// SPDX-License-Identifier: Apache-2.0
#include "metrics/diagnosis.h"

#include "metrics/image/texel_footprint.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace umbrameter {
namespace {

bool is_fault(FaultClass fault) {
  return fault != FaultClass::unscored && fault != FaultClass::explained;
}

/// Whether a profile speaks in a spread: as in PenumbraError.
bool speaks(const PenumbraError& penumbra, const PenumbraProfile& profile) {
  const bool any_whole = penumbra.outcomes[0] > penumbra.partial;
  return profile.outcome == ProfileOutcome::accepted && !(any_whole && profile.is_partial);
}

std::optional<Spread> offset_widths(const PenumbraError& penumbra) {
  std::vector<double> offsets;
  for (const PenumbraProfile& profile : penumbra.profiles) {
    if (speaks(penumbra, profile)) offsets.push_back(profile.offset_world / profile.reference_width_world);
  }
  return spread_of(std::move(offsets));
}

std::optional<Spread> offset_texels(const PenumbraError& penumbra, const Image& test,
                                    std::span<const uint8_t> mask) {
  const TexelView texels = checked_texels(test, mask);
  std::vector<double> offsets;
  for (const PenumbraProfile& profile : penumbra.profiles) {
    const size_t i = profile.pixel(test.width);
    if (speaks(penumbra, profile) && texels.known(i))
      offsets.push_back(profile.offset_world / static_cast<double>(texels.width_world[i]));
  }
  return spread_of(std::move(offsets));
}

}  // namespace

size_t PenumbraNumbers::rejected() const {
  return std::accumulate(outcomes.begin(), outcomes.end(), size_t{0}) - accepted();
}

std::optional<FaultClass> worst_fault(const FaultNumbers& faults) {
  std::optional<FaultClass> worst;
  double largest = 0.0;
  for (size_t k = 0; k < kFaultClasses; ++k) {
    const auto fault = static_cast<FaultClass>(k);
    if (!is_fault(fault) || !(faults.by_class[k].mean_abs_error > largest)) continue;
    largest = faults.by_class[k].mean_abs_error;
    worst = fault;
  }
  return worst;
}

std::vector<FaultClass> named_faults(const FaultNumbers& faults) {
  std::vector<FaultClass> named;
  const auto part_of = [&](FaultClass fault) { return faults.of(fault).mean_abs_error; };
  for (size_t k = 0; k < kFaultClasses; ++k) {
    const auto fault = static_cast<FaultClass>(k);
    const double part = part_of(fault);
    if (is_fault(fault) && part > 0.0 && part >= kNamedShare * faults.mean_abs_error.value_or(0.0))
      named.push_back(fault);
  }
  std::ranges::stable_sort(named, std::ranges::greater{}, part_of);
  if (const auto worst = worst_fault(faults); named.empty() && worst) named.push_back(*worst);
  return named;
}

DiagnosedImage diagnose(const Image& test, const Image& reference, std::span<const uint8_t> mask) {
  PenumbraError penumbra = measure_penumbra(test, reference, mask);
  const Envelope envelope = measure_envelope(test, reference, mask, penumbra.profiles);
  Faults faults = classify_faults(test, reference, mask, penumbra.profiles, envelope);
  DiagnosedImage out;
  out.numbers.penumbra = {penumbra.outcomes,
                          penumbra.partial,
                          penumbra.width_octaves,
                          penumbra.width_10_90_octaves,
                          penumbra.offset_world,
                          offset_widths(penumbra),
                          offset_texels(penumbra, test, mask)};
  out.numbers.contact_hardening = measure_contact_hardening(penumbra);
  out.numbers.faults = {faults.scored_pixels, faults.by_class, faults.mean_abs_error,
                        faults.peter_panning_gap_world};
  out.numbers.moire = measure_moire(test, reference, mask, faults);
  out.numbers.causes = measure_causes(test, reference, mask, penumbra.profiles);
  out.classes = std::move(faults.classes);
  out.profiles = std::move(penumbra.profiles);
  return out;
}

}  // namespace umbrameter
