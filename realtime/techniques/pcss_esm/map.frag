// SPDX-License-Identifier: Apache-2.0
// exp(c (z - 1)) instead of exp(c z): empty texels hold 1 and c = 80 stays inside a float's range at both ends.
#include "moments.glsl"

in float distance_world;

void main() {
  float z = normalized_distance(VIEW, distance_world);
  out_warped = FORM == FORM_LINEAR_DEPTH ? z : exp(exponent * (z - 1.0));
}
