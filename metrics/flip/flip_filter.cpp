// SPDX-License-Identifier: Apache-2.0
#include "metrics/flip/flip_filter.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace umbrameter {

namespace {

constexpr double kPi = std::numbers::pi;

// A contrast sensitivity is a sum of a sqrt(pi / b) exp(-pi^2 d^2 / b), d in degrees (the paper's table 1).
struct Sensitivity {
  double a, b;
  double sigma_deg() const { return std::sqrt(b / (2.0 * kPi * kPi)); }
};
constexpr Sensitivity kLuminanceSensitivity = {1.0, 0.0047};
constexpr Sensitivity kRedGreenSensitivity = {1.0, 0.0053};
constexpr std::array<Sensitivity, 2> kBlueYellowSensitivity = {{{34.1, 0.04}, {13.5, 0.025}}};
constexpr double kFeatureWidth_deg = 0.082;

double gaussian(int k, double sigma_px) {
  return std::exp(-0.5 * k * k / (sigma_px * sigma_px));
}

// Both sides together.
double mass(double sigma_px, int radius) {
  double sum = 0.0;
  for (int k = -radius; k <= radius; ++k) sum += gaussian(k, sigma_px);
  return sum;
}

HalfKernel even_gaussian(double sigma_px, int radius, double sum) {
  HalfKernel kernel;
  for (int k = 0; k <= radius; ++k) {
    kernel.push_back(static_cast<float>(sum * gaussian(k, sigma_px) / mass(sigma_px, radius)));
  }
  return kernel;
}

// Beyond five sigma a weight is below a float's rounding of the sum.
HalfKernel seen_through(const Sensitivity& sensitivity, double ppd, int radius, double share) {
  const double sigma_px = sensitivity.sigma_deg() * ppd;
  return even_gaussian(sigma_px, std::min(radius, static_cast<int>(std::ceil(5.0 * sigma_px))), share);
}

// A Gaussian's share of the two-dimensional kernel's mass.
std::array<double, 2> blue_yellow_shares(double ppd, int radius) {
  std::array<double, 2> shares{};
  for (size_t n = 0; n < 2; ++n) {
    const double row = mass(kBlueYellowSensitivity[n].sigma_deg() * ppd, radius);
    shares[n] = kBlueYellowSensitivity[n].a * std::sqrt(kPi / kBlueYellowSensitivity[n].b) * row * row;
  }
  const double total = shares[0] + shares[1];
  return {shares[0] / total, shares[1] / total};
}

// Positive weights of the whole kernel add up to 1, negative ones to -1.
HalfKernel balanced(std::span<const double> weights, bool is_odd) {
  double positive = 0.0, negative = 0.0;
  for (size_t k = 0; k < weights.size(); ++k) {
    const double both_sides = k == 0 || is_odd ? 1.0 : 2.0;
    (weights[k] > 0.0 ? positive : negative) += both_sides * std::abs(weights[k]);
  }
  HalfKernel kernel;
  for (const double w : weights) kernel.push_back(static_cast<float>(w / (w > 0.0 ? positive : negative)));
  return kernel;
}

struct Even {
  static float pair(float left, float right) { return left + right; }
};
struct Odd {
  static float pair(float left, float right) { return right - left; }
};

// Sums of one output in a block.
template <class Parity, size_t kBlock>
struct Output {
  const HalfKernel& kernel;
  float* to;
  std::array<float, kBlock> sum{};

  void begin(const float* centre) {
    for (size_t j = 0; j < kBlock; ++j) sum[j] = kernel[0] * centre[j];
  }
  void add(size_t k, const float* left, const float* right) {
    const float weight = kernel[k];
    for (size_t j = 0; j < kBlock; ++j) sum[j] += weight * Parity::pair(left[j], right[j]);
  }
  void end(size_t x) { std::copy(sum.begin(), sum.end(), to + x); }
};

// A block's sums stay in registers while the taps pass by, and a tap is read once for all outputs, whose kernels have
// one radius; the order of summation is fixed. Narrower blocks for more outputs, as registers are few.
template <size_t kBlock, class... Outputs>
void filter_taps(Taps centre, size_t radius, size_t count, Outputs... outputs) {
  static_assert(kFilterBlock % kBlock == 0);
  for (size_t x = 0; x < count; x += kBlock) {
    (outputs.begin(centre[0] + x), ...);
    for (size_t k = 1; k <= radius; ++k) {
      const std::ptrdiff_t tap = static_cast<std::ptrdiff_t>(k);
      (outputs.add(k, centre[-tap] + x, centre[tap] + x), ...);
    }
    (outputs.end(x), ...);
  }
}

template <class Parity>
using Wide = Output<Parity, kFilterBlock>;
template <class Parity>
using Narrow = Output<Parity, kFilterBlock / 2>;

}  // namespace

ObserverKernels observer_kernels(double ppd) {
  const int radius = static_cast<int>(std::ceil(3.0 * kBlueYellowSensitivity[0].sigma_deg() * ppd));
  const std::array<double, 2> shares = blue_yellow_shares(ppd, radius);
  ObserverKernels out;
  out.luminance = seen_through(kLuminanceSensitivity, ppd, radius, 1.0);
  out.red_green = seen_through(kRedGreenSensitivity, ppd, radius, 1.0);
  for (size_t n = 0; n < 2; ++n) {
    out.blue_yellow_rows[n] = seen_through(kBlueYellowSensitivity[n], ppd, radius, 1.0);
    out.blue_yellow_columns[n] = seen_through(kBlueYellowSensitivity[n], ppd, radius, shares[n]);
  }
  const double sigma_px = 0.5 * kFeatureWidth_deg * ppd;
  const int feature_radius = static_cast<int>(std::ceil(3.0 * sigma_px));
  std::vector<double> first, second;
  for (int k = 0; k <= feature_radius; ++k) {
    first.push_back(-k * gaussian(k, sigma_px));
    second.push_back((k * k / (sigma_px * sigma_px) - 1.0) * gaussian(k, sigma_px));
  }
  out.smooth = even_gaussian(sigma_px, feature_radius, 1.0);
  out.edge = balanced(first, true);
  out.point = balanced(second, false);
  out.radius = static_cast<size_t>(std::max(radius, feature_radius));
  return out;
}

void filter_even(Taps centre, const HalfKernel& kernel, size_t count, float* to) {
  filter_taps<kFilterBlock>(centre, kernel.size() - 1, count, Wide<Even>{kernel, to});
}

void filter_pair(Taps centre, const std::array<HalfKernel, 2>& kernels, size_t count,
                 const std::array<float*, 2>& to) {
  filter_taps<kFilterBlock / 2>(centre, kernels[0].size() - 1, count, Narrow<Even>{kernels[0], to[0]},
                                Narrow<Even>{kernels[1], to[1]});
}

void filter_derivatives(Taps centre, const ObserverKernels& kernels, size_t count, float* edge,
                        float* point) {
  filter_taps<kFilterBlock / 2>(centre, kernels.edge.size() - 1, count, Narrow<Odd>{kernels.edge, edge},
                                Narrow<Even>{kernels.point, point});
}

void filter_features(Taps centre, const ObserverKernels& kernels, size_t count, float* smooth, float* edge,
                     float* point) {
  filter_taps<kFilterBlock / 2>(centre, kernels.edge.size() - 1, count, Narrow<Even>{kernels.smooth, smooth},
                                Narrow<Odd>{kernels.edge, edge}, Narrow<Even>{kernels.point, point});
}

}  // namespace umbrameter
