// SPDX-License-Identifier: Apache-2.0
#pragma once
// Pixels as text that a browser unpacks: numbers in fixed steps or half floats, zlib, base64. report/assets/planes.js
// is the other end.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace umbrameter {

/// Which value a stored word stands for: low + step x word, or a half float.
struct PlaneCode {
  double low = 0.0;
  double step = 0.0;      // 0: half float
  bool is_delta = false;  // words are stored as zigzag differences to the word before
};

/// V in steps that are an eighth of what nobody calls an error (.001, metrics/statistics/significance.h); R in finer ones.
inline constexpr PlaneCode kTestVisibilityCode{0.0, 1.0 / 4095.0, false};
inline constexpr PlaneCode kReferenceVisibilityCode{0.0, 1.0 / 65535.0, true};
inline constexpr PlaneCode kHalfCode{};

/// 65535 steps over the range of `values`.
PlaneCode range_code(std::span<const float> values);

/// The nearest half float of a value that is not negative; NaN becomes 0.
uint16_t to_half(float value);

std::string pack_plane(std::span<const float> values, const PlaneCode& code);
std::string pack_bytes(std::span<const uint8_t> bytes);

}  // namespace umbrameter
