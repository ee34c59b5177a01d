// SPDX-License-Identifier: Apache-2.0
// The light's depth, pushed away by the surface's own slope across a texel.
#include "spaces.glsl"

in float distance_world;

void main() {
  const float kMaxSlope = 10.0;  // const: tangent of the incidence angle; an edge-on triangle's has no bound
  float per_texel = max(abs(dFdx(distance_world)), abs(dFdy(distance_world)));
  float limited = min(per_texel, kMaxSlope * texel_world(VIEW, distance_world));
  gl_FragDepth = depth_of_distance(VIEW, distance_world + slope_bias * limited);
}
