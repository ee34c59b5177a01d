// SPDX-License-Identifier: Apache-2.0
#include "metrics/flip/flip.h"

#include "core/error.h"
#include "metrics/flip/flip_color.h"
#include "metrics/flip/flip_map.h"
#include "metrics/image/checks.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace umbrameter {

namespace {

// The ACES fit (a x^2 + b x) / (c x^2 + d x + e); .6 undoes the exposure in Narkowicz's constants.
constexpr double kA = 0.6 * 0.6 * 2.51, kB = 0.6 * 0.03, kC = 0.6 * 0.6 * 2.43, kD = 0.6 * 0.59, kE = 0.14;
constexpr double kBrightTone = 0.85;  // the paper's t
constexpr float kHighest = 1e9f;      // its square and the curve's constants still fit a float

bool is_grey(const ColorChannels& channels) {
  return channels[0] == channels[1] && channels[1] == channels[2];
}

void require_picture(const Image& picture, const ColorChannels& channels, float highest) {
  const std::vector<uint8_t> everywhere(picture.pixel_count(), 1);
  for (size_t k = 0; k < (is_grey(channels) ? 1 : channels.size()); ++k)
    require_range(picture, channels[k], everywhere, 0.0f, highest);
}

void require_test(const Image& test, const ColorChannels& channels, float highest, int width, int height) {
  require_same_size(test, Image(width, height), "FLIP");
  require_picture(test, channels, highest);
}

void require_settings(const FlipSettings& settings) {
  if (settings.pixels_per_degree >= 1.0 && settings.pixels_per_degree <= 1000.0) return;
  fail_input(fmt::format("pixels_per_degree is {}", settings.pixels_per_degree), {}, "1 to 1000");
}

// Rows of `image`, each value through `linear_from`.
template <class LinearFrom>
FlipSource source_of(const Image& image, const ColorChannels& channels, const LinearFrom& linear_from) {
  const std::array planes = {image.plane(channels[0]), image.plane(channels[1]), image.plane(channels[2])};
  const size_t width = static_cast<size_t>(image.width);
  const auto fill = [planes, width, linear_from](int y, const LinearRow& row) {
    const std::array<std::span<float>, 3> to = {row.red, row.green, row.blue};
    for (size_t k = 0; k < 3; ++k) {
      const float* from = planes[k].data() + static_cast<size_t>(y) * width;
      for (size_t x = 0; x < to[k].size(); ++x) to[k][x] = linear_from(from[x]);
    }
  };
  return {fill, is_grey(channels)};
}

FlipSource encoded_source(const Image& image, const ColorChannels& channels) {
  return source_of(image, channels, [](float encoded) { return linear_from_srgb(encoded); });
}

FlipSource exposed_source(const Image& image, const ColorChannels& channels, double stops) {
  return source_of(image, channels, [scale = static_cast<float>(std::exp2(stops))](float linear) {
    const float tone = aces_tone(std::min(linear * scale, kHighest));
    return tone < 1.0f ? tone : 1.0f;
  });
}

// Exact, by counting: first the upper half of the bits, then the lower half among those that share it. Floats of 0
// or more sort as their bits do.
float nth_smallest(const std::vector<float>& values, size_t n) {
  const auto bits_at = [&](size_t i) { return std::bit_cast<uint32_t>(values[i]); };
  const auto bin_of_nth = [&n](const std::vector<uint32_t>& counts) {
    uint32_t bin = 0;
    for (; n >= counts[bin]; ++bin) n -= counts[bin];
    return bin;
  };
  std::vector<uint32_t> counts(65536, 0);
  for (size_t i = 0; i < values.size(); ++i) ++counts[bits_at(i) >> 16];
  const uint32_t upper = bin_of_nth(counts);
  std::fill(counts.begin(), counts.end(), 0u);
  for (size_t i = 0; i < values.size(); ++i) {
    if (bits_at(i) >> 16 == upper) ++counts[bits_at(i) & 0xffff];
  }
  return std::bit_cast<float>(upper << 16 | bin_of_nth(counts));
}

Flip summarised(std::vector<float> map) {
  Flip flip;
  flip.map = std::move(map);
  const double pixels = static_cast<double>(flip.map.size());
  for (const float value : flip.map) {
    flip.mean += value;
    flip.share_above_02 += value > 0.2f ? 1.0 : 0.0;
  }
  flip.mean /= pixels;
  flip.share_above_02 /= pixels;
  flip.p99 = nth_smallest(flip.map, static_cast<size_t>(0.99 * (pixels - 1.0)));
  return flip;
}

std::vector<float> luminances_above_0(const Image& image, const ColorChannels& channels) {
  const auto red = image.plane(channels[0]), green = image.plane(channels[1]),
             blue = image.plane(channels[2]);
  std::vector<float> out;
  for (size_t i = 0; i < red.size(); ++i) {
    const float luminance = (kRelativeFromLinear * glm::vec3(red[i], green[i], blue[i])).y;
    if (luminance > 0.0f) out.push_back(luminance);
  }
  return out;
}

}  // namespace

FlipReference::FlipReference(const Image& reference, ColorChannels channels, const FlipSettings& settings)
    : channels_(std::move(channels)), settings_(settings) {
  require_settings(settings);
  require_picture(reference, channels_, 1.0f);
  seen_ = see_picture(encoded_source(reference, channels_), reference.width, reference.height,
                      settings.pixels_per_degree);
}

std::optional<Flip> FlipReference::measure(const Image& test) const {
  require_test(test, channels_, 1.0f, seen_.width, seen_.height);
  if (test.pixel_count() == 0) return std::nullopt;
  return summarised(flip_map(encoded_source(test, channels_), seen_, settings_.pixels_per_degree));
}

std::optional<Flip> measure_flip(const Image& test, const Image& reference, const ColorChannels& channels,
                                 const FlipSettings& settings) {
  require_same_size(test, reference, "FLIP");
  return FlipReference(reference, channels, settings).measure(test);
}

float aces_tone(float linear) {
  constexpr auto a = static_cast<float>(kA), b = static_cast<float>(kB), c = static_cast<float>(kC),
                 d = static_cast<float>(kD), e = static_cast<float>(kE);
  return linear * (a * linear + b) / (linear * (c * linear + d) + e);
}

std::optional<ExposureRange> exposure_range(const Image& reference, const ColorChannels& channels) {
  const std::vector<float> luminances = luminances_above_0(reference, channels);
  if (luminances.empty()) return std::nullopt;
  // The larger root of tone(x) = t, a quadratic: where the curve reaches t.
  const double square = kA - kBrightTone * kC, linear = kB - kBrightTone * kD, constant = -kBrightTone * kE;
  const double bright = (-linear + std::sqrt(linear * linear - 4.0 * square * constant)) / (2.0 * square);
  const double largest = *std::max_element(luminances.begin(), luminances.end());
  const double median = nth_smallest(luminances, luminances.size() / 2);
  ExposureRange range = {std::log2(bright / largest), std::log2(bright / median), 0};
  range.count = std::max(2, static_cast<int>(std::ceil(range.stop - range.start)));
  return range;
}

HdrFlipReference::HdrFlipReference(const Image& reference, ColorChannels channels,
                                   const FlipSettings& settings)
    : channels_(std::move(channels)),
      settings_(settings),
      width_(reference.width),
      height_(reference.height) {
  require_settings(settings);
  require_picture(reference, channels_, kHighest);
  const auto range = exposure_range(reference, channels_);
  for (int n = 0; range && n < range->count; ++n) {
    const double stops = range->start + (range->stop - range->start) * n / (range->count - 1);
    exposures_.push_back({stops, see_picture(exposed_source(reference, channels_, stops), width_, height_,
                                             settings.pixels_per_degree)});
  }
}

std::optional<Flip> HdrFlipReference::measure(const Image& test) const {
  require_test(test, channels_, kHighest, width_, height_);
  if (exposures_.empty()) return std::nullopt;
  std::vector<float> worst(test.pixel_count(), 0.0f);
  for (const Exposed& exposed : exposures_) {
    const std::vector<float> map =
        flip_map(exposed_source(test, channels_, exposed.stops), exposed.seen, settings_.pixels_per_degree);
    for (size_t i = 0; i < map.size(); ++i) worst[i] = std::max(worst[i], map[i]);
  }
  return summarised(std::move(worst));
}

std::optional<Flip> measure_hdr_flip(const Image& test, const Image& reference, const ColorChannels& channels,
                                     const FlipSettings& settings) {
  require_same_size(test, reference, "FLIP");
  return HdrFlipReference(reference, channels, settings).measure(test);
}

}  // namespace umbrameter
