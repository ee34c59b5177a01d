// SPDX-License-Identifier: Apache-2.0
// The views that the fit has stored, as blocks of views elsewhere hold them.
#include "sdsm.glsl"

vec2 slice_of_cascade(int cascade) { return cascade_data[kVectorsPerCascade * cascade + 2].xy; }

/// Reversed depth: 1 at the near plane, 0 at the far one.
mat4 clip_from_light(vec4 bounds, vec2 depth_world) {
  vec2 scale = 2.0 / (bounds.zw - bounds.xy);
  vec2 shift = -0.5 * scale * (bounds.xy + bounds.zw);
  float depth_scale = -1.0 / (depth_world.y - depth_world.x);
  return mat4(vec4(scale.x, 0.0, 0.0, 0.0), vec4(0.0, scale.y, 0.0, 0.0), vec4(0.0, 0.0, depth_scale, 0.0),
              vec4(shift, -depth_scale * depth_world.y, 1.0));
}

LightViewData view_of_cascade(int cascade) {
  vec4 bounds = cascade_data[kVectorsPerCascade * cascade];
  vec4 depth = cascade_data[kVectorsPerCascade * cascade + 1];
  return LightViewData(sun_from_world(), clip_from_light(bounds, depth.xy), bounds, depth,
                       cascade_data[kVectorsPerCascade * cascade + 2]);
}
