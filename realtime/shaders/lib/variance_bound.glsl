// SPDX-License-Identifier: Apache-2.0
// A receiver behind filtered moments, for techniques with the parameters of the group moments.
#include "moments.glsl"
#include "receiver.glsl"

/// Smallest variance that is believed about `distance_world`, of normalised distances.
float least_variance(LightViewData view, float distance_world) {
  float from_world = normalized_length(view, min_deviation_world, distance_world);
  float range = normalized_range(view);
  return max(from_world * from_world, min_variance_of_range * range * range);
}

float variance_visibility(LightViewData view, Receiver receiver, vec2 moments) {
  float z = normalized_distance(view, receiver.p_light.z - receiver.bias_world);
  return without_bleeding(chebyshev(moments, z, least_variance(view, receiver.p_light.z)), bleed_reduction);
}
