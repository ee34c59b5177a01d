// SPDX-License-Identifier: Apache-2.0
#include "metrics/faults/fault_evidence.h"

#include "metrics/faults/blurred_edge.h"
#include "metrics/image/nearest_feature.h"
#include "metrics/image/standing_alone.h"
#include "metrics/image/tiles.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace umbrameter {

namespace {

constexpr double kContactPixels = 6.0;
constexpr double kContactTexels = 3.0;
constexpr double kContactBiases = 2.0;  // a normal offset gains more than its length on a slope
// By which a penumbra widens when both its rims move by the envelope's radius.
const double kExcusedOctaves = std::log2(1.0 + 2.0 * EnvelopeSettings{}.radius_per_width);
constexpr double kWidestContact = 3.0;        // px; below, a penumbra has no softness to be wrong
constexpr double kReachWidths = 2.0;          // from one width outside to the far end of the penumbra
constexpr double kEdgeTexels = 1.5;           // half a texel of sampling, one of its neighbour
constexpr double kLargestFootprintPx = 16.0;  // beyond, most of a picture lies beside some edge
constexpr double kBlurShare = 0.5;            // of a pixel's error that a blur of the whole picture may leave
// Facets of a smooth mesh shadow each other where the light grazes them; a technique that smooths that away is too bright.
constexpr double kSmoothMeshDeg = 1.0;
constexpr float kGrazing = 0.35f;  // of the largest irradiance
// Of 16 probe rays all miss a blocker of a fifth of the light in 3 % of the pixels.
constexpr float kHorizonVisibility = 0.8f;

constexpr Signs bit(Sign sign) {
  return static_cast<Signs>(1u << static_cast<unsigned>(sign));
}

bool normals_disagree(const FaultInput& input, size_t i, double degrees) {
  const glm::dvec3 shading = {input.shading_normal[0][i], input.shading_normal[1][i],
                              input.shading_normal[2][i]};
  return glm::dot(shading, input.surface.n_world(i)) < std::cos(degrees * std::numbers::pi / 180.0);
}

bool touches(const FaultInput& input, size_t i) {
  const double distance = input.blocker_distance[i];
  if (!(distance > 0.0)) return false;
  if (input.settings.contact_distance_world) return distance < *input.settings.contact_distance_world;
  if (!input.texels.bias_world.empty() && distance < kContactBiases * input.texels.bias_world[i]) return true;
  return distance < kContactPixels * pixel_extent_world(input.surface, i);
}

bool at_grazing_facet(const FaultInput& input, size_t i) {
  if (input.irradiance.empty() || input.irradiance[i] > kGrazing * input.largest_irradiance) return false;
  return normals_disagree(input, i, kSmoothMeshDeg) &&
         (input.blocker_layers[i] == 0.0f || in_contact(input, i));
}

// In part dark without a blocker: the receiver's own plane cuts the light.
bool at_own_horizon(const FaultInput& input, size_t i) {
  return input.blocker_layers[i] == 0.0f && input.r[i] < kHorizonVisibility;
}

// Only a texel larger than a pixel makes an edge coarser than the picture.
bool at_coarse_edge(const FaultInput& input, size_t i, double distance, double width_px) {
  const double texel_px =
      std::min(footprint_px(texel_step(input.texels, input.surface, i)), kLargestFootprintPx);
  return is_under_resolved(texel_px, width_px) && distance <= kEdgeTexels * texel_px;
}

const PenumbraProfile* nearest_profile(const FaultInput& input, size_t i) {
  const int32_t nearest = input.envelope.nearest_profile[i];
  return nearest < 0 ? nullptr : &input.profiles[static_cast<size_t>(nearest)];
}

double nearest_width_px(const FaultInput& input, size_t i) {
  const PenumbraProfile* profile = nearest_profile(input, i);
  return profile == nullptr ? 0.0 : profile->reference_width_px;
}

// A bias beyond what a map's texels need lets light in from the shadow's edge, too: as far as it moved the receiver.
bool displaced(const FaultInput& input, size_t i, int32_t nearest_edge) {
  const TexelView& texels = input.texels;
  if (nearest_edge < 0 || texels.bias_world.empty()) return false;
  const double bias_world = texels.bias_world[i];
  return bias_world > kContactTexels * texels.width_world[i] &&
         glm::distance(input.surface.p_world(i), input.surface.p_world(static_cast<size_t>(nearest_edge))) <
             bias_world;
}

// The extreme of R that the envelope left unexplained: V is beyond it by tolerance and residual.
double extreme_around(const FaultInput& input, size_t i, float residual, bool is_dark) {
  const double beyond = static_cast<double>(input.envelope.tolerance[i]) + residual;
  return is_dark ? input.v[i] + beyond : input.v[i] - beyond;
}

// All of a map's errors lie about a caster thinner than its texels.
bool at_thin_caster(const FaultInput& input, size_t i, const Surroundings& around) {
  if (around.nearest_thin.empty()) return false;
  const double texel_px = footprint_px(texel_step(input.texels, input.surface, i));
  return distance_px(static_cast<int64_t>(i), around.nearest_thin[i], input.surface.width) <=
         kEdgeTexels * texel_px;
}

bool is_blurred(const FaultInput& input, size_t i, bool is_dark, const Surroundings& around) {
  if ((input.r[i] > 0.5f) != is_dark) return false;
  if (!around.blurred_truth.empty()) {
    const double left = std::abs(static_cast<double>(input.v[i]) - around.blurred_truth[i]);
    if (left <= kBlurShare * std::abs(input.error(i))) return true;
  }
  const int32_t edge = around.nearest_edge[i];
  if (edge < 0) return false;
  const Outskirts outskirts = {input.v, input.r, input.mask, input.surface, is_dark ? 1.0f : -1.0f};
  return is_blurred_edge(outskirts, i, static_cast<size_t>(edge), input.envelope.tolerance[i],
                         around.kept[i] != 0);
}

Signs signs_of(const FaultInput& input, size_t i, float residual, bool is_dark, const Surroundings& around) {
  const int32_t nearest_edge = around.nearest_edge[i];
  Signs signs = 0;
  const auto add = [&](Sign sign, bool holds) {
    signs = static_cast<Signs>(signs | (holds ? bit(sign) : 0));
  };
  const double extreme = extreme_around(input, i, residual, is_dark);
  const double epsilon = input.settings.lit_epsilon;
  const bool plain = is_dark ? extreme > 1.0 - epsilon : extreme < epsilon;
  add(Sign::plain, plain);
  add(Sign::terminator, is_dark ? normals_disagree(input, i, input.settings.terminator_deg)
                                : on_own_facets(input, i) || at_own_horizon(input, i));
  add(Sign::blurred, is_blurred(input, i, is_dark, around));
  add(Sign::edge, at_thin_caster(input, i, around));
  if (!is_dark && input.r[i] < 0.5f) {
    const bool is_touching = touches(input, i) || displaced(input, i, nearest_edge);
    add(Sign::touching, is_touching);
    add(Sign::contact, is_touching || in_contact(input, i));
  }
  if (!is_dark) {
    add(Sign::layered, plain && input.blocker_layers[i] >= input.settings.bleed_layers);
  }
  if (const PenumbraProfile* profile = nearest_profile(input, i)) {
    add(Sign::overlap, profile->overlaps);
    add(Sign::separate, profile->has_ridge && !profile->overlaps);
    add(Sign::wider,
        profile->outcome == ProfileOutcome::accepted && profile->width_octaves > kExcusedOctaves);
  }
  if (nearest_edge < 0) return signs;
  const double distance = distance_px(i, nearest_edge, input.surface.width),
               width_px = nearest_width_px(input, i);
  const bool is_near = width_px >= kWidestContact && distance <= width_px;
  add(Sign::near, is_near);
  const Outskirts outskirts = {input.v, input.r, input.mask, input.surface, is_dark ? 1.0f : -1.0f};
  add(Sign::alone, is_near && outskirts.on_plateau(i, static_cast<float>(epsilon)) &&
                       stands_alone(outskirts, i, kReachWidths * width_px, input.envelope.tolerance[i]));
  add(Sign::edge, at_coarse_edge(input, i, distance, width_px));
  return signs;
}

bool crosses_half(const FaultInput& input, size_t i, size_t j) {
  return input.mask[j] != 0 && (input.r[i] < 0.5f) != (input.r[j] < 0.5f) &&
         same_surface(input.surface, i, j);
}

}  // namespace

Kind kind_of(Signs signs) {
  const auto has = [signs](Sign sign) { return (signs & bit(sign)) != 0; };
  if (has(Sign::terminator)) return Kind::terminator;
  // A gap at a contact within a texel and a half of its edge is no stair; a blur there is.
  if (has(Sign::edge) && (has(Sign::blurred) || !has(Sign::touching))) return Kind::edge;
  if (has(Sign::blurred)) return Kind::blurred;
  if (has(Sign::contact)) return Kind::contact;
  if (has(Sign::edge)) return Kind::edge;
  if (has(Sign::layered)) return Kind::layered;
  if (has(Sign::plain)) return Kind::plain;
  return has(Sign::alone) ? Kind::alone : Kind::partial;
}

bool Evidence::is_mixed() const {
  return *std::max_element(by_kind.begin(), by_kind.end()) < 0.8 * mass;
}

bool in_contact(const FaultInput& input, size_t i) {
  if (touches(input, i)) return true;
  const double distance = input.blocker_distance[i];
  return distance > 0.0 && !input.settings.contact_distance_world && input.texels.known(i) &&
         distance < kContactTexels * input.texels.width_world[i];
}

bool on_own_facets(const FaultInput& input, size_t i) {
  return normals_disagree(input, i, input.settings.terminator_deg) || at_grazing_facet(input, i);
}

std::vector<Signs> read_signs(const FaultInput& input, std::span<const float> residual, bool is_dark,
                              const Surroundings& around) {
  std::vector<Signs> signs(residual.size(), 0);
  for_each_row(input.surface.height, [&](int y) {
    const size_t width = static_cast<size_t>(input.surface.width), begin = static_cast<size_t>(y) * width;
    for (size_t i = begin; i < begin + width; ++i) {
      if (!(residual[i] > 0.0f)) continue;
      signs[i] = signs_of(input, i, residual[i], is_dark, around);
    }
  });
  return signs;
}

std::vector<Evidence> gather_evidence(const FaultInput& input, std::span<const float> residual,
                                      std::span<const Signs> signs, const Components& components) {
  std::vector<Evidence> evidence(components.count);
  for (size_t i = 0; i < residual.size(); ++i) {
    if (components.label[i] < 0) continue;
    Evidence& sums = evidence[static_cast<size_t>(components.label[i])];
    const double mass = residual[i];
    sums.pixels += 1;
    sums.mass += mass;
    for (size_t k = 0; k < kSigns; ++k) sums.by_sign[k] += (signs[i] >> k & 1) != 0 ? mass : 0.0;
    sums.by_kind[static_cast<size_t>(kind_of(signs[i]))] += mass;
    sums.test += mass * input.v[i];
    sums.reference += mass * input.r[i];
    sums.width_px += mass * nearest_width_px(input, i);
  }
  return evidence;
}

Surroundings look_around(const FaultInput& input, std::span<const uint8_t> thin,
                         std::span<const uint8_t> kept) {
  std::vector<uint8_t> is_edge(input.r.size(), 0);
  const int height = input.surface.height;
  for_each_row(height, [&](int y) {
    const size_t width = static_cast<size_t>(input.surface.width), begin = static_cast<size_t>(y) * width;
    for (size_t i = begin; i < begin + width; ++i) {
      if (input.mask[i] == 0) continue;
      const bool crosses = (i + 1 < begin + width && crosses_half(input, i, i + 1)) ||
                           (y + 1 < height && crosses_half(input, i, i + width));
      is_edge[i] = (input.r[i] > 0.2f && input.r[i] < 0.8f) || crosses ? 1 : 0;
    }
  });
  Surroundings around;
  around.kept = kept;
  around.nearest_edge = nearest_feature(is_edge, input.surface.width, height);
  if (!thin.empty()) around.nearest_thin = nearest_feature(thin, input.surface.width, height);
  std::vector<uint8_t> seen(input.mask.size());
  for (size_t i = 0; i < seen.size(); ++i) seen[i] = input.surface.hit(i) ? 1 : 0;
  around.blurred_truth = blurred_as_picture(input.v, input.r, input.mask, seen, input.surface.width, height);
  return around;
}

}  // namespace umbrameter
