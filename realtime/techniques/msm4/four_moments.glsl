// SPDX-License-Identifier: Apache-2.0
// Four moments of distances t from -1 (near plane) to 1 (nothing there), and the form in which the map holds them.

vec4 powers(float t) { return vec4(t, t * t, t * t * t, t * t * t * t); }

/// The moments of t = 2 z - 1 from those of z.
vec4 over_symmetric_range(vec4 m) {
  float third = 8.0 * m.z - 12.0 * m.y + 6.0 * m.x - 1.0;                      // const: binomials
  float fourth = 16.0 * m.w - 32.0 * m.z + 24.0 * m.y - 8.0 * m.x + 1.0;       // const: binomials
  return vec4(2.0 * m.x - 1.0, 4.0 * (m.y - m.x) + 1.0, third, fourth);        // const: binomials
}

/// Combinations of the powers of z, a column each, that use all of 16 bits (Peters and Klein 2015, supplement).
const mat4 kEncode2015 = mat4(
    vec4(-2.07224649, 13.7948857237, 0.105877704, 9.7924062118),          // const: as published
    vec4(32.23703778, -59.4683975703, -1.9077466311, -33.7652110555),     // const: as published
    vec4(-68.571074599, 82.0359750338, 9.3496555107, 47.9456096605),      // const: as published
    vec4(39.3703274134, -35.364903257, -6.6543490743, -23.9728048165));   // const: as published
const mat4 kDecode2015 = mat4(
    vec4(0.2227744146, 0.1549679261, 0.1451988946, 0.163127443),          // const: as published, its inverse
    vec4(0.0771972861, 0.1394629426, 0.2120202157, 0.2591432266),         // const: as published
    vec4(0.7926986636, 0.7963415838, 0.7258694464, 0.6539092497),         // const: as published
    vec4(0.0319417555, -0.1722823173, -0.2758014811, -0.3376131734));     // const: as published
const vec4 kOffset2015 = vec4(0.035955884801, 0.0, 0.0, 0.0);             // const: keeps the first channel above 0

/// The same of the moments from -1 to 1, odd and even ones apart (Peters et al. 2017, supplement).
const mat2 kOdd2017 = mat2(1.5, 0.8660254037844386, -2.0, -0.3849001794597505);  // const: 3/2, 3^.5/2, -2, -12^.5/9
const mat2 kEven2017 = mat2(4.0, 0.5, -4.0, 0.5);                                // const: as published

/// What the map holds of the normalised distance `z`; affine in the moments, so that blurs commute with it.
vec4 encoded(float z) {
  if (MOMENT_FORMAT == MOMENT_FORMAT_RGBA32F) return powers(2.0 * z - 1.0);
  if (QUANTISATION == QUANTISATION_NONE) return powers(z);
  if (QUANTISATION == QUANTISATION_PETERS_KLEIN_2015)
    return kEncode2015 * powers(z) + kOffset2015;
  vec4 m = powers(2.0 * z - 1.0);
  vec2 odd = kOdd2017 * m.xz + 0.5;
  vec2 even = kEven2017 * m.yw;
  return vec4(odd.x, even.x, odd.y, even.y);
}

/// The moments over [-1, 1] of what was blurred.
vec4 decoded(vec4 held) {
  if (MOMENT_FORMAT == MOMENT_FORMAT_RGBA32F) return held;
  if (QUANTISATION == QUANTISATION_NONE) return over_symmetric_range(held);
  if (QUANTISATION == QUANTISATION_PETERS_KLEIN_2015)
    return over_symmetric_range(kDecode2015 * (held - kOffset2015));
  vec2 odd = inverse(kOdd2017) * (held.xz - 0.5);
  vec2 even = inverse(kEven2017) * held.yw;
  return vec4(odd.x, even.x, odd.y, even.y);
}
