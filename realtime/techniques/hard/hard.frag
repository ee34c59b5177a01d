// Hard shadow map (Williams 1978): lit unless the map holds something nearer to the light.
#include "shadow_map.glsl"

void main() {
  ivec2 px = ivec2(gl_FragCoord.xy);
  vec4 position = texelFetch(gbuffer_position, px, 0);
  vec3 n_world = texelFetch(gbuffer_normal, px, 0).xyz;
  Bias bias = Bias(bias_world, bias_texels, normal_offset_texels, RECEIVER_PLANE != 0);
  Receiver receiver = make_receiver(view_light, position.xyz, n_world, bias);
  bool is_background = position.w == 0.0;
  out_visibility = is_background ? 1.0 : hard_visibility(shadow_map, view_light, receiver);
}
