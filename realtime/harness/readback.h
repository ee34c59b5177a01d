// SPDX-License-Identifier: Apache-2.0
#pragma once
// From textures to images: the only place where rows are flipped.

#include "core/image.h"
#include "realtime/harness/objects.h"

#include <span>
#include <string>

namespace umbrameter {

/// Copies component k of `texture` to channel channels[k] of `image` (same size), row 0 on top. An empty name
/// skips the component. r32ui: 0xffffffff becomes -1.
void read_texture(const Texture& texture, std::span<const std::string> channels, Image& image);

}  // namespace umbrameter
