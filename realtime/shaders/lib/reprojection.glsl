// SPDX-License-Identifier: Apache-2.0
// Where the frame before showed a surface point, for passes that read gbuffer.position, gbuffer.normal and both of the frame before, in
// techniques with the parameters reject_plane_px and reject_normal.

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

/// The four pixels of the frame before around a point, and how much each counts: by bilinear weights, 0 where it showed another
/// surface.
struct Reprojected {
  ivec2 low;  // the lowest of them
  vec4 weights;
};

const int kAround = 4;  // const: the corners of a square

ivec2 pixel_around(Reprojected at, int corner) { return at.low + ivec2(corner & 1, corner >> 1); }

/// All weights are 0 where nothing was before.
Reprojected reproject(vec3 p_world, vec3 n_world) {
  Reprojected at = Reprojected(ivec2(0), vec4(0.0));
  vec4 clip = history.previous_clip_from_world * vec4(p_world, 1.0);
  if (history.frame.x == 0 || clip.w <= 0.0) return at;
  vec2 p_px = (0.5 + 0.5 * clip.xy / clip.w) * vec2(frame.screen_and_seed.xy) - 0.5;
  p_px = floor(p_px * 256.0 + 0.5) / 256.0;  // const: as samplers round, so that what stands still stays in its pixel
  vec2 low = floor(p_px);
  vec2 share = p_px - low;
  float px_world = pixel_world(clip);
  at.low = ivec2(low);
  for (int i = 0; i < kAround; ++i) {
    vec2 weights = mix(1.0 - share, share, vec2(i & 1, i >> 1));
    float weight = weights.x * weights.y;
    if (weight > 0.0 && shows_same(pixel_around(at, i), p_world, n_world, px_world)) at.weights[i] = weight;
  }
  return at;
}
