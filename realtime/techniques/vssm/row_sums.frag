// SPDX-License-Identifier: Apache-2.0
// Of a table of sums along rows: four of the last step's sums.
#include "sum_of_four.glsl"

void main() { out_part_sums = sum_of_four(sums, ivec2(1, 0) << (4 * row_step)); }  // const: two bits a pass
