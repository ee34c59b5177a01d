// SPDX-License-Identifier: Apache-2.0
#pragma once
// Roots and powers without branches or calls, so that a loop over pixels vectorises on plain x86-64. Within
// a few float roundings; the same bits on every machine, which libm's are not.

#include <bit>
#include <cstdint>

namespace umbrameter {

/// The Nth root of x, N odd; 0 for anything up to 1e-20. The inverse root y comes from a guess by the exponent's bits and
/// two steps without divisions: with h = 1 - x y^N the root is y (1 - h)^(-1/N), a series in h. The guess is within 4 %,
/// the first step within 1e-4, the second within rounding.
template <int N>
inline float root(float x) {
  constexpr float kTiny = 1e-20f;
  constexpr float kOne = 0x3f800000;  // the bits of 1.0f
  constexpr float k1 = 1.0f / N, k2 = k1 * (N + 1) / (2 * N), k3 = k2 * (2 * N + 1) / (3 * N);
  const float safe = x > kTiny ? x : kTiny;
  const float bits = static_cast<float>(std::bit_cast<int32_t>(safe));
  // The bits are linear in the logarithm to 0.0861 octaves (largest log2(1 + f) - f); halve that.
  float y = std::bit_cast<float>(
      static_cast<int32_t>((kOne - bits) * k1 + kOne - (1.0f + k1) * 0.04303f * 0x800000));
  const auto remainder = [safe](float inverse) {
    float power = safe * inverse;
    for (int k = 1; k < N; ++k) power *= inverse;
    return 1.0f - power;
  };
  const float first = remainder(y);
  y *= 1.0f + first * (k1 + first * (k2 + first * k3));
  const float second = remainder(y);
  y *= 1.0f + second * (k1 + second * k2);
  return x > kTiny ? 1.0f / y : 0.0f;
}

/// log2 of a normal x > 0: exponent, and for the mantissa m in [sqrt(1/2), sqrt(2)) the series of
/// 2 artanh((m - 1) / (m + 1)), cut where a term is below 4e-9.
inline float fast_log2(float x) {
  constexpr int32_t kSqrtHalf = 0x3f3504f3;
  const int32_t bits = std::bit_cast<int32_t>(x) - kSqrtHalf;
  const float m = std::bit_cast<float>((bits & 0x7fffff) + kSqrtHalf);
  const float s = (m - 1.0f) / (m + 1.0f), t = s * s;
  const float series = 1.0f + t * (1.0f / 3 + t * (1.0f / 5 + t * (1.0f / 7 + t * (1.0f / 9))));
  return static_cast<float>(bits >> 23) + 2.885390082f * s * series;  // 2 / ln 2
}

/// 2^x for -120 < x < 120: whole part into the exponent, Taylor series of the rest to 1e-8.
inline float fast_exp2(float x) {
  const float rounded = x + (x < 0.0f ? -0.5f : 0.5f);
  const int32_t whole = static_cast<int32_t>(rounded);
  const float f = (x - static_cast<float>(whole)) * 0.6931471806f;  // ln 2
  const float series =
      1.0f +
      f * (1.0f +
           f * (1.0f / 2 +
                f * (1.0f / 6 + f * (1.0f / 24 + f * (1.0f / 120 + f * (1.0f / 720 + f * (1.0f / 5040)))))));
  return std::bit_cast<float>(std::bit_cast<int32_t>(series) + (whole << 23));
}

/// x^y for x in [0,1], 0 <= y <= 4; 0^0 = 1.
inline float fast_pow(float x, float y) {
  constexpr float kTiny = 1e-9f;  // below, x^y is taken to be 0; keeps the exponent in range
  const float value = fast_exp2(y * fast_log2(x > kTiny ? x : kTiny));
  const float at_zero = y > 0.0f ? 0.0f : 1.0f;
  return x > kTiny ? value : at_zero;
}

}  // namespace umbrameter
