// SPDX-License-Identifier: Apache-2.0
const int kSun = 3;  // const: FrameData.light_type

/// From the light's centre to a point, or the direction of the sun's light.
vec3 from_light(vec3 p_world) {
  return frame.light_type.x == kSun ? frame.light_direction_world.xyz : p_world - frame.light_center_world.xyz;
}
