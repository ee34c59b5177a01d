// SPDX-License-Identifier: Apache-2.0
#pragma once
// Maps for people, each at one fixed scale that its legend states. Colours are sRGB bytes; the report's
// legend takes them from here.

#include "core/image.h"
#include "metrics/faults/faults.h"
#include "metrics/image/parity.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace umbrameter {

using Rgb8 = std::array<uint8_t, 3>;

/// rgb: [height][width][3], row 0 on top.
struct Picture {
  int width_px = 0;
  int height_px = 0;
  std::vector<uint8_t> rgb;
  double clipped_share = 0.0;  // of the coloured pixels, beyond the scale
};

/// Where nothing is hit, and where a pixel is not scored.
inline constexpr Rgb8 kBackgroundColour{70, 84, 110};
inline constexpr Rgb8 kUnscoredColour{128, 128, 128};

/// Ends of the signed error's scale: V - R = -kSignedErrorScale (too dark), 0, +kSignedErrorScale (too
/// bright).
inline constexpr double kSignedErrorScale = 0.25;
inline constexpr Rgb8 kTooDarkColour{5, 80, 190};
inline constexpr Rgb8 kNoErrorColour{255, 255, 255};
inline constexpr Rgb8 kTooBrightColour{190, 10, 30};

/// Colour of an error in [-kSignedErrorScale, kSignedErrorScale]; linear in the bytes, clipped outside.
Rgb8 signed_error_colour(double error);

/// `visibility` as grey: byte = round(255 V), no gamma. Background where `primitive_id` says so.
Picture visibility_picture(const Image& image);

/// `visibility` of test minus that of reference where `mask` is not 0.
Picture signed_error_picture(const Image& test, const Image& reference, std::span<const uint8_t> mask);

struct ParityLegend {
  ParityClass parity_class;
  Rgb8 colour;
  std::string_view text;
};
/// One entry a class, in the order of ParityClass.
std::span<const ParityLegend> parity_legend();

Picture parity_picture(const Parity& parity);

struct FaultLegend {
  FaultClass fault;
  Rgb8 colour;
  std::string_view text;
};
/// One entry a class, in the order of FaultClass.
std::span<const FaultLegend> fault_legend();

Picture fault_picture(std::span<const FaultClass> classes, int width_px, int height_px);

/// Writes the picture as PNG.
void write_picture(const std::filesystem::path& path, const Picture& picture);

}  // namespace umbrameter
