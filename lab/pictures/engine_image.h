// SPDX-License-Identifier: Apache-2.0
#pragma once
// Pictures that another engine rendered: their transfer undone, visibility from pairs, and what eight bits cost. Not here:
// surfaces (lab/pictures/engine_surfaces.h) and the score (lab/score.h).

#include "core/image.h"
#include "lab/pictures/engine_file.h"

#include <cstdint>
#include <span>
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
  std::vector<float> light;       // [height][width], linear
  std::vector<float> step;        // between neighbouring stored numbers, in light; 0 for floats
  std::vector<float> spread;      // largest less smallest of R, G and B, in light; 0 for grey
  std::vector<uint8_t> has_data;  // the file's data window covers the pixel
  Image beside;                   // what our own programs write beside visibility: texel, bias, error
  std::vector<std::string> notes;
};

/// Reads `file` (lab/pictures/engine_file.h). Files of floats are linear, whatever `transfer` says; for the rest, which have 8 or
/// 16 bits, `transfer` must be given, or Error{input}. Colours become their luminance (Rec. 709).
EngineImage read_engine_image(const std::string& file, std::string_view transfer,
                              const PictureChoice& choice = {});

/// Visibility, or what has its range, of an engine, on the pixels where it has any. Counts are of scorable pixels.
struct EngineVisibility {
  Image image;                     // visibility
  std::vector<float> rounding_sd;  // of visibility, from the steps
  std::vector<uint8_t> known;      // [height][width]
  size_t missing = 0;              // left out: outside the data window
  size_t dark = 0;                 // left out: without shadows so dark that a few steps make the ratio, 0 / 0
  size_t brighter = 0;             // left out: with shadows brighter than without
  size_t nudged = 0;               // up to kRangeSlack outside [0, 1]: set to 0 or 1
  double largest_nudge = 0.0;
  double mean_square_rounding = 0.0;  // over known pixels
  double largest_step = 0.0;          // of visibility, on known pixels
};

/// A value this far outside [0, 1] is rounding or noise, in every format: it counts as 0 or 1. Farther out, a picture of
/// visibility is refused, and the pixel of a pair is left out.
inline constexpr double kRangeSlack = 0.02;

/// `scorable`: what the truth can score (metrics/image/parity.h); other pixels are neither counted nor refused. Error{input} for
/// values outside the range, numbers that are none, and colour.
EngineVisibility visibility_of(const EngineImage& visibility, std::span<const uint8_t> scorable);

/// shadowed / unshadowed. Error{input} for other sizes and numbers that are none.
EngineVisibility visibility_of_pair(const EngineImage& shadowed, const EngineImage& unshadowed,
                                    std::span<const uint8_t> scorable);

/// Whether the first picture is the one without shadows: it is brighter in what `reference` calls shadow, and nowhere
/// darker to speak of.
bool is_swapped(const EngineImage& shadowed, const EngineImage& unshadowed, const Image& reference,
                std::span<const uint8_t> scorable);

/// Adds the rounding to the reference's standard error.
void add_rounding(const EngineVisibility& engine, Image& reference);

}  // namespace umbrameter
