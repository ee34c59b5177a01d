// This pixel's surface point and its noise, for fullscreen passes that read gbuffer.position and gbuffer.normal and
// see the view `light`, in techniques with the parameters of the group bias_offsets.
#include "receiver.glsl"
#include "sampling.glsl"

#ifndef RECEIVER_PLANE  // filtered maps hold no single texels to compare the plane with
#define RECEIVER_PLANE 0
#endif

/// False on the background, which has no receiver.
bool fetch_receiver(out Receiver receiver) {
  ivec2 px = ivec2(gl_FragCoord.xy);
  vec4 position = texelFetch(gbuffer_position, px, 0);
  vec3 n_world = texelFetch(gbuffer_normal, px, 0).xyz;
  Bias bias = Bias(bias_world, bias_texels, normal_offset_texels, RECEIVER_PLANE != 0);
  receiver = make_receiver(view_light, position.xyz, n_world, bias);
  return position.w != 0.0;
}

/// Where this pixel reads its noise: fixed for a seed.
vec2 noise_position() {
  return seeded_position(pixel_position(gl_FragCoord.xy, float(frame.screen_and_seed.y)), frame.screen_and_seed.z);
}
