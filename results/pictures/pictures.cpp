// SPDX-License-Identifier: Apache-2.0
#include "results/pictures/pictures.h"

#include "core/error.h"
#include "core/image_io.h"

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

constexpr std::array<ParityLegend, 6> kParityLegend{{
    {ParityClass::agrees, {225, 225, 225}, "agrees"},
    {ParityClass::background, kBackgroundColour, "nothing hit in either"},
    {ParityClass::coverage, {200, 0, 200}, "hit in one renderer only"},
    {ParityClass::surface, {230, 120, 0}, "another surface"},
    {ParityClass::irradiance, {0, 150, 140}, "other unshadowed irradiance"},
    {ParityClass::unknown, {120, 120, 200}, "no light in the engine's own picture"},
}};

constexpr std::array<FaultLegend, kFaultClasses> kFaultLegend{{
    {FaultClass::unscored, kUnscoredColour, "not scored"},
    {FaultClass::explained, {240, 240, 240}, "no fault, or a slight shift or softness"},
    {FaultClass::acne, {213, 40, 0}, "acne: dark on lit ground"},
    {FaultClass::terminator, {204, 121, 167}, "terminator: dark where facets turn from the light"},
    {FaultClass::extra_shadow, {0, 0, 0}, "extra shadow"},
    {FaultClass::penumbra, {240, 228, 66}, "penumbra: too soft or too hard"},
    {FaultClass::overlap, {150, 150, 20}, "overlap: wrong where penumbrae overlap"},
    {FaultClass::penumbra_too_wide,
     {180, 205, 60},
     "penumbra too wide: an edge blurred beyond the light's size"},
    {FaultClass::resolution, {125, 75, 30}, "resolution: edges as coarse as a texel"},
    {FaultClass::peter_panning, {240, 140, 0}, "peter panning: light where objects touch"},
    {FaultClass::bleed, {86, 180, 233}, "bleed: dim light behind several blockers"},
    {FaultClass::geometric_leak, {0, 70, 200}, "geometric leak: other light in shadow"},
    {FaultClass::lost_shadow, {0, 158, 115}, "lost shadow"},
}};

Picture blank(int width_px, int height_px) {
  const size_t pixels = static_cast<size_t>(width_px) * static_cast<size_t>(height_px);
  return {width_px, height_px, std::vector<uint8_t>(pixels * 3), 0.0};
}

void set_pixel(Picture& picture, size_t pixel, const Rgb8& colour) {
  std::copy(colour.begin(), colour.end(), picture.rgb.begin() + static_cast<std::ptrdiff_t>(pixel * 3));
}

uint8_t to_byte(double value) {
  return static_cast<uint8_t>(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
}

}  // namespace

Rgb8 signed_error_colour(double error) {
  const double t = std::min(std::abs(error) / kSignedErrorScale, 1.0);
  const Rgb8& end = error < 0.0 ? kTooDarkColour : kTooBrightColour;
  Rgb8 colour{};
  for (size_t i = 0; i < 3; ++i) {
    colour[i] = static_cast<uint8_t>(std::lround(kNoErrorColour[i] + t * (end[i] - kNoErrorColour[i])));
  }
  return colour;
}

Picture visibility_picture(const Image& image) {
  Picture picture = blank(image.width, image.height);
  const auto visibility = image.plane("visibility");
  const bool has_background = image.has("primitive_id");
  const auto primitive = has_background ? image.plane("primitive_id") : std::span<const float>{};
  for (size_t i = 0; i < image.pixel_count(); ++i) {
    const uint8_t grey = to_byte(visibility[i]);
    set_pixel(picture, i, has_background && primitive[i] < 0.0f ? kBackgroundColour : Rgb8{grey, grey, grey});
  }
  return picture;
}

Picture signed_error_picture(const Image& test, const Image& reference, std::span<const uint8_t> mask) {
  require_same_size(test, reference, "error picture");
  UMBRAMETER_ASSERT(mask.size() == test.pixel_count(), "mask of {} pixels for {}", mask.size(),
                    test.pixel_count());
  Picture picture = blank(test.width, test.height);
  const auto v = test.plane("visibility");
  const auto r = reference.plane("visibility");
  size_t scored = 0;
  size_t clipped = 0;
  for (size_t i = 0; i < mask.size(); ++i) {
    if (mask[i] == 0) {
      set_pixel(picture, i, kUnscoredColour);
      continue;
    }
    const double error = static_cast<double>(v[i]) - static_cast<double>(r[i]);
    ++scored;
    clipped += std::abs(error) > kSignedErrorScale ? 1 : 0;
    set_pixel(picture, i, signed_error_colour(error));
  }
  picture.clipped_share = scored == 0 ? 0.0 : static_cast<double>(clipped) / static_cast<double>(scored);
  return picture;
}

std::span<const ParityLegend> parity_legend() {
  return kParityLegend;
}

Picture parity_picture(const Parity& parity) {
  Picture picture = blank(parity.width, parity.height);
  for (size_t i = 0; i < parity.classes.size(); ++i) {
    set_pixel(picture, i, kParityLegend.at(static_cast<size_t>(parity.classes[i])).colour);
  }
  return picture;
}

std::span<const FaultLegend> fault_legend() {
  return kFaultLegend;
}

Picture fault_picture(std::span<const FaultClass> classes, int width_px, int height_px) {
  Picture picture = blank(width_px, height_px);
  UMBRAMETER_ASSERT(3 * classes.size() == picture.rgb.size(), "{} fault classes for {} x {} px",
                    classes.size(), width_px, height_px);
  for (size_t i = 0; i < classes.size(); ++i) {
    set_pixel(picture, i, kFaultLegend.at(static_cast<size_t>(classes[i])).colour);
  }
  return picture;
}

void write_picture(const std::filesystem::path& path, const Picture& picture) {
  write_png(path, picture.width_px, picture.height_px, picture.rgb);
}

}  // namespace umbrameter
