// SPDX-License-Identifier: Apache-2.0
#include "results/json/similarity_json.h"

#include "results/json/json_optional.h"

#include <cmath>
#include <limits>

namespace umbrameter {

nlohmann::ordered_json similarity_json(const std::optional<Similarity>& similarity) {
  if (!similarity) return nullptr;
  const bool is_finite = similarity->psnr_db && std::isfinite(*similarity->psnr_db);
  return {{"pixels_per_degree", similarity->pixels_per_degree},
          {"flip_mean", optional_json(similarity->flip_mean)},
          {"flip_p99", optional_json(similarity->flip_p99)},
          {"flip_share_above_02", optional_json(similarity->flip_share_above_02)},
          {"hdr_flip_mean", optional_json(similarity->hdr_flip_mean)},
          {"hdr_flip_p99", optional_json(similarity->hdr_flip_p99)},
          {"ssim", optional_json(similarity->ssim)},
          {"psnr_db", is_finite ? optional_json(similarity->psnr_db) : nlohmann::ordered_json(nullptr)}};
}

std::optional<Similarity> read_similarity(const nlohmann::json& json) {
  if (json.is_null()) return std::nullopt;
  Similarity similarity = {json.at("pixels_per_degree"),
                           read_optional<double>(json.at("flip_mean")),
                           read_optional<double>(json.at("flip_p99")),
                           read_optional<double>(json.at("flip_share_above_02")),
                           read_optional<double>(json.at("hdr_flip_mean")),
                           read_optional<double>(json.at("hdr_flip_p99")),
                           read_optional<double>(json.at("ssim")),
                           read_optional<double>(json.at("psnr_db"))};
  if (!similarity.psnr_db && similarity.flip_mean)
    similarity.psnr_db = std::numeric_limits<double>::infinity();
  return similarity;
}

}  // namespace umbrameter
