#include "metrics/flip_filter.h"

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
constexpr Sensitivity kLuminance = {1.0, 0.0047};
constexpr Sensitivity kRedGreen = {1.0, 0.0053};
constexpr std::array<Sensitivity, 2> kBlueYellow = {{{34.1, 0.04}, {13.5, 0.025}}};
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
    const double row = mass(kBlueYellow[n].sigma_deg() * ppd, radius);
    shares[n] = kBlueYellow[n].a * std::sqrt(kPi / kBlueYellow[n].b) * row * row;
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

// A block's sums stay in registers while the taps pass by; the order of summation is fixed.
template <class Parity>
void add_taps(const float* const* centre, const HalfKernel& kernel, size_t count, float* to) {
  for (size_t x = 0; x < count; x += kFilterBlock) {
    std::array<float, kFilterBlock> sum;
    for (size_t j = 0; j < kFilterBlock; ++j) sum[j] = to[x + j] + kernel[0] * centre[0][x + j];
    for (std::ptrdiff_t k = 1; k < std::ssize(kernel); ++k) {
      const float weight = kernel[static_cast<size_t>(k)];
      const float *left = centre[-k] + x, *right = centre[k] + x;
      for (size_t j = 0; j < kFilterBlock; ++j) sum[j] += weight * Parity::pair(left[j], right[j]);
    }
    for (size_t j = 0; j < kFilterBlock; ++j) to[x + j] = sum[j];
  }
}

}  // namespace

ObserverKernels observer_kernels(double ppd) {
  const int radius = static_cast<int>(std::ceil(3.0 * kBlueYellow[0].sigma_deg() * ppd));
  const std::array<double, 2> shares = blue_yellow_shares(ppd, radius);
  ObserverKernels out;
  out.luminance = seen_through(kLuminance, ppd, radius, 1.0);
  out.red_green = seen_through(kRedGreen, ppd, radius, 1.0);
  for (size_t n = 0; n < 2; ++n) {
    out.blue_yellow_rows[n] = seen_through(kBlueYellow[n], ppd, radius, 1.0);
    out.blue_yellow_columns[n] = seen_through(kBlueYellow[n], ppd, radius, shares[n]);
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

void add_even(const float* const* centre, const HalfKernel& kernel, size_t count, float* to) {
  add_taps<Even>(centre, kernel, count, to);
}

void add_odd(const float* const* centre, const HalfKernel& kernel, size_t count, float* to) {
  add_taps<Odd>(centre, kernel, count, to);
}

}  // namespace umbrameter
