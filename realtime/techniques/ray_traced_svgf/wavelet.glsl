// SPDX-License-Identifier: Apache-2.0
// One level of the edge-avoiding wavelet (Schied et al. 2017, 4.3 and 4.4; Dammertz et al. 2010): 5 x 5 pixels, `spacing` apart.
#include "edge_stopping.glsl"

/// Of the variance over 3 x 3 pixels, so that a pixel that happens to be even is not taken for certain.
float blurred_variance(sampler2D noisy, ivec2 px) {
  float sum = 0.0, weights = 0.0;
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      ivec2 near = px + ivec2(x, y);
      if (any(lessThan(near, ivec2(0))) || any(greaterThanEqual(near, frame.screen_and_seed.xy))) continue;
      float weight = exp2(-float(abs(x) + abs(y)));
      sum += weight * texelFetch(noisy, near, 0).g;
      weights += weight;
    }
  }
  return sum / weights;
}

/// Visibility and variance after a level.
vec2 filtered(sampler2D noisy, int spacing) {
  ivec2 px = ivec2(gl_FragCoord.xy);
  vec2 here = texelFetch(noisy, px, 0).rg;
  Surface surface = surface_at(px);
  if (surface.depth == 0.0) return here;
  const float kLeast = 1e-4;  // const: visibility that noise-free neighbours may differ by, so that nothing is divided by 0
  const int kReach = 2;       // const: of five by five
  const float kSpline[3] = float[](3.0 / 8.0, 1.0 / 4.0, 1.0 / 16.0);  // const: B3 spline, from the middle outwards
  float allowed = sigma_visibility * sqrt(blurred_variance(noisy, px)) + kLeast;
  vec2 sum = vec2(0.0);
  float weights = 0.0;
  for (int y = -kReach; y <= kReach; ++y) {
    for (int x = -kReach; x <= kReach; ++x) {
      ivec2 near = px + spacing * ivec2(x, y);
      if (any(lessThan(near, ivec2(0))) || any(greaterThanEqual(near, frame.screen_and_seed.xy))) continue;
      vec2 there = texelFetch(noisy, near, 0).rg;
      float weight = kSpline[abs(x)] * kSpline[abs(y)] * exp(-abs(there.r - here.r) / allowed);
      if (near != px) weight *= surface_weight(surface, surface_at(near));
      sum += vec2(weight, weight * weight) * there;
      weights += weight;
    }
  }
  return sum / vec2(weights, weights * weights);
}
