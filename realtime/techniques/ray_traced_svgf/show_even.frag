// SPDX-License-Identifier: Apache-2.0
// What the last level left.
void main() { out_visibility = texelFetch(even, ivec2(gl_FragCoord.xy), 0).r; }
