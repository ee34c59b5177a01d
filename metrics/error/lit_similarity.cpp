// SPDX-License-Identifier: Apache-2.0
#include "metrics/error/lit_similarity.h"

#include "metrics/error/similarity.h"
#include "metrics/image/checks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace umbrameter {
namespace {

const std::string kLinear = "lit_linear", kEncoded = "lit_srgb";

// IEC 61966-2-1.
float srgb_from_linear(float linear) {
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

// Light over the largest scored one; 0 where `mask` is.
std::vector<float> gain_of(const Image& reference, std::span<const uint8_t> mask) {
  require_range(reference, "unshadowed_irradiance", mask, 0.0f, std::numeric_limits<float>::max());
  const std::span<const float> e = reference.plane("unshadowed_irradiance");
  float largest = 0.0f;
  for (size_t i = 0; i < e.size(); ++i) largest = mask[i] != 0 ? std::max(largest, e[i]) : largest;
  std::vector<float> gain(e.size(), 0.0f);
  if (largest == 0.0f) return gain;
  for (size_t i = 0; i < e.size(); ++i) gain[i] = mask[i] != 0 ? e[i] / largest : 0.0f;
  return gain;
}

std::vector<float> lit_by(const Image& image, std::span<const float> gain, std::span<const uint8_t> mask) {
  require_visibility(image, "visibility", mask);
  const std::span<const float> v = image.plane("visibility");
  std::vector<float> lit(v.size(), 0.0f);
  for (size_t i = 0; i < v.size(); ++i) lit[i] = mask[i] != 0 ? v[i] * gain[i] : 0.0f;
  return lit;
}

Image lit_picture(const Image& image, std::span<const float> gain, std::span<const uint8_t> mask) {
  Image lit(image.width, image.height);
  const std::vector<float> linear = lit_by(image, gain, mask);
  std::ranges::copy(linear, lit.add_plane(kLinear).begin());
  std::ranges::transform(linear, lit.add_plane(kEncoded).begin(),
                         [](float value) { return std::min(1.0f, srgb_from_linear(value)); });
  return lit;
}

}  // namespace

std::vector<float> lit_plane(const Image& image, const Image& reference, std::span<const uint8_t> mask) {
  require_visibility(image, "visibility", mask);
  return lit_by(image, gain_of(reference, mask), mask);
}

SimilarityReference::SimilarityReference(const Image& reference, std::span<const uint8_t> mask)
    : mask_(mask.begin(), mask.end()),
      gain_(gain_of(reference, mask)),
      lit_(lit_picture(reference, gain_, mask)),
      flip_(lit_, {kEncoded, kEncoded, kEncoded}),
      hdr_flip_(lit_, {kLinear, kLinear, kLinear}) {}

Similarity SimilarityReference::measure(const Image& test, Image* maps) const {
  require_same_size(test, lit_, "similarity");
  const Image seen = lit_picture(test, gain_, mask_);
  Similarity out;
  out.pixels_per_degree = FlipSettings{}.pixels_per_degree;
  if (const auto flip = flip_.measure(seen)) {
    out.flip_mean = flip->mean;
    out.flip_p99 = flip->p99;
    out.flip_share_above_02 = flip->share_above_02;
    if (maps != nullptr) std::ranges::copy(flip->map, maps->add_plane("flip").begin());
  }
  if (const auto flip = hdr_flip_.measure(seen)) {
    out.hdr_flip_mean = flip->mean;
    out.hdr_flip_p99 = flip->p99;
  }
  out.ssim = measure_ssim(seen, lit_, kEncoded);
  out.psnr_db = measure_psnr_db(seen, lit_, kEncoded);
  return out;
}

Similarity measure_similarity(const Image& test, const Image& reference, std::span<const uint8_t> mask,
                              Image* maps) {
  return SimilarityReference(reference, mask).measure(test, maps);
}

}  // namespace umbrameter
