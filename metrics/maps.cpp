// SPDX-License-Identifier: Apache-2.0
#include "metrics/maps.h"

#include "metrics/image/nearest_feature.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace umbrameter {
namespace {

void add_width_maps(std::span<const PenumbraProfile> profiles, std::span<const uint8_t> mask, Image& maps) {
  std::vector<uint8_t> is_ridge(maps.pixel_count(), 0);
  std::vector<const PenumbraProfile*> at(maps.pixel_count(), nullptr);
  for (const PenumbraProfile& profile : profiles) {
    if (profile.outcome != ProfileOutcome::accepted) continue;
    is_ridge[profile.pixel(maps.width)] = 1;
    at[profile.pixel(maps.width)] = &profile;
  }
  const std::vector<int32_t> nearest = nearest_feature(is_ridge, maps.width, maps.height);
  for (const char* name : {"width_octaves", "offset_world", "width_known"}) maps.add_plane(name);
  const std::span<float> octaves = maps.plane("width_octaves"), offset = maps.plane("offset_world"),
                         known = maps.plane("width_known");
  for (size_t i = 0; i < nearest.size(); ++i) {
    if (mask[i] == 0 || nearest[i] < 0) continue;
    const PenumbraProfile& profile = *at[static_cast<size_t>(nearest[i])];
    if (distance_px(static_cast<int64_t>(i), nearest[i], maps.width) > profile.reference_width_px) continue;
    octaves[i] = static_cast<float>(profile.width_octaves);
    offset[i] = static_cast<float>(profile.offset_world);
    known[i] = 1.0f;
  }
}

}  // namespace

void add_z_map(const Significance& significance, Image& maps) {
  std::ranges::copy(significance.z, maps.add_plane("z").begin());
}

void add_diagnosis_maps(const DiagnosedImage& diagnosed, std::span<const uint8_t> mask, Image& maps) {
  std::ranges::transform(diagnosed.classes, maps.add_plane("fault_class").begin(),
                         [](FaultClass fault) { return static_cast<float>(fault); });
  add_width_maps(diagnosed.profiles, mask, maps);
}

}  // namespace umbrameter
