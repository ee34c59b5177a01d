// SPDX-License-Identifier: Apache-2.0
// This pixel's surface point and its noise, for fullscreen passes that read gbuffer.position and gbuffer.normal and
// see the view `light`, in techniques with the parameters of the group bias_offsets.
#include "receiver.glsl"
#include "sampling.glsl"

/// The parameters of the groups bias_offsets and, where single texels are compared, bias.
Bias bias_of_parameters() {
#ifdef BIAS_MODE
  TapBias taps = TapBias(BIAS_MODE == BIAS_MODE_AUTO, auto_scale, RECEIVER_PLANE, cone_bias);
#else
  TapBias taps = TapBias(false, 0.0, kNoPlane, 0.0);  // filtered maps hold no single texels to compare with
#endif
  return Bias(bias_world, bias_texels, normal_offset_texels, NORMAL_OFFSET_FORM, taps);
}

/// The surface point of pixel `px` (GL's rows). False on the background, which has no receiver.
bool fetch_receiver_at(ivec2 px, out Receiver receiver) {
  vec4 position = texelFetch(gbuffer_position, px, 0);
  vec3 n_world = texelFetch(gbuffer_normal, px, 0).xyz;
  receiver = make_receiver(view_light, position.xyz, n_world, bias_of_parameters());
#ifdef BLOCKER_FROM_TRUTH
  receiver.px = px;
#endif
  return position.w != 0.0;
}

bool fetch_receiver(out Receiver receiver) {
  return fetch_receiver_at(ivec2(gl_FragCoord.xy), receiver);
}

/// Where the pixel at `frag_coord` reads its noise: fixed for a seed.
vec2 noise_position_at(vec2 frag_coord) {
  return seeded_position(pixel_position(frag_coord, float(frame.screen_and_seed.y)),
                         frame.screen_and_seed.z);
}

vec2 noise_position() {
  return noise_position_at(gl_FragCoord.xy);
}
