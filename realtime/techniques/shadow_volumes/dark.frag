// SPDX-License-Identifier: Apache-2.0
// In shadow, but for the background.
void main() { out_visibility = texelFetch(gbuffer_position, ivec2(gl_FragCoord.xy), 0).w == 0.0 ? 1.0 : 0.0; }
