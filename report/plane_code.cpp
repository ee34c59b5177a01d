// SPDX-License-Identifier: Apache-2.0
#include "report/plane_code.h"

#include "core/error.h"
#include "report/html.h"

#include <Imath/half.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

constexpr double kMostSteps = 65535.0;

uint16_t to_word(float value, const PlaneCode& code) {
  if (code.step == 0.0) return to_half(value);
  const double steps = (static_cast<double>(value) - code.low) / code.step;
  if (!(steps > 0.0)) return 0;  // NaN, too
  return static_cast<uint16_t>(std::lround(std::min(steps, kMostSteps)));
}

/// Small differences of either sign become small numbers.
uint16_t zigzag(uint16_t difference) {
  return static_cast<uint16_t>((difference << 1) ^ ((difference & 0x8000) != 0 ? 0xFFFF : 0));
}

}  // namespace

PlaneCode range_code(std::span<const float> values) {
  float low = 0.0f, high = 0.0f;
  bool is_first = true;
  for (const float value : values) {
    if (!std::isfinite(value)) continue;
    low = is_first ? value : std::min(low, value);
    high = is_first ? value : std::max(high, value);
    is_first = false;
  }
  const double extent = static_cast<double>(high) - static_cast<double>(low);
  return {static_cast<double>(low), extent > 0.0 ? extent / kMostSteps : 1.0, true};
}

uint16_t to_half(float value) {
  return value > 0.0f ? Imath::half(value).bits() : 0;
}

std::string pack_bytes(std::span<const uint8_t> bytes) {
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  const int status = compress2(reinterpret_cast<Bytef*>(packed.data()), &size, bytes.data(), bytes.size(),
                               Z_DEFAULT_COMPRESSION);
  UMBRAMETER_ASSERT(status == Z_OK, "zlib says {}", status);
  packed.resize(size);
  return encode_base64(packed);
}

std::string pack_plane(std::span<const float> values, const PlaneCode& code) {
  std::vector<uint8_t> bytes;
  bytes.reserve(2 * values.size());
  uint16_t before = 0;
  for (const float value : values) {
    const uint16_t word = to_word(value, code);
    const uint16_t stored = code.is_delta ? zigzag(static_cast<uint16_t>(word - before)) : word;
    before = word;
    bytes.push_back(static_cast<uint8_t>(stored & 0xFF));
    bytes.push_back(static_cast<uint8_t>(stored >> 8));
  }
  return pack_bytes(bytes);
}

}  // namespace umbrameter
