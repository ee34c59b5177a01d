// SPDX-License-Identifier: Apache-2.0
// Point patterns, the GLSL side of core/sampling/patterns.h.

const float kGoldenAngleRad = 2.399963229728653;  // const: pi (3 - sqrt 5)
const float kTwoPi = 6.283185307179586;           // const: 2 pi

/// Point `index` of `count` on the unit disk, uniform in area (Vogel 1979).
vec2 vogel_disk(int index, int count, float rotation_rad) {
  float radius = sqrt((float(index) + 0.5) / float(count));
  float angle_rad = float(index) * kGoldenAngleRad + rotation_rad;
  return radius * vec2(cos(angle_rad), sin(angle_rad));
}

/// Interleaved gradient noise in [0,1) (Jimenez 2014).
float interleaved_gradient_noise(vec2 p_px) {
  // const: the published coefficients
  return fract(52.9829189 * fract(dot(p_px, vec2(0.06711056, 0.00583715))));
}

/// The pixel position whose noise belongs to a seed: 5.588238 px a step keeps the pattern's neighbourhoods
/// stratified over successive seeds (Jimenez 2014). Sixty-four seeds before it repeats.
vec2 seeded_position(vec2 p_px, int seed) {
  return p_px + 5.588238 * float(seed & 63);  // const: the published step; 64 patterns
}

/// Point `index` of `count` of the Hammersley set in [0,1)^2: ((i + .5) / n, bit-reversed i).
vec2 hammersley(int index, int count) {
  uint reversed = bitfieldReverse(uint(index));
  return vec2((float(index) + 0.5) / float(count), float(reversed >> 8) * exp2(-24.0));  // const: 24 bits fit a float
}

/// Area-preserving map from [0,1)^2 to the unit disk (Shirley and Chiu 1997).
vec2 concentric_disk(vec2 uv) {
  vec2 p = 2.0 * uv - 1.0;
  if (p == vec2(0.0)) return vec2(0.0);
  bool x_wide = abs(p.x) > abs(p.y);
  float radius = x_wide ? p.x : p.y;
  float eighth = kTwoPi / 8.0;  // const: an eighth of a turn
  float angle_rad = x_wide ? eighth * (p.y / p.x) : 2.0 * eighth - eighth * (p.x / p.y);
  return radius * vec2(cos(angle_rad), sin(angle_rad));
}
