#include "metrics/flip.h"

#include "core/error.h"
#include "metrics/checks.h"
#include "metrics/flip_color.h"
#include "metrics/flip_features.h"
#include "metrics/separable_filter.h"
#include "metrics/tiles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace umbrameter {

namespace {

constexpr double kPi = std::numbers::pi;

// The paper's constants: colour exponent, knee of the colour curve.
constexpr float kColorExponent = 0.7f;
constexpr float kKneeAt = 0.4f, kKneeValue = 0.95f;

// A contrast sensitivity is a sum of a sqrt(pi / b) exp(-pi^2 d^2 / b), d in degrees (table 1).
struct Gaussian {
  double a, b;
};
constexpr std::array<Gaussian, 1> kAchromatic = {{{1.0, 0.0047}}};
constexpr std::array<Gaussian, 1> kRedGreen = {{{1.0, 0.0053}}};
constexpr std::array<Gaussian, 2> kBlueYellow = {{{34.1, 0.04}, {13.5, 0.025}}};
constexpr double kWidest = 0.04;

using Planes = std::array<std::vector<float>, 3>;

struct Picture {
  int width = 0, height = 0;
  Planes ycxcz;
};

Picture load(const Image& image, const ColorChannels& channels) {
  const std::array planes = {image.plane(channels[0]), image.plane(channels[1]), image.plane(channels[2])};
  Picture out = {image.width, image.height, {}};
  for (std::vector<float>& plane : out.ycxcz) plane.resize(image.pixel_count());
  for_each_row(image.height, [&](int y) {
    const size_t begin = static_cast<size_t>(y) * static_cast<size_t>(image.width);
    for (size_t i = begin; i < begin + static_cast<size_t>(image.width); ++i) {
      const glm::vec3 color = ycxcz_from_linear(
          {linear_from_srgb(planes[0][i]), linear_from_srgb(planes[1][i]), linear_from_srgb(planes[2][i])});
      for (int k = 0; k < 3; ++k) out.ycxcz[static_cast<size_t>(k)][i] = color[k];
    }
  });
  return out;
}

// Each Gaussian is separable; their weights in the sum are their shares of the two-dimensional kernel's mass.
std::vector<float> see(const Picture& picture, size_t channel, std::span<const Gaussian> sensitivity,
                       double ppd) {
  const int radius = static_cast<int>(std::ceil(3.0 * std::sqrt(kWidest / (2.0 * kPi * kPi)) * ppd));
  std::vector<double> mass;
  double total = 0.0;
  for (const Gaussian& g : sensitivity) {
    double row = 0.0;
    for (int k = -radius; k <= radius; ++k) row += std::exp(-kPi * kPi * k * k / (ppd * ppd * g.b));
    mass.push_back(g.a * std::sqrt(kPi / g.b) * row * row);
    total += mass.back();
  }
  std::vector<float> sum(picture.ycxcz[channel].size(), 0.0f);
  for (size_t n = 0; n < sensitivity.size(); ++n) {
    const double sigma_px = std::sqrt(sensitivity[n].b / (2.0 * kPi * kPi)) * ppd;
    // Beyond five sigma a weight is below a float's rounding of the sum.
    const Kernel kernel =
        gaussian_kernel(sigma_px, std::min(radius, static_cast<int>(std::ceil(5.0 * sigma_px))));
    const std::vector<float> seen =
        filter(picture.ycxcz[channel], picture.width, picture.height, kernel, kernel);
    const float weight = static_cast<float>(mass[n] / total);
    for (size_t i = 0; i < sum.size(); ++i) sum[i] += weight * seen[i];
  }
  return sum;
}

Planes seen_colors(const Picture& picture, double ppd) {
  Planes seen = {see(picture, 0, kAchromatic, ppd), see(picture, 1, kRedGreen, ppd),
                 see(picture, 2, kBlueYellow, ppd)};
  for_each_row(picture.height, [&](int y) {
    const size_t begin = static_cast<size_t>(y) * static_cast<size_t>(picture.width);
    for (size_t i = begin; i < begin + static_cast<size_t>(picture.width); ++i) {
      const glm::vec3 linear = linear_from_ycxcz({seen[0][i], seen[1][i], seen[2][i]});
      // Filtering can leave the display's gamut; the paper clamps to it.
      const glm::vec3 lab =
          hunt_lab_from_linear({std::clamp(linear.x, 0.0f, 1.0f), std::clamp(linear.y, 0.0f, 1.0f),
                                std::clamp(linear.z, 0.0f, 1.0f)});
      for (int k = 0; k < 3; ++k) seen[static_cast<size_t>(k)][i] = lab[k];
    }
  });
  return seen;
}

// Compresses differences above the knee: what is very different cannot become much more so.
float color_difference(const glm::vec3& a, const glm::vec3& b, float largest) {
  const float difference = std::pow(hyab_distance(a, b), kColorExponent);
  const float knee = kKneeAt * largest;
  if (difference < knee) return kKneeValue / knee * difference;
  return kKneeValue + (difference - knee) / (largest - knee) * (1.0f - kKneeValue);
}

// The largest difference a display can show: green against blue.
float largest_color_difference() {
  return std::pow(
      hyab_distance(hunt_lab_from_linear({0.0f, 1.0f, 0.0f}), hunt_lab_from_linear({0.0f, 0.0f, 1.0f})),
      kColorExponent);
}

void summarise(int width, int height, Flip& flip) {
  std::vector<double> rows(static_cast<size_t>(height), 0.0);
  for_each_row(height, [&](int y) {
    const size_t begin = static_cast<size_t>(y) * static_cast<size_t>(width);
    for (size_t i = begin; i < begin + static_cast<size_t>(width); ++i)
      rows[static_cast<size_t>(y)] += flip.map[i];
  });
  const double pixels = static_cast<double>(flip.map.size());
  for (const double row : rows) flip.mean += row / pixels;
  flip.share_above_02 =
      static_cast<double>(std::count_if(flip.map.begin(), flip.map.end(), [](float v) { return v > 0.2f; })) /
      pixels;
  std::vector<float> sorted = flip.map;
  const auto at = sorted.begin() + static_cast<std::ptrdiff_t>(0.99 * (pixels - 1.0));
  std::nth_element(sorted.begin(), at, sorted.end());
  flip.p99 = *at;
}

}  // namespace

std::optional<Flip> measure_flip(const Image& test, const Image& reference, const ColorChannels& channels,
                                 const FlipSettings& settings) {
  require_same_size(test, reference, "FLIP");
  if (!(settings.pixels_per_degree >= 1.0 && settings.pixels_per_degree <= 1000.0)) {
    fail_input(fmt::format("pixels_per_degree is {}", settings.pixels_per_degree), {}, "1 to 1000");
  }
  const std::vector<uint8_t> everywhere(test.pixel_count(), 1);
  for (const std::string& channel : channels) {
    require_range(test, channel, everywhere, 0.0f, 1.0f);
    require_range(reference, channel, everywhere, 0.0f, 1.0f);
  }
  if (test.pixel_count() == 0) return std::nullopt;

  const double ppd = settings.pixels_per_degree;
  const Picture a = load(test, channels), b = load(reference, channels);
  const Planes color_a = seen_colors(a, ppd), color_b = seen_colors(b, ppd);
  const Features feature_a = find_features(a.ycxcz[0], a.width, a.height, ppd);
  const Features feature_b = find_features(b.ycxcz[0], b.width, b.height, ppd);
  const float largest = largest_color_difference();
  Flip out;
  out.map.resize(test.pixel_count());
  for_each_row(test.height, [&](int y) {
    const size_t begin = static_cast<size_t>(y) * static_cast<size_t>(test.width);
    for (size_t i = begin; i < begin + static_cast<size_t>(test.width); ++i) {
      const float color = color_difference({color_a[0][i], color_a[1][i], color_a[2][i]},
                                           {color_b[0][i], color_b[1][i], color_b[2][i]}, largest);
      const float feature = std::sqrt(std::max(std::abs(feature_a.edge[i] - feature_b.edge[i]),
                                               std::abs(feature_a.point[i] - feature_b.point[i])) /
                                      std::numbers::sqrt2_v<float>);
      out.map[i] = std::pow(color, 1.0f - std::min(feature, 1.0f));
    }
  });
  summarise(test.width, test.height, out);
  return out;
}

}  // namespace umbrameter
