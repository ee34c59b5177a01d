// SPDX-License-Identifier: Apache-2.0
// The band of every texel of the shadow map, before bands are dilated: 0 none, 1/3, 2/3, 1.
#include "edge_filter.glsl"
#include "kernel_light.glsl"

/// Width, in texels, of the box whose filter is the penumbra of a step between two distances: the light's width seen
/// through the step, W (1/z_near - 1/z_far) in tan space, 2 tan a (z_far - z_near) under a sun (TECHNIQUES 2.11, 2.12).
float penumbra_texels(LightViewData view, float z_near, float z_far) {
  vec2 half_extent = kernel_light().half_extent;
  float share = frame.light_type.x == kRect ? 1.0 : 0.9;  // const: half width of the box that is most like a unit disk
  float width = 2.0 * share * sqrt(half_extent.x * half_extent.y);
  float spread = is_orthographic(view) ? z_far - z_near : 1.0 / z_near - 1.0 / z_far;
  return width * spread / texel_lateral(view);
}

float physical_strength(ivec2 texel) {
  float z = edge_value(shadow_map, view_light, texel, false);
  float height = limited_step_height(shadow_map, view_light, texel);
  if (FAR_SIDE_ONLY != 0 && height < 0.0) return 0.0;
  float z_other = max(view_light.depth_range.x, z - height);
  return penumbra_texels(view_light, min(z, z_other), max(z, z_other));
}

/// The step as a share of the way from the nearest caster to its far side.
float drop_strength(ivec2 texel) {
  float height = step_height(shadow_map, view_light, texel, false);
  float z_far = edge_value(shadow_map, view_light, texel, false) + max(0.0, -height);
  return edge_strength(height) / max(z_far - view_light.depth_range.x, 1e-20);  // const: nothing before the surface
}

float strength_of(ivec2 texel) {
  if (CALIBRATION == CALIBRATION_PHYSICAL) return physical_strength(texel);
  if (CALIBRATION == CALIBRATION_DROP) return drop_strength(texel);
  return edge_strength(step_height(shadow_map, view_light, texel, true));
}

float band_of(float strength, vec3 least) {
  float band = 0.0;
  for (int i = 0; i < 3; ++i) {  // const: bands
    if (strength >= least[i]) band = float(i + 1);
  }
  return band / 3.0;  // const: bands
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec3 widths = CALIBRATION == CALIBRATION_PHYSICAL ? vec3(width_1_texels, width_2_texels, width_3_texels) : vec3(1.0);
  out_mask = band_of(strength_of(texel), vec3(threshold_1, threshold_2, threshold_3) * widths);
}
