// SPDX-License-Identifier: Apache-2.0
// The least share of a distribution with six given moments that lies before a distance: four points, one of them at the
// distance itself, have these moments, and no distribution has less before it (Peters et al. 2017). Here about the mean.

/// Central moments 2 to 6.
struct Central {
  float second, third, fourth, fifth, sixth;
};

Central about_mean(Moments m) {
  float c = m.odd.x;
  float c2 = c * c;
  Central central;
  central.second = m.even.x - c2;
  central.third = m.odd.y - c * (3.0 * m.even.x - 2.0 * c2);  // const: binomials
  central.fourth = m.even.y - c * (4.0 * m.odd.y - c * (6.0 * m.even.x - 3.0 * c2));  // const: binomials
  // const: binomials
  central.fifth = m.odd.z - c * (5.0 * m.even.y - c * (10.0 * m.odd.y - c * (10.0 * m.even.x - 4.0 * c2)));
  // const: binomials
  central.sixth = m.even.z - c * (6.0 * m.odd.z - c * (15.0 * m.even.y - c * (20.0 * m.odd.y - c * (15.0 * m.even.x - 5.0 * c2))));
  return central;
}

/// The polynomial (1, u, u^2, u^3 a component each) that is orthogonal to all lower ones about `x`: its roots are the other three
/// points. It solves B p = (1, x, x^2, x^3) for the Hankel matrix B of the moments, by B = L D L^T.
vec4 kernel_polynomial(Central m, float x) {
  const float kLeast = 1e-10;  // const: below what the bias leaves
  float d1 = max(m.second, kLeast);
  float l21 = m.third / d1;
  float l31 = m.fourth / d1;
  float d2 = max(m.fourth - m.second * m.second - m.third * l21, kLeast);
  float l32 = (m.fifth - m.second * m.third - m.fourth * l21) / d2;
  float d3 = max(m.sixth - m.third * m.third - m.fourth * l31 - d2 * l32 * l32, kLeast);
  float y2 = x * x - m.second - l21 * x;
  float y3 = x * x * x - m.third - l31 * x - l32 * y2;
  vec4 p;
  p.w = y3 / d3;
  p.z = y2 / d2 - l32 * p.w;
  p.y = x / d1 - l21 * p.z - l31 * p.w;
  p.x = 1.0 - m.second * p.z - m.third * p.w;
  return p;
}

float apart(float difference) {
  const float kLeast = 1e-9;  // const: two points in one place
  return abs(difference) < kLeast ? kLeast : difference;
}

/// The root of p.x + p.y u + p.z u^2 + p.w u^3 that is farthest from 0, where all are real: a cosine, and Newton's method for the digits
/// that drivers' arc cosines lack.
float farthest_root(vec4 p) {
  const float kFlat = 1e-20;               // const: one root far away
  const float kThird = 1.0 / 3.0;          // const: of a cubic
  const float kTurn = 2.0943951023931953;  // const: a third of a turn
  const int kSteps = 2;
  vec3 q = p.xyz * vec3(1.0, kThird, kThird) / (abs(p.w) < kFlat ? kFlat : p.w);  // u^3 + 3 q.z u^2 + 3 q.y u + q.x
  float spread = max(q.z * q.z - q.y, 0.0);                 // v^3 - 3 spread v + rest for v = u + q.z
  float rest = q.x - q.z * (3.0 * q.y - 2.0 * q.z * q.z);   // const: binomials
  float radius = sqrt(spread);
  float angle = acos(clamp(-0.5 * rest / max(spread * radius, 1e-30), -1.0, 1.0)) * kThird;  // const: all in one place
  vec3 u = 2.0 * radius * cos(vec3(angle, angle - kTurn, angle + kTurn)) - q.z;
  float root = abs(u.x) > abs(u.y) ? u.x : u.y;
  root = abs(root) > abs(u.z) ? root : u.z;
  for (int step = 0; step < kSteps; ++step) {
    float slope = p.y + root * (2.0 * p.z + root * 3.0 * p.w);  // const: of a cubic
    if (slope != 0.0) root -= (p.x + root * (p.y + root * (p.z + root * p.w))) / slope;
  }
  return root;
}

/// All three. What is left without the farthest keeps the digits of the other two, however far that one is.
vec3 three_roots(vec4 p) {
  const float kFlat = 1e-20;  // const: one root far away
  float far = farthest_root(p);
  float c = p.x;
  float b = p.y + c / far;
  float a = p.z + b / far;
  float root = sqrt(max(0.0, b * b - 4.0 * a * c));  // const: the formula for roots
  float q = -0.5 * (b < 0.0 ? b - root : b + root);
  return vec3(q / (abs(a) < kFlat ? kFlat : a), q == 0.0 ? 0.0 : c / q, far);
}

/// Before `t`: the mean of the cubic that is 1 in the points before it and 0 in the others and at `t` itself.
float least_share_before(Moments moments, float t) {
  Central m = about_mean(moments);
  float x = t - moments.odd.x;
  vec3 u = three_roots(kernel_polynomial(m, x));
  vec3 is_before = vec3(lessThan(u, vec3(x)));
  float d01 = is_before.x / apart(u.x - x);
  float d12 = (is_before.y - is_before.x) / apart(u.y - u.x);
  float d23 = (is_before.z - is_before.y) / apart(u.z - u.y);
  float d012 = (d12 - d01) / apart(u.y - x);
  float d123 = (d23 - d12) / apart(u.z - u.x);
  float d0123 = (d123 - d012) / apart(u.z - x);
  float quadratic = m.second + x * u.x;
  float cubic = m.third - m.second * (x + u.x + u.y) - x * u.x * u.y;
  return clamp(-x * d01 + quadratic * d012 + cubic * d0123, 0.0, 1.0);
}
