// SPDX-License-Identifier: Apache-2.0
#include "metrics/faults/faults.h"

#include "core/error.h"
#include "metrics/faults/fault_evidence.h"
#include "metrics/faults/fault_shapes.h"
#include "metrics/image/checks.h"
#include "metrics/image/tiles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace umbrameter {

namespace {

constexpr std::array<std::string_view, kFaultClasses> kNames = {
    "unscored",   "explained",         "acne",       "terminator",    "extra_shadow", "penumbra",
    "overlap",    "penumbra_too_wide", "resolution", "peter_panning", "bleed",        "geometric_leak",
    "lost_shadow"};

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
  const bool has_light = reference.has("unshadowed_irradiance");
  const std::span<const float> irradiance =
      has_light ? reference.plane("unshadowed_irradiance") : std::span<const float>();
  float largest = 0.0f;
  for (size_t i = 0; i < irradiance.size(); ++i)
    largest = mask[i] != 0 ? std::max(largest, irradiance[i]) : largest;
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
          reference.plane("blocker_layers"),
          irradiance,
          largest,
          checked_texels(test, mask)};
}

// Whether nothing of the truth's shadow is left in the test.
bool is_gone(const FaultInput& input, size_t i) {
  return static_cast<double>(input.v[i]) > 1.0 - input.settings.lit_epsilon;
}

// A shape takes along the connected error around it, its penumbra, up to three times its own size; a lost one
// also the connected shadow that is gone as wholly, such as the tip of a post's, which has no umbra.
void claim_shapes(const FaultInput& input, float sign, std::span<const uint8_t> shape, FaultClass fault,
                  Faults& out) {
  if (shape.empty()) return;
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
    const bool is_lost = fault == FaultClass::lost_shadow && claimed[k] > 0 && is_gone(input, i);
    if (shape[i] != 0 || 4 * claimed[k] >= pixels[k] || is_lost) out.classes[i] = fault;
  }
}

// A ramp moved by its whole width is wrong by two thirds, on average over the error; one of another width by less.
// Full light in full shadow is no ramp.
bool may_be_ramp(const Evidence& e) {
  return std::abs(e.test - e.reference) <= 2.0 / 3.0 * e.mass;
}

// Wrong along a stretch of a penumbra and in it; speckles and stripes beside one are not its softness.
bool is_softness(const Evidence& e) {
  const double partial = e.mass - e.of(Sign::plain);
  return may_be_ramp(e) && !e.mostly(Sign::alone) && e.mostly(Sign::near, 0.8) && partial > 0.1 * e.mass &&
         static_cast<double>(e.pixels) * e.mass >= 2.0 * e.width_px;
}

FaultClass softness(const Evidence& e) {
  if (e.mostly(Sign::wider)) return FaultClass::penumbra_too_wide;
  return e.of(Sign::overlap) > e.of(Sign::separate) ? FaultClass::overlap : FaultClass::penumbra;
}

// Where a map is too coarse or a filter too wide, acne and gaps at contacts are what comes of it.
std::optional<FaultClass> shared_cause(const Evidence& e) {
  if (e.mostly(Sign::terminator)) return FaultClass::terminator;
  if (e.mostly(Kind::edge)) return FaultClass::resolution;
  if (e.mostly(Kind::blurred)) return FaultClass::penumbra_too_wide;
  return std::nullopt;
}

FaultClass cause_of_dark(const Evidence& e, const FaultSettings&) {
  if (const auto fault = shared_cause(e)) return *fault;
  if (e.mostly(Sign::edge)) return FaultClass::resolution;
  if (is_softness(e)) return softness(e);
  return e.mostly(Sign::plain) || e.mostly(Sign::alone) ? FaultClass::acne : softness(e);
}

FaultClass cause_of_bright(const Evidence& e, const FaultSettings& settings) {
  if (const auto fault = shared_cause(e)) return *fault;
  if (e.mostly(Sign::contact)) return FaultClass::peter_panning;
  if (e.mostly(Sign::edge)) return FaultClass::resolution;
  if (is_softness(e)) return softness(e);
  if (e.mostly(Sign::layered) && e.test <= settings.bleed_max_visibility * e.mass) return FaultClass::bleed;
  return e.mostly(Sign::plain) || e.mostly(Sign::alone) || !may_be_ramp(e) ? FaultClass::geometric_leak
                                                                           : softness(e);
}

using Cause = FaultClass (*)(const Evidence&, const FaultSettings&);

// Pieces of one kind of the components that no kind has to itself; small ones stay with the whole.
void classify_pieces(const FaultInput& input, std::span<const float> residual, std::span<const Signs> signs,
                     const Components& components, std::span<const Evidence> wholes, Cause cause,
                     Faults& out) {
  const std::vector<uint8_t> kinds = select(input, [&](size_t i) {
    if (components.label[i] < 0) return 0;
    const Evidence& whole = wholes[static_cast<size_t>(components.label[i])];
    return !whole.is_mixed() || is_softness(whole) ? 0 : 1 + static_cast<int>(kind_of(signs[i]));
  });
  const Components pieces = components_of(input, kinds);
  const std::vector<Evidence> evidence = gather_evidence(input, residual, signs, pieces);
  for (size_t i = 0; i < residual.size(); ++i) {
    if (pieces.label[i] < 0) continue;
    const Evidence& piece = evidence[static_cast<size_t>(pieces.label[i])];
    if (piece.pixels >= input.settings.min_component_px) out.classes[i] = cause(piece, input.settings);
  }
}

void classify_residual(const FaultInput& input, std::span<const float> residual, bool is_dark,
                       const Surroundings& around, Faults& out) {
  const Cause cause = is_dark ? cause_of_dark : cause_of_bright;
  const std::vector<Signs> signs = read_signs(input, residual, is_dark, around);
  const Components components = components_of(
      input,
      select(input, [&](size_t i) { return residual[i] > 0.0f && out.classes[i] == FaultClass::explained; }));
  const std::vector<Evidence> wholes = gather_evidence(input, residual, signs, components);
  std::vector<FaultClass> causes;
  for (const Evidence& whole : wholes) causes.push_back(cause(whole, input.settings));
  for (size_t i = 0; i < residual.size(); ++i) {
    if (components.label[i] >= 0) out.classes[i] = causes[static_cast<size_t>(components.label[i])];
  }
  if (std::any_of(wholes.begin(), wholes.end(), [](const Evidence& e) { return e.is_mixed(); })) {
    classify_pieces(input, residual, signs, components, wholes, cause, out);
  }
}

void count_components(const FaultInput& input, Faults& out) {
  const std::vector<uint8_t> kinds = select(input, [&](size_t i) {
    return out.classes[i] == FaultClass::explained ? 0 : static_cast<int>(out.classes[i]);
  });
  const Components components = components_of(input, kinds);
  size_t next = 0;  // labels are in reading order of first pixels
  for (size_t i = 0; i < kinds.size(); ++i) {
    if (components.label[i] != static_cast<int32_t>(next)) continue;
    ++out.by_class[kinds[i]].components;
    ++next;
  }
}

struct ClassSums {
  std::array<size_t, kFaultClasses> pixels{};
  std::array<double, kFaultClasses> errors{};
};

void add_shares(const FaultInput& input, Faults& out) {
  const TileGrid grid = {out.width, out.height, 64};
  const auto tiles = for_each_tile<ClassSums>(grid, [&](const Tile& tile, ClassSums& sums) {
    for_each_pixel(grid, tile, [&](size_t i) {
      const size_t k = static_cast<size_t>(out.classes[i]);
      ++sums.pixels[k];
      if (input.mask[i] != 0) sums.errors[k] += std::abs(input.error(i));
    });
  });
  std::array<double, kFaultClasses> errors{};
  for (const ClassSums& tile : tiles) {
    for (size_t k = 0; k < kFaultClasses; ++k) {
      out.by_class[k].pixels += tile.pixels[k];
      errors[k] += tile.errors[k];
    }
  }
  out.scored_pixels = out.classes.size() - out.of(FaultClass::unscored).pixels;
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
  const std::vector<uint8_t> thin = thin_shapes(input), kept = shade_is_kept(input);
  claim_shapes(input, 1.0f, lost_shapes(input, thin, kept, Loss::thin), FaultClass::resolution, out);
  claim_shapes(input, 1.0f, lost_shapes(input, thin, kept, Loss::blurred), FaultClass::penumbra_too_wide,
               out);
  claim_shapes(input, 1.0f, lost_shapes(input, thin, kept, Loss::terminator), FaultClass::terminator, out);
  claim_shapes(input, 1.0f, lost_shapes(input, thin, kept, Loss::other), FaultClass::lost_shadow, out);
  claim_shapes(input, 1.0f, lost_shapes(input, thin, kept, Loss::contact), FaultClass::peter_panning, out);
  claim_shapes(input, -1.0f, extra_shapes(input), FaultClass::extra_shadow, out);
  const Surroundings around = look_around(input, thin, kept);
  classify_residual(input, envelope.dark, true, around, out);
  classify_residual(input, envelope.bright, false, around, out);
  count_components(input, out);
  if (out.of(FaultClass::peter_panning).components > 0) {
    out.peter_panning_gap_world = median_gap_world(
        input, select(input, [&](size_t i) { return out.classes[i] == FaultClass::peter_panning; }));
  }
  add_shares(input, out);
  return out;
}

}  // namespace umbrameter
