// SPDX-License-Identifier: Apache-2.0
// The cascades as the fit leaves them, five vectors each: lateral bounds; near, far, 1, texels a side; the slice's ends; and,
// for people who look, the least and greatest receiver in light space, w = 1 where there is one.

const int kVectorsPerCascade = 5;  // const: the list above
const float kNoEnd = 1e30;         // const: farther than anything

/// World to light space: the sun's axes, with distances from the world's origin.
mat4 sun_from_world() {
  return transpose(mat4(vec4(frame.light_tangent_world.xyz, 0.0), vec4(frame.light_bitangent_world.xyz, 0.0),
                        vec4(frame.light_direction_world.xyz, 0.0), vec4(0.0, 0.0, 0.0, 1.0)));
}

/// Where `step` of CASCADE_COUNT steps from the nearest to the farthest receiver end (Zhang et al. 2006).
float split_world(vec2 range_world, float step) {
  float share = max(0.0, step) / float(CASCADE_COUNT);
  float even = mix(range_world.x, range_world.y, share);
  return mix(even, range_world.x * pow(range_world.y / range_world.x, share), split_lambda);
}

/// Distances along the camera's axis. The last slice has no end, so that rounding leaves no receiver out.
vec2 slice_world(vec2 range_world, int cascade) {
  return vec2(split_world(range_world, float(cascade) - cascade_overlap),
              cascade + 1 == CASCADE_COUNT ? kNoEnd : split_world(range_world, float(cascade) + 1.0));
}
