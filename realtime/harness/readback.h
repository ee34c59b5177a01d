// SPDX-License-Identifier: Apache-2.0
#pragma once
// From textures to images: the only place where rows are flipped.

#include "core/image.h"
#include "realtime/harness/objects.h"

#include <span>
#include <string>

namespace umbrameter {

/// One layer and level of a texture as an image of its own, row 0 on top: channel Y for one component, else R, G, B, A as
/// far as there are any.
Image read_layer(const Texture& texture, int layer, int level);

/// Copies component k of `texture` to channel channels[k] of `image` (same size), row 0 on top. An empty name
/// skips the component. r32ui: 0xffffffff becomes -1.
void read_texture(const Texture& texture, std::span<const std::string> channels, Image& image);

}  // namespace umbrameter
