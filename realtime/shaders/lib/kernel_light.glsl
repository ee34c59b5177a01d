// SPDX-License-Identifier: Apache-2.0
// The light that kernels follow, for techniques with the parameter of the group light_size.
#include "area_light.glsl"

AreaLight kernel_light() {
  return AreaLight(frame.light_type.x, light_size_scale * frame.light_extent.xy, light_size_scale);
}

AreaLight widened(AreaLight light, float by) { return AreaLight(light.type, by * light.half_extent, by * light.scale); }
