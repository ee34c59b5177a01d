// SPDX-License-Identifier: Apache-2.0
// Which pixels are computed, and where they are packed, for techniques with the parameter pattern. Pixels count rows
// from the top, as images do.

/// Rows a computed row stands for.
int pattern_rows() { return PATTERN == PATTERN_QUARTER ? 2 : 1; }

/// The pixel packed into `cell`: every other one of a row, rows in turns; or one of two by two.
ivec2 pixel_of(ivec2 cell) {
  ivec2 px = ivec2(2, pattern_rows()) * cell;
  return PATTERN == PATTERN_CHECKERBOARD ? px + ivec2(px.y & 1, 0) : px;
}

ivec2 cell_of(ivec2 px) { return px / ivec2(2, pattern_rows()); }

bool is_computed(ivec2 px) { return pixel_of(cell_of(px)) == px; }

/// Between rows from the top and GL's.
ivec2 flipped(ivec2 px, int height) { return ivec2(px.x, height - 1 - px.y); }
