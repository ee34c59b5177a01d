// SPDX-License-Identifier: Apache-2.0
// The least share of a distribution with four given moments that lies before a distance: three points, one of them at the
// distance itself, have these moments, and no distribution has less before it (Peters and Klein 2015, algorithm 3). Here
// about the mean, where fewer digits cancel.

/// Roots r.x <= r.y of a x^2 + b x + c.
vec2 roots(float a, float b, float c) {
  float safe = abs(a) < 1e-20 ? 1e-20 : a;  // const: one root far away
  float root = sqrt(max(0.0, b * b - 4.0 * safe * c));  // const: the formula for roots
  float q = -0.5 * (b < 0.0 ? b - root : b + root);
  vec2 both = vec2(q / safe, q == 0.0 ? 0.0 : c / q);
  return vec2(min(both.x, both.y), max(both.x, both.y));
}

/// Before `t`, for the moments `m` of t, t^2, t^3, t^4.
float least_share_before(vec4 m, float t) {
  const float kRounding = 1e-7;  // const: of floats about 1; more of the even moments are still moments of something
  float mean2 = m.x * m.x;
  float variance = max(m.y - mean2, kRounding);
  float third = m.z - m.x * (3.0 * m.y - 2.0 * mean2);                             // const: binomials
  float fourth = m.w - m.x * (4.0 * m.z - 6.0 * m.x * m.y + 3.0 * m.x * mean2);    // const: binomials
  float skew = third / variance;
  float rest = max(fourth - variance * variance - skew * third, kRounding);
  float x = t - m.x;
  // The other two points are where 1 + x u / variance + p(x) p(u) / rest = 0, p(u) = u^2 - skew u - variance.
  float a = (x * x - skew * x - variance) / rest;
  vec2 u = roots(a, x / variance - a * skew, 1.0 - a * variance);
  if (x <= u.x) return 0.0;
  if (x <= u.y) return (x * u.y + variance) / ((u.y - u.x) * (x - u.x));
  return 1.0 - (u.x * u.y + variance) / ((x - u.x) * (x - u.y));
}
