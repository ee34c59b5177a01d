// SPDX-License-Identifier: Apache-2.0
#pragma once
// Point patterns that technique shaders use, and their C++ twins. The realtime room uploads or mirrors
// exactly these; tests/gpu compares.

#include <glm/vec2.hpp>

#include <cstdint>
#include <vector>

namespace umbrameter {

inline constexpr double kGoldenAngleRad = 2.399963229728653;  // pi (3 - sqrt 5)

/// Point `index` of `count` on the unit disk, uniform in area, turned by `rotation_rad` (Vogel 1979).
glm::vec2 vogel_disk(uint32_t index, uint32_t count, float rotation_rad);

/// Interleaved gradient noise in [0,1) at a pixel (Jimenez 2014).
float interleaved_gradient_noise(const glm::vec2& p_px);

/// Point `index` of `count` of the Hammersley set in [0,1)^2: ((i + .5) / n, bit-reversed i).
glm::vec2 hammersley(uint32_t index, uint32_t count);

/// Area-preserving concentric map from [0,1)^2 to the unit disk (Shirley and Chiu 1997).
glm::vec2 concentric_disk(const glm::vec2& uv);

}  // namespace umbrameter
