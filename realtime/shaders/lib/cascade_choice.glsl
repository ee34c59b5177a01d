// SPDX-License-Identifier: Apache-2.0
// Which cascade answers for a pixel. For fullscreen passes that read gbuffer.position and gbuffer.normal, in techniques with
// the parameter cascade_blend. What includes this has CASCADES, view_of_cascade() and slice_of_cascade(); the technique says
// what a map answers: visibility_of().
#include "map_array.glsl"
#include "pixel.glsl"

/// What the chosen cascade's map says of a receiver.
float visibility_of(Receiver receiver);

/// Distance along the camera's axis.
float camera_distance(vec3 p_world) { return (frame.clip_from_world * vec4(p_world, 1.0)).w; }

/// The first cascade whose slice goes that far; their number beyond the last one.
int cascade_at(float distance_world) {
  int cascade = 0;
  while (cascade < CASCADES && distance_world > slice_of_cascade(cascade).y) ++cascade;
  return cascade;
}

/// 0 where the cascade is alone; from there it rises to 1 at the end of its slice, where only the next one goes on.
float share_of_next(int cascade, float distance_world) {
  if (cascade + 1 >= CASCADES) return 0.0;
  float from = slice_of_cascade(cascade + 1).x;
  float to = slice_of_cascade(cascade).y;
  return to > from ? clamp((distance_world - from) / (to - from), 0.0, 1.0) : 0.0;
}

float visibility_in(int cascade) {
  map_layer = cascade;
  view_light = view_of_cascade(cascade);
  Receiver receiver;
  fetch_receiver(receiver);
  return visibility_of(receiver);
}

float cascaded_visibility(float distance_world) {
  int cascade = cascade_at(distance_world);
  if (cascade == CASCADES) return 1.0;
  float share = share_of_next(cascade, distance_world);
  if (CASCADE_BLEND == CASCADE_BLEND_DITHER) {
    bool takes_next = interleaved_gradient_noise(noise_position().yx) < share;
    return visibility_in(takes_next ? cascade + 1 : cascade);
  }
  float visibility = visibility_in(cascade);
  if (CASCADE_BLEND == CASCADE_BLEND_NONE || share == 0.0) return visibility;
  return mix(visibility, visibility_in(cascade + 1), share);
}

void main() {
  vec4 position = texelFetch(gbuffer_position, ivec2(gl_FragCoord.xy), 0);
  out_visibility = position.w != 0.0 ? cascaded_visibility(camera_distance(position.xyz)) : 1.0;
}
