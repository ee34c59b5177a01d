// SPDX-License-Identifier: Apache-2.0
// Numbers as bits that unsigned atomics order as the numbers themselves.

const uint kSign = 0x80000000u;  // const: the sign bit of a float

uint ordered_bits(float number) {
  uint bits = floatBitsToUint(number);
  return (bits & kSign) != 0u ? ~bits : bits | kSign;
}

float number_of_ordered(uint bits) {
  return uintBitsToFloat((bits & kSign) != 0u ? bits & ~kSign : ~bits);
}
