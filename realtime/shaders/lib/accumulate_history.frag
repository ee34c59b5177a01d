// SPDX-License-Identifier: Apache-2.0
// The mean of this frame's visibility, `current`, and of earlier frames', found again where the surface was then, for techniques
// with the parameters of the group history.

struct History {
  float visibility;
  float frames;  // that its mean is of; 0: none
};

/// Width of a pixel in the world, facing the camera, at a point of the frame before.
float pixel_world(vec4 clip) {
  mat4 m = history.previous_clip_from_world;
  float tan_half_height = 1.0 / length(vec3(m[0][1], m[1][1], m[2][1]));
  return 2.0 * tan_half_height * clip.w / float(frame.screen_and_seed.y);
}

/// Whether pixel `px` of the frame before showed this surface: no farther off its plane than so many pixels, nor turned.
bool shows_same(ivec2 px, vec3 p_world, vec3 n_world, float px_world) {
  if (any(lessThan(px, ivec2(0))) || any(greaterThanEqual(px, frame.screen_and_seed.xy))) return false;
  vec4 position = texelFetch(previous_gbuffer_position, px, 0);
  if (position.w == 0.0) return false;
  if (abs(dot(n_world, position.xyz - p_world)) > reject_plane_px * px_world) return false;
  return distance(n_world, texelFetch(previous_gbuffer_normal, px, 0).xyz) <= reject_normal;
}

/// What the frame before left of a point, blended over those of the four pixels around it that showed its surface.
History history_of(vec3 p_world, vec3 n_world) {
  History none = History(1.0, 0.0);
  vec4 clip = history.previous_clip_from_world * vec4(p_world, 1.0);
  if (history.frame.x == 0 || clip.w <= 0.0) return none;
  vec2 p_px = (0.5 + 0.5 * clip.xy / clip.w) * vec2(frame.screen_and_seed.xy) - 0.5;
  p_px = floor(p_px * 256.0 + 0.5) / 256.0;  // const: as samplers round, so that what stands still stays in its pixel
  vec2 low = floor(p_px);
  vec2 share = p_px - low;
  float px_world = pixel_world(clip);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 4; ++i) {  // const: the corners of a square
    ivec2 corner = ivec2(i & 1, i >> 1);
    vec2 weights = mix(1.0 - share, share, vec2(corner));
    float weight = weights.x * weights.y;
    ivec2 px = ivec2(low) + corner;
    if (weight == 0.0 || !shows_same(px, p_world, n_world, px_world)) continue;
    vec2 before = texelFetch(previous_mean, px, 0).rg;
    if (before.g > 0.0) sum += weight * vec3(before, 1.0);
  }
  return sum.z > 0.0 ? History(sum.x / sum.z, sum.y / sum.z) : none;
}

/// Within what the 3 x 3 pixels around this one show now: their range (Karis 2014), or so many of their standard deviations
/// around their mean (Salvi 2016).
float limited(float visibility) {
  if (HISTORY_LIMIT == HISTORY_LIMIT_NONE) return visibility;
  ivec2 px = ivec2(gl_FragCoord.xy);
  const int kSide = 3;                 // const: as published
  const float kPixels = float(kSide * kSide);
  float low = 1.0, high = 0.0, sum = 0.0, sum_squares = 0.0;
  for (int i = 0; i < kSide * kSide; ++i) {
    ivec2 near = clamp(px + ivec2(i % kSide, i / kSide) - 1, ivec2(0), frame.screen_and_seed.xy - 1);
    float v = texelFetch(current, near, 0).r;
    low = min(low, v), high = max(high, v), sum += v, sum_squares += v * v;
  }
  if (HISTORY_LIMIT == HISTORY_LIMIT_RANGE) return clamp(visibility, low, high);
  float mean = sum / kPixels;
  float spread = limit_deviations * sqrt(max(0.0, sum_squares / kPixels - mean * mean));
  return clamp(visibility, mean - spread, mean + spread);
}

void main() {
  ivec2 px = ivec2(gl_FragCoord.xy);
  vec4 position = texelFetch(gbuffer_position, px, 0);
  out_visibility = 1.0;
  out_mean = vec2(1.0, 0.0);
  if (position.w == 0.0) return;
  float now = texelFetch(current, px, 0).r;
  History before = history_of(position.xyz, texelFetch(gbuffer_normal, px, 0).xyz);
  float frames = min(before.frames + 1.0, float(history_frames));
  float earlier = before.frames > 0.0 ? limited(before.visibility) : now;
  out_visibility = mix(earlier, now, 1.0 / frames);
  out_mean = vec2(out_visibility, frames);
}
