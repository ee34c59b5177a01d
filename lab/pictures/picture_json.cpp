// SPDX-License-Identifier: Apache-2.0
#include "lab/pictures/picture_json.h"

#include "results/catalogue.h"
#include "results/json/json_parts.h"
#include "results/json/run_json.h"

namespace umbrameter {
namespace {

using OrderedJson = nlohmann::ordered_json;

}  // namespace

OrderedJson picture_json(const PictureScore& picture, const std::string& test_file,
                         const std::string& reference_file) {
  const Score& score = picture.score;
  const ParityNumbers numbers = parity_numbers(score.parity);
  OrderedJson parity = parity_json(score.has_surfaces ? std::optional(numbers) : std::nullopt);
  if (!parity.is_null()) parity.erase("picture_file");
  OrderedJson json{{"test", test_file},
                   {"reference", reference_file},
                   {"quantity", to_text(picture.quantity)},
                   {"quantity_given", picture.is_quantity_given},
                   {"other_rmse", interval_json(picture.other_rmse)},
                   {"parity", parity},
                   {"scorable_pixels", score.scorable_pixels}};
  add_measures(result_of(score), json);
  json["no_diagnosis"] = failure_json(score.no_diagnosis);
  json["notes"] = picture.notes;
  json["mean_square_rounding"] = picture.mean_square_rounding;
  return json;
}

}  // namespace umbrameter
