// SPDX-License-Identifier: Apache-2.0
#include "realtime/harness/noise_texture.h"

#include "core/sampling/blue_noise.h"

#include <vector>

namespace umbrameter {

Texture make_blue_noise() {
  constexpr int kSide = kBlueNoiseSide;
  std::vector<float> texels;
  for (const uint32_t rank : blue_noise_ranks())
    texels.push_back((static_cast<float>(rank) + 0.5f) / static_cast<float>(kSide * kSide));
  Texture texture(find_texture_format("r32f"), kSide, kSide, "noise.blue");
  glTextureSubImage2D(texture.id(), 0, 0, 0, kSide, kSide, GL_RED, GL_FLOAT, texels.data());
  return texture;
}

}  // namespace umbrameter
