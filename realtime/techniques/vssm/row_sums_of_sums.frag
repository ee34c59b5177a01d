// SPDX-License-Identifier: Apache-2.0
// The same again, four times as far apart.
#include "sum_of_four.glsl"

void main() { out_sums = sum_of_four(part_sums, ivec2(1, 0) << (4 * row_step + 2)); }  // const: two bits a pass
