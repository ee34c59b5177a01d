// SPDX-License-Identifier: Apache-2.0
// The wavelet's second or fourth level.
#include "wavelet.glsl"

void main() { out_even = filtered(odd, 2 << level); }
