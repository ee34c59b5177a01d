// SPDX-License-Identifier: Apache-2.0
#include "metrics/error/lit_error.h"

#include "core/error.h"
#include "core/statistics.h"
#include "metrics/image/checks.h"

#include <cmath>

namespace umbrameter {

std::optional<double> measure_lit_error(const Image& test, const Image& reference,
                                        std::span<const uint8_t> mask) {
  require_same_size(test, reference, "lit error");
  require_mask_size(reference, mask, "lit error");
  const auto v = test.plane("visibility"), e = reference.plane("unshadowed_irradiance");
  const auto a = reference.plane("irradiance_half_a"), b = reference.plane("irradiance_half_b");
  double squares = 0.0, light = 0.0;
  for (size_t i = 0; i < mask.size(); ++i) {
    if (mask[i] == 0) continue;
    const double weight = static_cast<double>(e[i]) * static_cast<double>(e[i]), value = v[i];
    squares += weight * (value - static_cast<double>(a[i])) * (value - static_cast<double>(b[i]));
    light += weight;
  }
  if (!(light > 0.0)) return std::nullopt;
  return signed_root(squares / light);
}

std::optional<ModelGap> measure_model_gap(const Image& reference, std::span<const uint8_t> mask) {
  require_mask_size(reference, mask, "model gap");
  const auto e = reference.plane("unshadowed_irradiance");
  const auto va = reference.plane("half_a"), vb = reference.plane("half_b");
  const auto sa = reference.plane("irradiance_half_a"), sb = reference.plane("irradiance_half_b");
  double squares = 0.0, pixels = 0.0, lit_squares = 0.0, light = 0.0;
  for (size_t i = 0; i < mask.size(); ++i) {
    if (mask[i] == 0) continue;
    const double product = (static_cast<double>(sa[i]) - static_cast<double>(va[i])) *
                           (static_cast<double>(sb[i]) - static_cast<double>(vb[i]));
    const double weight = static_cast<double>(e[i]) * static_cast<double>(e[i]);
    squares += product, pixels += 1.0;
    lit_squares += weight * product, light += weight;
  }
  if (!(light > 0.0)) return std::nullopt;
  return ModelGap{signed_root(squares / pixels), signed_root(lit_squares / light)};
}

}  // namespace umbrameter
