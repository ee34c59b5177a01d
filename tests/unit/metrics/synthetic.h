// SPDX-License-Identifier: Apache-2.0
#pragma once
// Frames of a floor whose visibility is a closed form of the floor point, for testing metrics.

#include "core/image.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

namespace umbrameter::testing {

/// Visibility at the floor point (x, z).
using FloorField = std::function<double(double, double)>;

inline double box_ramp(double s, double width) {
  return std::clamp(0.5 + s / width, 0.0, 1.0);
}

/// Share of a unit disk (diameter `width`) on the lit side of a straight edge.
inline double disk_ramp(double s, double width) {
  const double t = std::clamp(2.0 * s / width, -1.0, 1.0);
  return 0.5 + (t * std::sqrt(1.0 - t * t) + std::asin(t)) / std::numbers::pi;
}

inline std::vector<uint8_t> everywhere(const Image& image) {
  return std::vector<uint8_t>(image.pixel_count(), 1);
}

inline void add_surface_planes(Image& image) {
  for (const char* name :
       {"position.x", "position.y", "position.z", "normal.x", "normal.z", "primitive_id"}) {
    image.add_plane(name, 0.0f);
  }
  image.add_plane("normal.y", 1.0f);
  image.add_plane("unshadowed_irradiance", 1.0f);
}

/// The floor y = 0 from straight above: pixel centres at world (x + .5, y + .5) * pixel_world.
inline Image floor_from_above(int width, int height, double pixel_world) {
  Image image(width, height);
  add_surface_planes(image);
  for (size_t i = 0; i < image.pixel_count(); ++i) {
    const size_t columns = static_cast<size_t>(width);
    image.plane("position.x")[i] = static_cast<float>((static_cast<double>(i % columns) + 0.5) * pixel_world);
    image.plane("position.z")[i] = static_cast<float>((static_cast<double>(i / columns) + 0.5) * pixel_world);
  }
  return image;
}

/// The floor y = 0 in perspective, from 4 above the origin, looking along +z, 30 degrees down, 60 degrees
/// wide.
inline Image floor_in_perspective(int width, int height) {
  Image image(width, height);
  add_surface_planes(image);
  const double half = std::tan(std::numbers::pi / 6.0), c = std::cos(std::numbers::pi / 6.0), s = 0.5;
  for (size_t i = 0; i < image.pixel_count(); ++i) {
    const size_t columns = static_cast<size_t>(width);
    const double u = (2.0 * (static_cast<double>(i % columns) + 0.5) / width - 1.0) * half;
    const double v = (1.0 - 2.0 * (static_cast<double>(i / columns) + 0.5) / height) * half * height / width;
    const double down = s - v * c, ahead = c + v * s;
    const double t = 4.0 / down;
    image.plane("position.x")[i] = static_cast<float>(u * t);
    image.plane("position.z")[i] = static_cast<float>(ahead * t);
    if (down <= 0.0) image.plane("primitive_id")[i] = -1.0f;
  }
  return image;
}

/// `surface` with visibility by `field`, exact or of `samples` binomial light samples.
inline Image lit_floor(const Image& surface, const FloorField& field, int samples = 0, uint64_t seed = 1) {
  Image image = surface;
  std::mt19937_64 random(seed);
  for (const char* name : {"visibility", "half_a", "half_b", "visibility_se"}) image.add_plane(name);
  const auto estimate = [&](double truth, int count) {
    if (count == 0) return truth;
    return static_cast<double>(std::binomial_distribution<int>(count, truth)(random)) / count;
  };
  for (size_t i = 0; i < image.pixel_count(); ++i) {
    const double truth = field(image.plane("position.x")[i], image.plane("position.z")[i]);
    const double a = estimate(truth, samples / 2), b = estimate(truth, samples / 2), v = 0.5 * (a + b);
    image.plane("half_a")[i] = static_cast<float>(a);
    image.plane("half_b")[i] = static_cast<float>(b);
    image.plane("visibility")[i] = static_cast<float>(v);
    if (samples > 0) image.plane("visibility_se")[i] = static_cast<float>(std::sqrt(v * (1.0 - v) / samples));
  }
  return image;
}

}  // namespace umbrameter::testing
