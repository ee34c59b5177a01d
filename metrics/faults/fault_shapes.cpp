// SPDX-License-Identifier: Apache-2.0
#include "metrics/faults/fault_shapes.h"

#include "metrics/image/nearest_feature.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace umbrameter {

namespace {

constexpr double kSolidShare = 0.5;  // of what is wrong, covered by the disc
constexpr double kOpenRim = 0.25;    // of a shadow's rim; facets that are dark as a whole have less
constexpr double kKeptShade = 0.5;   // of what a shadow lost; a filter moves shade, a missing caster takes it
constexpr double kRadiusTexels = 1.5;  // acne's stripes are at most a texel wide
constexpr double kLargestRadiusPx = 64.0;

// A shape of visibility < .5, what of it the other image has at least half as deep, and what the rules ask of the pixels it does not meet.
struct Shape {
  size_t pixels = 0, met = 0;
  size_t contact = 0;        // pixels whose blocker is in contact
  size_t thin = 0;           // of a shape thinner than a texel
  size_t terminator = 0;     // where the receiver shadows itself
  size_t blurred = 0;        // not fully lit, and its shade found around
  size_t rim = 0, open = 0;  // neighbours outside it; those that go on with its surface
  size_t solid = 0;

  size_t wrong() const { return pixels - met; }
};

bool is_unmatched(const FaultInput& input, const Shape& shape) {
  return shape.pixels >= input.settings.min_component_px &&
         static_cast<double>(shape.met) < input.settings.lost_overlap * static_cast<double>(shape.pixels);
}

// Half as deep a shadow is still there; .49 of light against .51 tells nothing.
bool meets(float own, float other) {
  return other < 0.5f * (1.0f + own);
}

// The overlap is measured against the shape alone, so that a neighbour's shadow merging with it in one image
// only does not hide it.
std::vector<Shape> measure_overlap(const Components& components, std::span<const float> own,
                                   std::span<const float> other) {
  std::vector<Shape> shapes(components.count);
  for (size_t i = 0; i < components.label.size(); ++i) {
    if (components.label[i] < 0) continue;
    Shape& shape = shapes[static_cast<size_t>(components.label[i])];
    ++shape.pixels;
    shape.met += meets(own[i], other[i]) ? 1 : 0;
  }
  return shapes;
}

bool any_unmatched(const FaultInput& input, const std::vector<Shape>& shapes) {
  return std::any_of(shapes.begin(), shapes.end(), [&](const Shape& s) { return is_unmatched(input, s); });
}

// visit(shape, i) for the wrong pixels of unmatched shapes.
template <class Visit>
void for_wrong_pixels(const FaultInput& input, const Components& components, std::span<const float> own,
                      std::span<const float> other, std::vector<Shape>& shapes, const Visit& visit) {
  for (size_t i = 0; i < components.label.size(); ++i) {
    if (components.label[i] < 0 || meets(own[i], other[i])) continue;
    Shape& shape = shapes[static_cast<size_t>(components.label[i])];
    if (is_unmatched(input, shape)) visit(shape, i);
  }
}

void count_rim(const FaultInput& input, const Components& components, size_t i, size_t j, Shape& shape) {
  if (components.label[j] == components.label[i]) return;
  ++shape.rim;
  shape.open += input.mask[j] != 0 && same_surface(input.surface, i, j) ? 1 : 0;
}

double solid_radius_px(const FaultInput& input, size_t i) {
  const double texel_px = footprint_px(texel_step(input.texels, input.surface, i));
  return std::clamp(kRadiusTexels * texel_px, input.settings.extra_shadow_radius_px, kLargestRadiusPx);
}

// Erosion and dilation of the shapes by the disc, so that stripes and their crossings drop out.
std::vector<uint8_t> opened(const FaultInput& input, const Components& components) {
  const int width = input.surface.width, height = input.surface.height;
  std::vector<uint8_t> outside(components.label.size()), core(components.label.size(), 0);
  for (size_t i = 0; i < outside.size(); ++i) outside[i] = components.label[i] < 0 ? 1 : 0;
  const std::vector<int32_t> nearest_outside = nearest_feature(outside, width, height);
  for_each_row(height, [&](int y) {
    const size_t begin = static_cast<size_t>(y) * static_cast<size_t>(width);
    for (size_t i = begin; i < begin + static_cast<size_t>(width); ++i) {
      if (components.label[i] < 0) continue;
      const bool is_core =
          nearest_outside[i] < 0 || distance_px(i, nearest_outside[i], width) >= solid_radius_px(input, i);
      core[i] = is_core ? 1 : 0;
    }
  });
  const std::vector<int32_t> nearest_core = nearest_feature(core, width, height);
  std::vector<uint8_t> solid(core.size(), 0);
  for (size_t i = 0; i < solid.size(); ++i) {
    if (components.label[i] < 0 || nearest_core[i] < 0) continue;
    const size_t at = static_cast<size_t>(nearest_core[i]);
    solid[i] = distance_px(i, nearest_core[i], width) < solid_radius_px(input, at) ? 1 : 0;
  }
  return solid;
}

bool is_solid(const FaultInput& input, const Shape& shape) {
  const double wrong = static_cast<double>(shape.wrong());
  return is_unmatched(input, shape) && static_cast<double>(shape.solid) >= kSolidShare * wrong &&
         static_cast<double>(shape.open) >= kOpenRim * static_cast<double>(shape.rim);
}

// Of each component. Twice the largest distance to a pixel outside, less one pixel, is n for a strip n pixels wide.
std::vector<double> widest_world(const FaultInput& input, std::span<const uint8_t> shape,
                                 const Components& components) {
  std::vector<uint8_t> outside(shape.size());
  for (size_t i = 0; i < shape.size(); ++i) outside[i] = shape[i] == 0 && input.surface.hit(i) ? 1 : 0;
  const std::vector<int32_t> nearest = nearest_feature(outside, input.surface.width, input.surface.height);
  std::vector<double> widths(components.count, 0.0);
  for (size_t i = 0; i < shape.size(); ++i) {
    if (components.label[i] < 0 || nearest[i] < 0) continue;
    const double px = distance_px(static_cast<int64_t>(i), nearest[i], input.surface.width);
    const double world =
        glm::length(input.surface.p_world(i) - input.surface.p_world(static_cast<size_t>(nearest[i])));
    double& width = widths[static_cast<size_t>(components.label[i])];
    width = std::max(width, world * (2.0 - 1.0 / px));
  }
  return widths;
}

template <class Keep>
std::vector<uint8_t> pixels_of(const FaultInput& input, const Components& components,
                               const std::vector<Shape>& shapes, const Keep& keep) {
  return select(input, [&](size_t i) {
    return components.label[i] >= 0 && keep(shapes[static_cast<size_t>(components.label[i])]);
  });
}

}  // namespace

std::vector<uint8_t> thin_shapes(const FaultInput& input) {
  if (!input.texels.known()) return {};
  const std::vector<uint8_t> dark = select(input, [&](size_t i) { return input.r[i] < 0.5f; });
  const Components components = components_of(input, dark);
  const std::vector<double> widest = widest_world(input, dark, components);
  bool any = false;
  std::vector<uint8_t> thin(dark.size(), 0);
  for (size_t i = 0; i < thin.size(); ++i) {
    if (components.label[i] < 0 || !input.texels.known(i)) continue;
    const bool is_thin =
        widest[static_cast<size_t>(components.label[i])] < static_cast<double>(input.texels.width_world[i]) &&
        footprint_px(texel_step(input.texels, input.surface, i)) > 1.0;
    thin[i] = is_thin ? 1 : 0;
    any = any || is_thin;
  }
  return any ? thin : std::vector<uint8_t>();
}

std::vector<uint8_t> shade_is_kept(const FaultInput& input) {
  const Components errors = components_of(
      input, select(input, [&](size_t i) { return std::abs(input.error(i)) > input.envelope.tolerance[i]; }));
  std::vector<double> lost(errors.count, 0.0), found(errors.count, 0.0);
  for (size_t i = 0; i < errors.label.size(); ++i) {
    if (errors.label[i] < 0) continue;
    const double error = input.error(i);
    (error > 0.0 ? lost : found)[static_cast<size_t>(errors.label[i])] += std::abs(error);
  }
  return select(input, [&](size_t i) {
    if (errors.label[i] < 0) return false;
    const size_t k = static_cast<size_t>(errors.label[i]);
    return std::min(found[k], lost[k]) >= kKeptShade * std::max(found[k], lost[k]);
  });
}

std::vector<uint8_t> lost_shapes(const FaultInput& input, std::span<const uint8_t> thin,
                                 std::span<const uint8_t> kept, Loss loss) {
  if (loss == Loss::thin && thin.empty()) return {};
  const Components components =
      components_of(input, select(input, [&](size_t i) { return input.r[i] < 0.5f; }));
  std::vector<Shape> shapes = measure_overlap(components, input.r, input.v);
  if (!any_unmatched(input, shapes)) return {};
  for_wrong_pixels(input, components, input.r, input.v, shapes, [&](Shape& shape, size_t i) {
    shape.blurred += kept[i] != 0 && input.v[i] < 1.0 - input.settings.lit_epsilon ? 1 : 0;
    shape.contact += in_contact(input, i) ? 1 : 0;
    shape.terminator += on_own_facets(input, i) ? 1 : 0;
    shape.thin += !thin.empty() && thin[i] != 0 ? 1 : 0;
  });
  return pixels_of(input, components, shapes, [&](const Shape& shape) {
    const Loss reason = shape.thin > 0                         ? Loss::thin
                        : 2 * shape.blurred > shape.wrong()    ? Loss::blurred
                        : 2 * shape.terminator > shape.wrong() ? Loss::terminator
                        : 2 * shape.contact > shape.wrong()    ? Loss::contact
                                                               : Loss::other;
    return is_unmatched(input, shape) && reason == loss;
  });
}

std::vector<uint8_t> extra_shapes(const FaultInput& input) {
  const Components components =
      components_of(input, select(input, [&](size_t i) { return input.v[i] < 0.5f; }));
  std::vector<Shape> shapes = measure_overlap(components, input.v, input.r);
  if (!any_unmatched(input, shapes)) return {};
  const std::vector<uint8_t> solid = opened(input, components);
  const size_t width = static_cast<size_t>(input.surface.width);
  for_wrong_pixels(input, components, input.v, input.r, shapes, [&](Shape& shape, size_t i) {
    shape.solid += solid[i];
    if (i % width > 0) count_rim(input, components, i, i - 1, shape);
    if (i % width + 1 < width) count_rim(input, components, i, i + 1, shape);
    if (i >= width) count_rim(input, components, i, i - width, shape);
    if (i + width < solid.size()) count_rim(input, components, i, i + width, shape);
  });
  return pixels_of(input, components, shapes, [&](const Shape& shape) { return is_solid(input, shape); });
}

std::optional<double> median_gap_world(const FaultInput& input, std::span<const uint8_t> gap) {
  const auto spread = spread_of(widest_world(input, gap, components_of(input, gap)));
  return spread ? std::optional(spread->median) : std::nullopt;
}

}  // namespace umbrameter
