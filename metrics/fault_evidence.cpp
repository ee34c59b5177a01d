#include "metrics/fault_evidence.h"

#include "metrics/nearest_feature.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace umbrameter {

namespace {

constexpr double kContactPixels = 6.0;
constexpr double kWidestContact = 3.0;  // px; below, a penumbra has no softness to be wrong

double pixel_extent_world(const SurfaceView& surface, size_t i) {
  const size_t columns = static_cast<size_t>(surface.width);
  double extent = 0.0;
  if (i % columns > 0 && same_surface(surface, i, i - 1)) {
    extent = glm::length(surface.p_world(i) - surface.p_world(i - 1));
  }
  if (i >= columns && same_surface(surface, i, i - columns)) {
    extent = std::max(extent, glm::length(surface.p_world(i) - surface.p_world(i - columns)));
  }
  return extent;
}

bool in_contact(const FaultInput& input, size_t i) {
  const double distance = input.blocker_distance[i];
  if (!(distance > 0.0)) return false;
  if (input.settings.contact_distance_world) return distance < *input.settings.contact_distance_world;
  return distance < kContactPixels * pixel_extent_world(input.surface, i);
}

bool normals_disagree(const FaultInput& input, size_t i, double cosine_limit) {
  const glm::dvec3 shading = {input.shading_normal[0][i], input.shading_normal[1][i],
                              input.shading_normal[2][i]};
  return glm::dot(shading, input.surface.n_world(i)) < cosine_limit;
}

double nearest_width_px(const FaultInput& input, size_t i) {
  const int32_t nearest = input.envelope.nearest_profile[i];
  return nearest < 0 ? 0.0 : input.profiles[static_cast<size_t>(nearest)].reference_width_px;
}

bool beside_penumbra(const FaultInput& input, size_t i, int32_t nearest, double width_px) {
  if (nearest < 0 || width_px < kWidestContact) return false;
  const int64_t columns = input.surface.width, at = static_cast<int64_t>(i);
  const double dx = static_cast<double>(at % columns - nearest % columns);
  const double dy = static_cast<double>(at / columns - nearest / columns);
  return std::hypot(dx, dy) <= width_px;
}

}  // namespace

std::vector<Evidence> gather_evidence(const FaultInput& input, std::span<const float> residual,
                                      const Components& components,
                                      std::span<const int32_t> nearest_penumbra) {
  const double cosine_limit = std::cos(input.settings.terminator_deg * std::numbers::pi / 180.0);
  std::vector<Evidence> evidence(components.count);
  for (size_t i = 0; i < residual.size(); ++i) {
    if (components.label[i] < 0) continue;
    Evidence& sums = evidence[static_cast<size_t>(components.label[i])];
    const double mass = residual[i];
    const double width_px = nearest_width_px(input, i);
    // Where V is too dark, low = V + tolerance + residual is the least visibility around.
    const double low = static_cast<double>(input.v[i]) + input.envelope.tolerance[i] + mass;
    sums.pixels += 1;
    sums.mass += mass;
    if (low > 1.0 - input.settings.lit_epsilon) sums.lit += mass;
    if (normals_disagree(input, i, cosine_limit)) sums.terminator += mass;
    if (in_contact(input, i)) sums.contact += mass;
    if (input.blocker_layers[i] >= input.settings.bleed_layers) sums.layered += mass;
    if (beside_penumbra(input, i, nearest_penumbra[i], width_px)) sums.penumbra += mass;
    sums.test += mass * input.v[i];
    sums.reference += mass * input.r[i];
    sums.width_px += mass * width_px;
  }
  return evidence;
}

std::vector<int32_t> nearest_penumbra_pixels(const FaultInput& input) {
  std::vector<uint8_t> is_penumbra(input.r.size());
  for (size_t i = 0; i < input.r.size(); ++i) {
    is_penumbra[i] = input.mask[i] != 0 && input.r[i] > 0.2f && input.r[i] < 0.8f ? 1 : 0;
  }
  return nearest_feature(is_penumbra, input.surface.width, input.surface.height);
}

}  // namespace umbrameter
