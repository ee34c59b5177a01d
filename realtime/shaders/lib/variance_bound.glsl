// A receiver behind filtered moments, for techniques with the parameters of the group moments.
#include "moments.glsl"
#include "receiver.glsl"

float variance_visibility(LightViewData view, Receiver receiver, vec2 moments) {
  float z = normalized_distance(view, receiver.p_light.z - receiver.bias_world);
  float min_deviation = normalized_length(view, min_deviation_world);
  return without_bleeding(chebyshev(moments, z, min_deviation * min_deviation), bleed_reduction);
}
