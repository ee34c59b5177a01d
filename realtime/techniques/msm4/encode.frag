// SPDX-License-Identifier: Apache-2.0
// The moments of every texel, where nothing blurs them.
#include "four_moments.glsl"

void main() { out_moments = encoded(texelFetch(surface, ivec2(gl_FragCoord.xy), 0).r); }
