// SPDX-License-Identifier: Apache-2.0
#include "core/sampling/patterns.h"

#include "core/sampling/sobol.h"

#include <cmath>
#include <numbers>

namespace umbrameter {

glm::vec2 vogel_disk(uint32_t index, uint32_t count, float rotation_rad) {
  const double radius = std::sqrt((index + 0.5) / count);
  const double angle_rad = index * kGoldenAngleRad + static_cast<double>(rotation_rad);
  return {static_cast<float>(radius * std::cos(angle_rad)), static_cast<float>(radius * std::sin(angle_rad))};
}

float interleaved_gradient_noise(const glm::vec2& p_px) {
  const float inner = 0.06711056f * p_px.x + 0.00583715f * p_px.y;
  const float outer = 52.9829189f * (inner - std::floor(inner));
  return outer - std::floor(outer);
}

glm::vec2 hammersley(uint32_t index, uint32_t count) {
  const double radical_inverse = sobol_point(index).x * 0x1p-32;
  return {static_cast<float>((index + 0.5) / count), static_cast<float>(radical_inverse)};
}

glm::vec2 concentric_disk(const glm::vec2& uv) {
  constexpr float kQuarterPi = std::numbers::pi_v<float> / 4;
  const glm::vec2 p = 2.0f * uv - 1.0f;
  if (p.x == 0.0f && p.y == 0.0f) return {0.0f, 0.0f};
  const bool x_wide = std::abs(p.x) > std::abs(p.y);
  const float radius = x_wide ? p.x : p.y;
  const float angle_rad = x_wide ? kQuarterPi * (p.y / p.x) : 2 * kQuarterPi - kQuarterPi * (p.x / p.y);
  return {radius * std::cos(angle_rad), radius * std::sin(angle_rad)};
}

}  // namespace umbrameter
