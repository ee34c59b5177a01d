// SPDX-License-Identifier: Apache-2.0
// Six moments of distances t from -1 (near plane) to 1 (nothing there), and the form in which three maps hold them. Odd and
// even ones lie apart: each map has one of either.

struct Moments {
  vec3 odd;   // t, t^3, t^5
  vec3 even;  // t^2, t^4, t^6
};

/// Combinations, a column each, that use all of 16 bits (Muenstermann et al. 2018, code).
const mat3 kOdd = mat3(vec3(2.5, -1.87499864450, 1.26583039016),      // const: as published
                       vec3(-10.0, 4.20757543111, -1.47644882902),    // const: as published
                       vec3(8.0, -1.83257678661, 0.71061660238));     // const: as published
const mat3 kEven = mat3(vec3(4.0, 9.0, -0.57759806484),               // const: as published
                        vec3(-4.0, -24.0, 4.61936647543),             // const: as published
                        vec3(0.0, 16.0, -3.07953906655));             // const: as published
const vec3 kEvenOffset = vec3(0.0, 0.0, 0.018888946);                 // const: as published; keeps the last channel above 0

Moments moments_of(float z) {
  float t = 2.0 * z - 1.0;
  float square = t * t;
  return Moments(t * vec3(1.0, square, square * square), square * vec3(1.0, square, square * square));
}

/// What the maps hold of the normalised distance `z`; affine in the moments, so that blurs commute with it.
Moments encoded(float z) {
  Moments m = moments_of(z);
  if (MOMENT_FORMAT == MOMENT_FORMAT_RG32F) return m;
  return Moments(kOdd * m.odd + 0.5, kEven * m.even + kEvenOffset);
}

/// The moments of what was blurred.
Moments decoded(Moments held) {
  if (MOMENT_FORMAT == MOMENT_FORMAT_RG32F) return held;
  return Moments(inverse(kOdd) * (held.odd - 0.5), inverse(kEven) * (held.even - kEvenOffset));
}

/// Of a distribution about the middle of the range, mixed in (Muenstermann et al. 2018, code).
Moments biased(Moments m, float share) {
  const vec3 kOf32Bits = vec3(0.48, 0.451, 0.45);             // const: as published
  const vec3 kOf16Bits = vec3(0.5566, 0.489, 0.47869382);     // const: as published
  vec3 even = MOMENT_FORMAT == MOMENT_FORMAT_RG32F ? kOf32Bits : kOf16Bits;
  return Moments((1.0 - share) * m.odd, mix(m.even, even, share));
}
