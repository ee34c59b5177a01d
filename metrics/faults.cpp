#include "metrics/faults.h"

#include "core/error.h"
#include "metrics/checks.h"
#include "metrics/fault_evidence.h"
#include "metrics/fault_shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace umbrameter {

namespace {

constexpr std::array<std::string_view, kFaultClasses> kNames = {
    "unscored",      "explained", "acne",           "terminator",  "extra_shadow", "penumbra",
    "peter_panning", "bleed",     "geometric_leak", "lost_shadow", "other"};

FaultInput checked_input(const Image& test, const Image& reference, std::span<const uint8_t> mask,
                         std::span<const PenumbraProfile> profiles, const Envelope& envelope,
                         const FaultSettings& settings) {
  require_same_size(test, reference, "faults");
  require_mask_size(reference, mask, "faults");
  UMBRAMETER_ASSERT(envelope.width == test.width && envelope.height == test.height, "envelope of {}x{}",
                    envelope.width, envelope.height);
  constexpr float kLargest = std::numeric_limits<float>::max();
  require_visibility(test, "visibility", mask);
  require_visibility(reference, "visibility", mask);
  for (const char* channel : {"shading_normal.x", "shading_normal.y", "shading_normal.z"}) {
    require_range(reference, channel, mask, -kLargest, kLargest);
  }
  for (const char* channel : {"blocker_distance_min", "blocker_layers"}) {
    require_range(reference, channel, mask, 0.0f, kLargest);
  }
  return {test.plane("visibility"),
          reference.plane("visibility"),
          mask,
          profiles,
          envelope,
          settings,
          checked_surface(reference),
          {reference.plane("shading_normal.x"), reference.plane("shading_normal.y"),
           reference.plane("shading_normal.z")},
          reference.plane("blocker_distance_min"),
          reference.plane("blocker_layers")};
}

// A shape takes along the connected error around it, its penumbra, up to three times its own size.
void claim_shapes(const FaultInput& input, float sign, std::span<const uint8_t> shape, FaultClass fault,
                  Faults& out) {
  const Components errors =
      components_of(input, select(input, [&](size_t i) {
                      return sign * (input.v[i] - input.r[i]) > input.envelope.tolerance[i] || shape[i] != 0;
                    }));
  std::vector<size_t> pixels(errors.count, 0), claimed(errors.count, 0);
  for (size_t i = 0; i < shape.size(); ++i) {
    if (errors.label[i] < 0) continue;
    ++pixels[static_cast<size_t>(errors.label[i])];
    claimed[static_cast<size_t>(errors.label[i])] += shape[i];
  }
  for (size_t i = 0; i < shape.size(); ++i) {
    if (errors.label[i] < 0) continue;
    const size_t k = static_cast<size_t>(errors.label[i]);
    if (shape[i] != 0 || 4 * claimed[k] >= pixels[k]) out.classes[i] = fault;
  }
  out.by_class[static_cast<size_t>(fault)].components +=
      static_cast<size_t>(std::count_if(claimed.begin(), claimed.end(), [](size_t n) { return n > 0; }));
}

// Speckles beside a penumbra are not its softness: that is wrong along a stretch of it.
bool is_softness(const Evidence& e) {
  return e.mostly(e.penumbra, 0.8) && static_cast<double>(e.pixels) * e.mass >= 2.0 * e.width_px;
}

FaultClass cause_of_dark(const Evidence& e, const FaultSettings&) {
  if (e.mostly(e.terminator)) return FaultClass::terminator;
  if (is_softness(e)) return FaultClass::penumbra;
  return e.mostly(e.lit) ? FaultClass::acne : FaultClass::other;
}

FaultClass cause_of_bright(const Evidence& e, const FaultSettings& settings) {
  if (e.mostly(e.contact)) return FaultClass::peter_panning;
  if (is_softness(e)) return FaultClass::penumbra;
  if (e.mostly(e.layered) && e.test <= settings.bleed_max_visibility * e.mass) return FaultClass::bleed;
  return e.reference < 0.5 * e.mass ? FaultClass::geometric_leak : FaultClass::other;
}

template <class Cause>
void classify_residual(const FaultInput& input, std::span<const float> residual,
                       std::span<const int32_t> penumbra, const Cause& cause, Faults& out) {
  const auto unclaimed = [&](size_t i) {
    return residual[i] > 0.0f && out.classes[i] == FaultClass::explained;
  };
  const Components components = components_of(input, select(input, unclaimed));
  std::vector<FaultClass> causes;
  for (const Evidence& evidence : gather_evidence(input, residual, components, penumbra)) {
    causes.push_back(cause(evidence, input.settings));
    ++out.by_class[static_cast<size_t>(causes.back())].components;
  }
  for (size_t i = 0; i < residual.size(); ++i) {
    if (components.label[i] >= 0) out.classes[i] = causes[static_cast<size_t>(components.label[i])];
  }
}

void add_shares(const FaultInput& input, Faults& out) {
  std::array<double, kFaultClasses> errors{};
  for (size_t i = 0; i < out.classes.size(); ++i) {
    const size_t k = static_cast<size_t>(out.classes[i]);
    ++out.by_class[k].pixels;
    if (input.mask[i] == 0) continue;
    ++out.scored_pixels;
    errors[k] += std::abs(static_cast<double>(input.v[i]) - input.r[i]);
  }
  if (out.scored_pixels == 0) return;
  out.mean_abs_error = 0.0;
  for (size_t k = 0; k < kFaultClasses; ++k) {
    out.by_class[k].mean_abs_error = errors[k] / static_cast<double>(out.scored_pixels);
    *out.mean_abs_error += out.by_class[k].mean_abs_error;
  }
}

}  // namespace

std::string_view name_of(FaultClass fault) {
  return kNames[static_cast<size_t>(fault)];
}

Faults classify_faults(const Image& test, const Image& reference, std::span<const uint8_t> mask,
                       std::span<const PenumbraProfile> profiles, const Envelope& envelope,
                       const FaultSettings& settings) {
  const FaultInput input = checked_input(test, reference, mask, profiles, envelope, settings);
  Faults out;
  out.width = test.width;
  out.height = test.height;
  out.classes.assign(mask.size(), FaultClass::unscored);
  for (size_t i = 0; i < mask.size(); ++i) {
    if (mask[i] != 0) out.classes[i] = FaultClass::explained;
  }
  claim_shapes(input, 1.0f, unmatched_shapes(input, input.r, input.v, 0.0), FaultClass::lost_shadow, out);
  claim_shapes(input, -1.0f, unmatched_shapes(input, input.v, input.r, settings.extra_shadow_radius_px),
               FaultClass::extra_shadow, out);
  const std::vector<int32_t> penumbra = nearest_penumbra_pixels(input);
  classify_residual(input, envelope.dark, penumbra, cause_of_dark, out);
  classify_residual(input, envelope.bright, penumbra, cause_of_bright, out);
  out.peter_panning_gap_world = median_gap_world(
      input, select(input, [&](size_t i) { return out.classes[i] == FaultClass::peter_panning; }));
  add_shares(input, out);
  return out;
}

}  // namespace umbrameter
