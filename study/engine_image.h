// SPDX-License-Identifier: Apache-2.0
#pragma once
// Pictures that another engine rendered: their transfer undone, visibility from pairs, and what eight bits cost. Not here:
// surfaces (study/engine_surfaces.h) and the score (study/score.h).

#include "core/image.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {

/// How a picture's numbers follow from light.
enum class Transfer : uint8_t { linear, srgb, gamma22 };

/// "linear", "srgb" or "gamma2.2"; Error{input} otherwise.
Transfer parse_transfer(std::string_view text);

/// Light for a stored number in 0 to 1, and its derivative.
double light_of(double stored, Transfer transfer);
double slope_of_light(double stored, Transfer transfer);

/// A picture's luminance with the width of its steps.
struct EngineImage {
  int width = 0;
  int height = 0;
  std::vector<float> light;  // [height][width], linear
  std::vector<float> step;   // between neighbouring stored numbers, in light; 0 for floats
};

/// `file` says the format: EXR, HDR and PFM are linear floats, whatever `transfer` says; for the rest, which have 8 or 16
/// bits, `transfer` must be given, or Error{input}. A visibility channel, one grey channel or the luminance of R, G, B.
EngineImage decode_engine_image(const Image& image, const std::string& file, std::string_view transfer);

/// Visibility of an engine, on the pixels where it has any.
struct EngineVisibility {
  Image image;                     // visibility
  std::vector<float> rounding_sd;  // of visibility, from the steps
  std::vector<uint8_t> known;
  size_t dark = 0;      // left out: without shadows so dark that a few steps make the ratio, 0 / 0
  size_t brighter = 0;  // left out: with shadows brighter than without
  double mean_square_rounding = 0.0;  // over known pixels
  double largest_step = 0.0;          // of visibility, on known pixels
};

EngineVisibility visibility_of(const EngineImage& visibility);

/// shadowed / unshadowed. Error{input} for other sizes.
EngineVisibility visibility_of_pair(const EngineImage& shadowed, const EngineImage& unshadowed);

/// Adds the rounding to the reference's standard error and takes pixels without visibility out of the score: their
/// unshadowed irradiance becomes 0 in both images.
void apply_rounding(const EngineVisibility& engine, Image& test, Image& reference);

}  // namespace umbrameter
