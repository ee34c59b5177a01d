// SPDX-License-Identifier: Apache-2.0
// The wavelet's third or fifth level.
#include "wavelet.glsl"

void main() { out_odd = filtered(even, 2 << level); }
