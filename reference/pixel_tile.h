// SPDX-License-Identifier: Apache-2.0
#pragma once
// A square of pixels from primary hits to finished channels: the grain of threads, and of the first proof.

#include "reference/pixel_block.h"

namespace umbrameter {

inline constexpr int kTile = 4 * kBlock;  // pixels

/// Renders the tile whose first pixel is (x0, y0), cut at the picture's border. Where all of its pixels are proven to see
/// the whole light nothing is left to do, else it goes on block by block.
void render_tile(const BlockJob& job, int x0, int y0, ReferencePlanes& planes);

}  // namespace umbrameter
