// SPDX-License-Identifier: Apache-2.0
#include "view/paint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace umbrameter {
namespace {

constexpr double kFull = 0.85;     // of white: fully lit at the white irradiance
constexpr double kAmbient = 0.05;  // of white: so that shapes in shadow can be told apart
constexpr double kSeScale = 0.05;  // standard error at white
constexpr double kPale = 0.35;     // of a picture that only stands in for another
constexpr double kMapInk = 0.45;   // of a map's colour over the picture
constexpr Rgb8 kBackdrop{92, 104, 122};
constexpr Rgb8 kEdge{20, 24, 32};
constexpr Rgb8 kNotFinite{255, 0, 255};

uint8_t to_byte(double share) {
  return static_cast<uint8_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
}

uint8_t to_srgb(double linear) {
  const double x = std::clamp(linear, 0.0, 1.0);
  return to_byte(x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055);
}

Rgb8 grey(uint8_t level) {
  return {level, level, level};
}

Rgb8 mixed(const Rgb8& from, const Rgb8& to, double share) {
  Rgb8 colour{};
  for (size_t k = 0; k < 3; ++k)
    colour[k] = static_cast<uint8_t>(std::lround(from[k] + share * (to[k] - from[k])));
  return colour;
}

template <class Colour>
Picture painted(const Image& image, const Rgb8& backdrop, const Colour& colour_at) {
  const auto primitive = image.plane("primitive_id");
  Picture picture{image.width, image.height, std::vector<uint8_t>(3 * image.pixel_count()), 0.0};
  for (size_t i = 0; i < primitive.size(); ++i) {
    const Rgb8 colour = primitive[i] < 0.0f ? backdrop : colour_at(i);
    std::ranges::copy(colour, picture.rgb.begin() + static_cast<std::ptrdiff_t>(3 * i));
  }
  return picture;
}

/// White surfaces under the light and a faint ambient one.
Picture lit(const Image& image, const PaintSettings& settings) {
  const auto visibility = image.plane("visibility"), irradiance = image.plane("unshadowed_irradiance");
  const double gain = std::exp2(settings.exposure_stops);
  return painted(image, kBackdrop, [&](size_t i) {
    const double full = static_cast<double>(irradiance[i]) / settings.white_irradiance;
    const double direct = full * static_cast<double>(std::clamp(visibility[i], 0.0f, 1.0f));
    return grey(to_srgb(gain * (kFull * direct + kAmbient * (0.4 + 0.6 * full))));
  });
}

Picture stand_in(const Image& image, const PaintSettings& settings) {
  Picture picture = lit(image, settings);
  for (uint8_t& byte : picture.rgb) byte = static_cast<uint8_t>(std::lround(160 + kPale * (byte - 160)));
  return picture;
}

Picture error(const PaintInputs& inputs, const PaintSettings& settings) {
  const auto test = inputs.image.plane("visibility"), truth = inputs.truth->plane("visibility");
  const auto lights = inputs.truth->plane("unshadowed_irradiance");
  return painted(inputs.image, kBackgroundColour, [&](size_t i) {
    const bool is_scored = inputs.scored.empty() ? lights[i] > 0.0f : inputs.scored[i] != 0;
    if (!is_scored) return kUnscoredColour;
    const double difference = static_cast<double>(test[i]) - static_cast<double>(truth[i]);
    return signed_error_colour(difference * kSignedErrorScale / settings.error_scale);
  });
}

/// Over the lit picture, so that one sees where they are.
Picture faults(const PaintInputs& inputs, const PaintSettings& settings) {
  const Picture below = lit(inputs.image, settings);
  return painted(inputs.image, kBackdrop, [&](size_t i) {
    const Rgb8 plain{below.rgb[3 * i], below.rgb[3 * i + 1], below.rgb[3 * i + 2]};
    const FaultClass fault = inputs.faults[i];
    if (fault == FaultClass::unscored || fault == FaultClass::explained) return plain;
    return fault_legend()[static_cast<size_t>(fault)].colour;
  });
}

Picture normals(const Image& image) {
  const auto x = image.plane("shading_normal.x"), y = image.plane("shading_normal.y"),
             z = image.plane("shading_normal.z");
  const auto level = [](float component) { return to_byte(0.5 + 0.5 * static_cast<double>(component)); };
  return painted(image, kBackdrop, [&](size_t i) { return Rgb8{level(x[i]), level(y[i]), level(z[i])}; });
}

/// The lit picture under the colour of the map that each pixel is looked up in; uncoloured where there is none.
Picture maps(const PaintInputs& inputs, const PaintSettings& settings) {
  const Picture below = lit(inputs.image, settings);
  const auto index = inputs.maps->plane("Y");
  return painted(inputs.image, kBackdrop, [&](size_t i) {
    const Rgb8 plain{below.rgb[3 * i], below.rgb[3 * i + 1], below.rgb[3 * i + 2]};
    return index[i] < 0.0f ? plain : mixed(plain, map_colour(static_cast<size_t>(index[i])), kMapInk);
  });
}

/// Darkens pixels whose right or lower neighbour shows another triangle.
void add_edges(const Image& image, Picture& picture) {
  const auto primitive = image.plane("primitive_id");
  const auto width = static_cast<size_t>(image.width), height = static_cast<size_t>(image.height);
  for (size_t y = 0; y + 1 < height; ++y) {
    for (size_t x = 0; x + 1 < width; ++x) {
      const size_t i = y * width + x;
      if (primitive[i] == primitive[i + 1] && primitive[i] == primitive[i + width]) continue;
      const Rgb8 plain{picture.rgb[3 * i], picture.rgb[3 * i + 1], picture.rgb[3 * i + 2]};
      std::ranges::copy(mixed(plain, kEdge, 0.6), picture.rgb.begin() + static_cast<std::ptrdiff_t>(3 * i));
    }
  }
}

Picture paint_plain(Layer layer, const PaintInputs& inputs, const PaintSettings& settings) {
  const Image& image = inputs.image;
  switch (layer) {
    case Layer::lit:
      return lit(image, settings);
    case Layer::visibility:
      return visibility_picture(image);
    case Layer::error:
      return inputs.truth ? error(inputs, settings) : stand_in(image, settings);
    case Layer::faults:
      return inputs.faults.empty() ? stand_in(image, settings) : faults(inputs, settings);
    case Layer::standard_error: {
      if (inputs.truth == nullptr) return stand_in(image, settings);
      const auto se = inputs.truth->plane("visibility_se");
      return painted(*inputs.truth, kBackgroundColour,
                     [&](size_t i) { return grey(to_byte(static_cast<double>(se[i]) / kSeScale)); });
    }
    case Layer::normals:
      return normals(image);
    case Layer::maps:
      return inputs.maps == nullptr ? lit(image, settings) : maps(inputs, settings);
    case Layer::irradiance: {
      const auto irradiance = image.plane("unshadowed_irradiance");
      return painted(image, kBackdrop, [&](size_t i) {
        return grey(to_srgb(kFull * static_cast<double>(irradiance[i]) / settings.white_irradiance));
      });
    }
  }
  return {};
}

}  // namespace

std::string_view title_of(Layer layer) {
  constexpr std::array<std::string_view, kLayers> kTitles{"Lit",
                                                          "Visibility",
                                                          "Signed error",
                                                          "Faults",
                                                          "Standard error of the truth",
                                                          "Normals",
                                                          "Unshadowed irradiance",
                                                          "Maps"};
  return kTitles.at(static_cast<size_t>(layer));
}

bool needs_truth(Layer layer) {
  return layer == Layer::error || layer == Layer::faults || layer == Layer::standard_error;
}

const Rgb8& map_colour(size_t map) {
  constexpr size_t kColours = 8;
  static constexpr std::array<Rgb8, kColours> kOkabeIto{
      Rgb8{230, 159, 0}, Rgb8{86, 180, 233}, Rgb8{0, 158, 115},   Rgb8{240, 228, 66},
      Rgb8{0, 114, 178}, Rgb8{213, 94, 0},   Rgb8{204, 121, 167}, Rgb8{187, 187, 187}};
  return kOkabeIto[map % kColours];
}

Picture paint(Layer layer, const PaintInputs& inputs, const PaintSettings& settings) {
  Picture picture = paint_plain(layer, inputs, settings);
  if (settings.has_edges) add_edges(inputs.image, picture);
  return picture;
}

double white_irradiance(const Image& image) {
  const auto irradiance = image.plane("unshadowed_irradiance");
  std::vector<float> values;
  std::ranges::copy_if(irradiance, std::back_inserter(values), [](float value) { return value > 0.0f; });
  if (values.empty()) return 1.0;
  const auto place =
      values.begin() + static_cast<std::ptrdiff_t>(0.98 * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, place);
  return static_cast<double>(*place);
}

ResourcePicture paint_resource(const Image& resource) {
  const auto find = [&](const char* name) {
    return resource.has(name) ? resource.plane(name) : std::span<const float>();
  };
  std::array<std::span<const float>, 3> channels{find("R"), find("G"), find("B")};
  if (channels[0].empty()) channels = {find("Y"), find("Y"), find("Y")};
  ResourcePicture out{
      {resource.width, resource.height, std::vector<uint8_t>(3 * resource.pixel_count()), 0.0}};
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const auto& channel : channels) {
    for (const float value : channel) {
      if (!std::isfinite(value)) continue;
      low = std::min(low, static_cast<double>(value));
      high = std::max(high, static_cast<double>(value));
    }
  }
  if (low > high) low = high = 0.0;
  out.min = low;
  out.max = high;
  const double range = high > low ? high - low : 1.0;
  for (size_t i = 0; i < resource.pixel_count(); ++i) {
    for (size_t k = 0; k < 3; ++k) {
      if (channels[k].empty()) continue;  // fewer than three: the rest stays 0
      const float value = channels[k][i];
      out.picture.rgb[3 * i + k] =
          std::isfinite(value) ? to_byte((static_cast<double>(value) - low) / range) : kNotFinite[k];
    }
  }
  return out;
}

}  // namespace umbrameter
