// SPDX-License-Identifier: Apache-2.0
// How whole numbers stand for moments: the widest cell's sum takes at most 31 bits.
const float kSumScale = exp2(31.0) / float(MOST_WIDTH_TEXELS * MOST_WIDTH_TEXELS);  // const: bits
