// SPDX-License-Identifier: Apache-2.0
// Of a table of sums along columns: four of the last step's sums.
#include "sum_of_four.glsl"

void main() { out_part_sums = sum_of_four(sums, ivec2(0, 1) << (4 * column_step)); }  // const: two bits a pass
