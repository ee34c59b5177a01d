// SPDX-License-Identifier: Apache-2.0
// Variance shadow maps (Donnelly and Lauritzen 2006) over a map that was blurred once.
#include "filtered_plane.glsl"
#include "footprint.glsl"
#include "pixel.glsl"
#include "variance_bound.glsl"

/// The mean over a pixel's extents in the map, in [0,1]: reads along the longer one, each a level's bilinear read as wide
/// as its share of it or as the shorter one.
vec2 mean_over(vec2 uv, vec2 one, vec2 other) {
  vec2 longer = length(one) > length(other) ? one : other;
  float long_texels = max(1.0, length(longer) * moments_size.x);
  float short_texels = max(1.0, min(length(one), length(other)) * moments_size.x);
  int reads = clamp(int(ceil(long_texels / short_texels)), 1, MIP_ANISOTROPY);
  float level = log2(max(long_texels / float(reads), short_texels));
  vec2 sum = vec2(0.0);
  for (int i = 0; i < reads; ++i) {
    sum += textureLod(moments, uv + ((float(i) + 0.5) / float(reads) - 0.5) * longer, level).rg;
  }
  return sum / float(reads);
}

vec2 filtered_moments(vec2 uv) {
  if (MIP_ANISOTROPY == 0) return texture(moments, uv).rg;
  ivec2 px = ivec2(gl_FragCoord.xy);
  vec3 p_world = texelFetch(gbuffer_position, px, 0).xyz;
  vec3 n_world = texelFetch(gbuffer_normal, px, 0).xyz;
  vec2 beside = uv_change(view_light, p_world, n_world, vec2(1.0, 0.0));
  vec2 above = uv_change(view_light, p_world, n_world, vec2(0.0, 1.0));
  return mean_over(uv, beside, above);
}

float visibility_of(Receiver receiver) {
  float known;
  if (is_known(view_light, receiver, known)) return known;
  receiver.bias_world += plane_bias_world(view_light, receiver, filter_width_texels);
  vec2 uv = texel_position(view_light, receiver.lateral) * moments_size.zw;
  return variance_visibility(view_light, receiver, filtered_moments(uv));
}

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}
