// SPDX-License-Identifier: Apache-2.0
#include "results/similarity_format.h"

#include "results/format.h"

#include <fmt/format.h>

#include <cmath>

namespace umbrameter {
namespace {

std::string number(const std::optional<double>& value) {
  return value ? fmt::format("{:.4f}", *value) : kNotApplicable;
}

std::string decibels(const std::optional<double>& value) {
  if (!value) return kNotApplicable;
  return std::isfinite(*value) ? fmt::format("{:.2f} dB", *value) : "infinite";
}

}  // namespace

TermLines similarity_lines(const Similarity& similarity) {
  return {{"FLIP (lit)",
           fmt::format("{} LDR, {} HDR on average, at {:.3g} pixels a degree", number(similarity.flip_mean),
                       number(similarity.hdr_flip_mean), similarity.pixels_per_degree)},
          {"SSIM, PSNR (lit)", fmt::format("{}, {}", number(similarity.ssim), decibels(similarity.psnr_db))}};
}

}  // namespace umbrameter
