// SPDX-License-Identifier: Apache-2.0
#include "results/tune/tuning.h"

namespace umbrameter {

namespace {

constexpr double kShare = 1e-3;    // of scored pixels
constexpr double kOctaves = 0.25;  // of a penumbra's width

}  // namespace

double tolerance_of(WindowKind kind) {
  return kind == WindowKind::bias ? kShare : kOctaves;
}

std::optional<double> in_texels(const std::string& unit, double length, double texel_world) {
  if (unit == "texels") return length;
  return unit == "world" && texel_world > 0.0 ? std::optional(length / texel_world) : std::nullopt;
}

std::optional<double> in_world_units(const std::string& unit, double length, double texel_world) {
  if (unit == "world") return length;
  return unit == "texels" && texel_world > 0.0 ? std::optional(length * texel_world) : std::nullopt;
}

}  // namespace umbrameter
