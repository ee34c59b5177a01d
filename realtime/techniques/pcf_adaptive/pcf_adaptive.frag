// SPDX-License-Identifier: Apache-2.0
// Percentage-closer filtering over jittered disks that differ from pixel to pixel of a tile, with an early way out
// where no penumbra is expected, or possible.
#include "pixel.glsl"
#include "shadow_map.glsl"
#if EARLY_OUT == EARLY_OUT_MIN_MAX
#include "known_by_blocks.glsl"
#endif

/// The set of this pixel: the same from tile to tile.
int set_of_pixel() {
  ivec2 in_tile = ivec2(noise_position()) % tile_px;
  return in_tile.y * tile_px + in_tile.x;
}

/// How many of the taps from `first` up to `last` are lit.
float lit_taps(Receiver receiver, int set, int first, int last) {
  vec2 center = texel_position(view_light, receiver.lateral);
  float lit = 0.0;
  for (int i = first; i < last; ++i) {
    vec2 p_texels = center + radius_texels * texelFetch(taps, ivec2(i, set), 0).rg;
    lit += lit_at(shadow_map, view_light, receiver, p_texels, false);
  }
  return lit;
}

float disk_mean(Receiver receiver, int set) {
  int all = GRID_TAPS * GRID_TAPS;
  int probes = min(GRID_TAPS + PROBE_INNER, all);  // the outermost ring and some taps from the middle
  float lit = lit_taps(receiver, set, 0, probes);
  bool agrees = lit == 0.0 || lit == float(probes);
  if (EARLY_OUT == EARLY_OUT_RING && agrees) return lit / float(probes);
  return (lit + lit_taps(receiver, set, probes, all)) / float(all);
}

float visibility_of(Receiver receiver) {
  float known;
  if (is_known(view_light, receiver, known)) return known;
#if EARLY_OUT == EARLY_OUT_MIN_MAX
  vec2 center = texel_position(view_light, receiver.lateral);
  ivec2 low = ivec2(floor(center - radius_texels));
  ivec2 high = ivec2(floor(center + radius_texels));
  if (is_known_by_blocks(blocks, view_light, receiver, low, high, known)) return known;
#endif
  return disk_mean(receiver, set_of_pixel());
}

void main() {
  Receiver receiver;
  out_visibility = fetch_receiver(receiver) ? visibility_of(receiver) : 1.0;
}
