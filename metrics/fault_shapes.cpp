#include "metrics/fault_shapes.h"

#include "metrics/nearest_feature.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace umbrameter {

namespace {

double distance_px(size_t i, int32_t j, int width) {
  const int64_t columns = width, at = static_cast<int64_t>(i);
  return std::hypot(static_cast<double>(at % columns - j % columns),
                    static_cast<double>(at / columns - j / columns));
}

// Per component, how far its innermost pixel is from the nearest pixel outside.
std::vector<double> inscribed_radii(const FaultInput& input, const Components& components) {
  std::vector<uint8_t> outside(components.label.size());
  for (size_t i = 0; i < outside.size(); ++i) outside[i] = components.label[i] < 0 ? 1 : 0;
  const std::vector<int32_t> nearest = nearest_feature(outside, input.surface.width, input.surface.height);
  std::vector<double> radii(components.count, 0.0);
  for (size_t i = 0; i < outside.size(); ++i) {
    if (components.label[i] < 0) continue;
    double& radius = radii[static_cast<size_t>(components.label[i])];
    // Without any outside the component is the image.
    radius = std::max(radius, nearest[i] < 0 ? components.label.size() * 1.0
                                             : distance_px(i, nearest[i], input.surface.width));
  }
  return radii;
}

}  // namespace

std::vector<uint8_t> unmatched_shapes(const FaultInput& input, std::span<const float> dark,
                                      std::span<const float> other, double min_radius_px) {
  const Components shapes = components_of(input, select(input, [&](size_t i) { return dark[i] < 0.5f; }));
  std::vector<size_t> pixels(shapes.count, 0), met(shapes.count, 0);
  for (size_t i = 0; i < shapes.label.size(); ++i) {
    if (shapes.label[i] < 0) continue;
    ++pixels[static_cast<size_t>(shapes.label[i])];
    if (other[i] < 0.5f) ++met[static_cast<size_t>(shapes.label[i])];
  }
  const std::vector<double> radii =
      min_radius_px > 0.0 ? inscribed_radii(input, shapes) : std::vector<double>(shapes.count, 0.0);
  return select(input, [&](size_t i) {
    if (shapes.label[i] < 0) return false;
    const size_t k = static_cast<size_t>(shapes.label[i]);
    return pixels[k] >= input.settings.min_component_px && radii[k] >= min_radius_px &&
           static_cast<double>(met[k]) < input.settings.lost_overlap * static_cast<double>(pixels[k]);
  });
}

// Twice the largest distance to a pixel outside, less one pixel, is n for a strip n pixels wide.
std::optional<double> median_gap_world(const FaultInput& input, std::span<const uint8_t> gap) {
  const Components components = components_of(input, gap);
  std::vector<uint8_t> outside(gap.size());
  for (size_t i = 0; i < gap.size(); ++i) outside[i] = gap[i] == 0 && input.surface.hit(i) ? 1 : 0;
  const std::vector<int32_t> nearest = nearest_feature(outside, input.surface.width, input.surface.height);
  std::vector<double> widths(components.count, 0.0);
  for (size_t i = 0; i < gap.size(); ++i) {
    if (components.label[i] < 0 || nearest[i] < 0) continue;
    const double px = distance_px(i, nearest[i], input.surface.width);
    const double world =
        glm::length(input.surface.p_world(i) - input.surface.p_world(static_cast<size_t>(nearest[i])));
    double& width = widths[static_cast<size_t>(components.label[i])];
    width = std::max(width, world * (2.0 - 1.0 / px));
  }
  const auto spread = spread_of(std::move(widths));
  return spread ? std::optional(spread->median) : std::nullopt;
}

}  // namespace umbrameter
