#include "study/similarity.h"

#include "metrics/checks.h"
#include "metrics/flip.h"
#include "metrics/similarity.h"

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

Image lit_picture(const Image& image, const Image& reference, std::span<const uint8_t> mask) {
  Image lit(image.width, image.height);
  const std::vector<float> linear = lit_plane(image, reference, mask);
  std::ranges::copy(linear, lit.add_plane(kLinear).begin());
  std::ranges::transform(linear, lit.add_plane(kEncoded).begin(),
                         [](float value) { return std::min(1.0f, srgb_from_linear(value)); });
  return lit;
}

}  // namespace

std::vector<float> lit_plane(const Image& image, const Image& reference, std::span<const uint8_t> mask) {
  require_visibility(image, "visibility", mask);
  require_range(reference, "unshadowed_irradiance", mask, 0.0f, std::numeric_limits<float>::max());
  const std::span<const float> v = image.plane("visibility"), e = reference.plane("unshadowed_irradiance");
  float largest = 0.0f;
  for (size_t i = 0; i < e.size(); ++i) largest = mask[i] != 0 ? std::max(largest, e[i]) : largest;
  std::vector<float> lit(v.size(), 0.0f);
  if (largest == 0.0f) return lit;
  for (size_t i = 0; i < v.size(); ++i) lit[i] = mask[i] != 0 ? v[i] * (e[i] / largest) : 0.0f;
  return lit;
}

Similarity measure_similarity(const Image& test, const Image& reference, std::span<const uint8_t> mask,
                              Image* maps) {
  const FlipSettings settings;
  const Image seen = lit_picture(test, reference, mask), truth = lit_picture(reference, reference, mask);
  Similarity out;
  out.pixels_per_degree = settings.pixels_per_degree;
  if (const auto flip = measure_flip(seen, truth, {kEncoded, kEncoded, kEncoded}, settings)) {
    out.flip_mean = flip->mean;
    out.flip_p99 = flip->p99;
    out.flip_share_above_02 = flip->share_above_02;
    if (maps != nullptr) std::ranges::copy(flip->map, maps->add_plane("flip").begin());
  }
  if (const auto flip = measure_hdr_flip(seen, truth, {kLinear, kLinear, kLinear}, settings)) {
    out.hdr_flip_mean = flip->mean;
    out.hdr_flip_p99 = flip->p99;
  }
  out.ssim = measure_ssim(seen, truth, kEncoded);
  out.psnr_db = measure_psnr_db(seen, truth, kEncoded);
  return out;
}

}  // namespace umbrameter
