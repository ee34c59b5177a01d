// SPDX-License-Identifier: Apache-2.0
// The table of taps: a row a set, a column a tap. Each set is a jittered grid of GRID_TAPS x GRID_TAPS, wrapped around
// the disk so that equal areas stay equal: y becomes the squared radius, x the angle (Uralsky 2005).
#include "sampling.glsl"
#include "white_noise.glsl"

/// Rings in the order in which they are read: the outermost, whose taps tell most, then from the middle outwards.
int ring_at(int row) { return row == 0 ? GRID_TAPS - 1 : row - 1; }

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec2 corner = vec2(at.x % GRID_TAPS, ring_at(at.x / GRID_TAPS));
  vec2 cell = (corner + white_noise(uvec3(at, 0))) / float(GRID_TAPS);
  float angle_rad = kTwoPi * cell.x;
  out_taps = sqrt(cell.y) * vec2(cos(angle_rad), sin(angle_rad));
}
