// SPDX-License-Identifier: Apache-2.0
// Screen-space contact shadows.
#include "screen_trace.glsl"

void main() {
  bool is_surface = texelFetch(gbuffer_position, ivec2(gl_FragCoord.xy), 0).w != 0.0;
  out_visibility = is_surface ? screen_visibility() : 1.0;
}
