// SPDX-License-Identifier: Apache-2.0
#include "reference/patch_irradiance.h"

#include "reference/shadow_rays.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace umbrameter {

namespace {

/// Points of a patch as 32-bit fractions, which a stream reads as signed, and their weights: whole batches.
struct Rule {
  std::vector<uint32_t> a, b;
  std::vector<float> weights;

  void add(double at_a, double at_b, double weight) {
    const auto fraction = [](double at) { return static_cast<uint32_t>(static_cast<int32_t>(at * 0x1p31)); };
    a.push_back(fraction(at_a));
    b.push_back(fraction(at_b));
    weights.push_back(static_cast<float>(weight));
  }
};

struct Node {
  double at = 0.0;  // in [-1, 1]
  double weight = 0.0;
};

/// Gauss and Legendre's four; the weights add up to 1.
std::array<Node, 4> gauss_nodes() {
  const double inner = std::sqrt(3.0 / 7.0 - 2.0 / 7.0 * std::sqrt(1.2));
  const double outer = std::sqrt(3.0 / 7.0 + 2.0 / 7.0 * std::sqrt(1.2));
  const double more = (18.0 + std::sqrt(30.0)) / 72.0, less = (18.0 - std::sqrt(30.0)) / 72.0;
  return {{{-outer, less}, {-inner, more}, {inner, more}, {outer, less}}};
}

Rule square_rule() {
  Rule rule;
  for (const Node& a : gauss_nodes()) {
    for (const Node& b : gauss_nodes()) rule.add(a.at, b.at, a.weight * b.weight);
  }
  return rule;
}

/// Gauss in the square of the radius, eight directions in turn. In the square that is mapped onto the disk these go
/// through (1, 1/2) and its mirror images.
Rule disk_rule() {
  Rule rule;
  for (const Node& node : gauss_nodes()) {
    const double radius = std::sqrt(0.5 + 0.5 * node.at);
    for (const double sign_a : {-radius, radius}) {
      for (const double sign_b : {-radius, radius}) {
        rule.add(sign_a, 0.5 * sign_b, 0.125 * node.weight);
        rule.add(0.5 * sign_a, sign_b, 0.125 * node.weight);
      }
    }
  }
  return rule;
}

/// Midpoints of side x side cells.
Rule grid_rule(int side) {
  Rule rule;
  for (int i = 0; i < side * side; ++i) {
    rule.add((2.0 * (i % side) + 1.0) / side - 1.0, (2.0 * (i / side) + 1.0) / side - 1.0,
             1.0 / (side * side));
  }
  return rule;
}

double mean_over(const Rule& rule, const LightPatch& patch) {
  thread_local ShadowRayBatch batch(glm::vec3(0.0f));  // costs as much to set up as a rule to sum
  const SampleStream stream{rule.a.data(), rule.b.data(), 0, 0};
  const auto points = static_cast<uint32_t>(rule.weights.size());
  Lanes sums{};
  for (uint32_t first = 0; first < points; first += kBatch) {
    make_shadow_rays(patch, stream, first, points, batch);
    const float* weights = rule.weights.data() + first;
    for (uint32_t i = 0; i < kBatch; ++i) sums[i] += batch.weight[i] * weights[i];
  }
  double sum = 0.0;
  for (const float each : sums) sum += static_cast<double>(each);
  return sum;
}

}  // namespace

double unshadowed_irradiance(const LightPatch& patch) {
  static const Rule square = square_rule(), disk = disk_rule(), grid = grid_rule(32);
  if (patch.dark) return 0.0;
  if (straddles_horizon(patch)) return mean_over(grid, patch);
  return mean_over(patch.round ? disk : square, patch);
}

}  // namespace umbrameter
