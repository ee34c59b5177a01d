// SPDX-License-Identifier: Apache-2.0
// From the reductions to views: a thread per cascade.
#include "ordered_bits.glsl"
#include "sdsm.glsl"

layout(local_size_x = CASCADE_COUNT) in;

/// Of the reduction, along an axis.
vec2 receivers_along(int cascade, int axis) {
  uvec2 bits = receiver_bounds[3 * cascade + axis];  // const: axes
  return vec2(number_of_ordered(bits.x), number_of_ordered(bits.y));
}

/// Wider by what the filter reaches and a texel on either side; at least a share of what is seen.
vec2 with_rim(vec2 bounds, float size_world) {
  const float kLeastShare = 1e-6;  // const: of what is seen; a lone pixel has no width
  float reach_texels = 2.0 + (MAP_FILTER == MAP_FILTER_PCF ? radius_texels : 0.0);
  float inner_texels = max(float(cascade_size) - 2.0 * reach_texels, 1.0);
  float half_width = max(0.5 * (bounds.y - bounds.x), kLeastShare * size_world) * float(cascade_size) / inner_texels;
  float middle = 0.5 * (bounds.x + bounds.y);
  return vec2(middle - half_width, middle + half_width);
}

void main() {
  int cascade = int(gl_LocalInvocationIndex);
  int at = kVectorsPerCascade * cascade;
  vec2 range_world = vec2(number_of_ordered(receiver_range[0].x), number_of_ordered(receiver_range[0].y));
  bool has_receivers = receiver_range[0].x <= receiver_range[0].y;
  vec2 slice = has_receivers ? slice_world(range_world, cascade) : vec2(0.0, kNoEnd);
  bool has_own = receiver_bounds[3 * cascade].x <= receiver_bounds[3 * cascade].y;  // const: axes
  vec2 x = has_own ? receivers_along(cascade, 0) : vec2(0.0, 1.0);
  vec2 y = has_own ? receivers_along(cascade, 1) : vec2(0.0, 1.0);
  vec2 z = has_own ? receivers_along(cascade, 2) : vec2(0.0, 1.0);
  float size_world = has_receivers ? range_world.y : 1.0;
  vec2 across = with_rim(x, size_world);
  vec2 along = with_rim(y, size_world);
  // Casters before the near plane are drawn at it: it must lie before every comparison.
  float margin_world = (z.y - z.x) + (across.y - across.x) + (along.y - along.x);
  cascade_data[at] = vec4(across.x, along.x, across.y, along.y);
  cascade_data[at + 1] = vec4(z.x - margin_world, z.y + margin_world, 1.0, float(cascade_size));
  cascade_data[at + 2] = vec4(slice, 0.0, 0.0);
  cascade_data[at + 3] = vec4(x.x, y.x, z.x, has_own ? 1.0 : 0.0);  // const: the fourth vector
  cascade_data[at + 4] = vec4(x.y, y.y, z.y, has_own ? 1.0 : 0.0);  // const: the fifth vector
}
