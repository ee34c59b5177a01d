// SPDX-License-Identifier: Apache-2.0
#pragma once
// A floor with everything the fault classes ask for, from straight above: 256 x 128 px of 0.01, lit until a test
// says otherwise.

#include "metrics/faults/faults.h"
#include "tests/unit/metrics/synthetic.h"

#include <utility>

namespace umbrameter::testing {

inline constexpr int kFloorWidth = 256, kFloorHeight = 128;
inline constexpr double kFloorPixel = 0.01;

inline size_t floor_at(int x, int y) {
  return static_cast<size_t>(y * kFloorWidth + x);
}

/// Blockers of one layer, 3 above, wherever the floor is not fully lit.
inline Image fault_floor(const FloorField& visibility) {
  Image image = lit_floor(floor_from_above(kFloorWidth, kFloorHeight, kFloorPixel), visibility);
  image.add_plane("shading_normal.x");
  image.add_plane("shading_normal.y", 1.0f);
  image.add_plane("shading_normal.z");
  const std::span<float> distance = image.add_plane("blocker_distance_min");
  const std::span<float> layers = image.add_plane("blocker_layers");
  const auto v = std::as_const(image).plane("visibility");
  for (size_t i = 0; i < v.size(); ++i) {
    distance[i] = v[i] < 1.0f ? 3.0f : 0.0f;
    layers[i] = v[i] < 1.0f ? 1.0f : 0.0f;
  }
  return image;
}

/// A map whose texels are squares of `texel_px` pixels along the picture's axes.
inline void add_map(Image& image, double texel_px) {
  const std::span<float> u = image.add_plane("texel.x"), v = image.add_plane("texel.y");
  image.add_plane("texel_world", static_cast<float>(texel_px * kFloorPixel));
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const size_t i = static_cast<size_t>(y) * static_cast<size_t>(image.width) + static_cast<size_t>(x);
      u[i] = static_cast<float>((x + 0.5) / texel_px);
      v[i] = static_cast<float>((y + 0.5) / texel_px);
    }
  }
}

template <class Body>
size_t for_floor_rectangle(int x0, int y0, int x1, int y1, const Body& body) {
  size_t pixels = 0;
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x, ++pixels) body(floor_at(x, y));
  }
  return pixels;
}

inline Faults classify_floor(const Image& test, const Image& reference, const FaultSettings& settings = {}) {
  const std::vector<uint8_t> mask = everywhere(reference);
  const PenumbraError penumbra = measure_penumbra(test, reference, mask);
  const Envelope envelope = measure_envelope(test, reference, mask, penumbra.profiles);
  return classify_faults(test, reference, mask, penumbra.profiles, envelope, settings);
}

}  // namespace umbrameter::testing
