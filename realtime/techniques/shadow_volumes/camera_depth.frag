// SPDX-License-Identifier: Apache-2.0
// The camera's depth, for volumes to be tested against.
void main() { gl_FragDepth = texelFetch(gbuffer_depth, ivec2(gl_FragCoord.xy), 0).r; }
