// SPDX-License-Identifier: Apache-2.0
#include "metrics/error/similarity.h"

#include "metrics/image/checks.h"
#include "metrics/image/separable_filter.h"
#include "metrics/image/tiles.h"

#include <cmath>
#include <limits>

namespace umbrameter {

namespace {

constexpr int kRadius = 5;
constexpr double kSigma = 1.5;
constexpr float kLuminanceGuard = 0.01f * 0.01f;
constexpr float kContrastGuard = 0.03f * 0.03f;

void require_pictures(const Image& test, const Image& reference, const std::string& channel) {
  require_same_size(test, reference, "similarity");
  const std::vector<uint8_t> everywhere(test.pixel_count(), 1);
  require_range(test, channel, everywhere, 0.0f, 1.0f);
  require_range(reference, channel, everywhere, 0.0f, 1.0f);
}

std::vector<float> product(std::span<const float> a, std::span<const float> b) {
  std::vector<float> out(a.size());
  for (size_t i = 0; i < out.size(); ++i) out[i] = a[i] * b[i];
  return out;
}

// Sum of value(i) over x0 <= x < x1 of each row in y0..y1, added up in order.
template <class Value>
double sum_of(int width, int x0, int x1, int y0, int y1, const Value& value) {
  std::vector<double> rows(static_cast<size_t>(y1 - y0), 0.0);
  for_each_row(y1 - y0, [&](int row) {
    const size_t begin = static_cast<size_t>(y0 + row) * static_cast<size_t>(width);
    for (int x = x0; x < x1; ++x) rows[static_cast<size_t>(row)] += value(begin + static_cast<size_t>(x));
  });
  double sum = 0.0;
  for (const double row : rows) sum += row;
  return sum;
}

}  // namespace

std::optional<double> measure_psnr_db(const Image& test, const Image& reference, const std::string& channel) {
  require_pictures(test, reference, channel);
  if (test.pixel_count() == 0) return std::nullopt;
  const std::span<const float> a = test.plane(channel), b = reference.plane(channel);
  const double sum = sum_of(test.width, 0, test.width, 0, test.height, [&](size_t i) {
    const double difference = static_cast<double>(a[i]) - b[i];
    return difference * difference;
  });
  if (sum == 0.0) return std::numeric_limits<double>::infinity();
  return -10.0 * std::log10(sum / static_cast<double>(test.pixel_count()));
}

std::optional<double> measure_ssim(const Image& test, const Image& reference, const std::string& channel) {
  require_pictures(test, reference, channel);
  const int width = test.width, height = test.height;
  if (width <= 2 * kRadius || height <= 2 * kRadius) return std::nullopt;
  const std::span<const float> a = test.plane(channel), b = reference.plane(channel);
  const Kernel window = gaussian_kernel(kSigma, kRadius);
  const auto local_mean = [&](std::span<const float> plane) {
    return filter(plane, width, height, window, window);
  };
  const std::vector<float> mean_a = local_mean(a), mean_b = local_mean(b);
  const std::vector<float> aa = local_mean(product(a, a)), bb = local_mean(product(b, b)),
                           ab = local_mean(product(a, b));
  const double sum = sum_of(width, kRadius, width - kRadius, kRadius, height - kRadius, [&](size_t i) {
    const float ma = mean_a[i], mb = mean_b[i];
    const float luminance = (2.0f * ma * mb + kLuminanceGuard) / (ma * ma + mb * mb + kLuminanceGuard);
    const float structure =
        (2.0f * (ab[i] - ma * mb) + kContrastGuard) / (aa[i] - ma * ma + bb[i] - mb * mb + kContrastGuard);
    return static_cast<double>(luminance * structure);
  });
  return sum / (static_cast<double>(width - 2 * kRadius) * static_cast<double>(height - 2 * kRadius));
}

}  // namespace umbrameter
