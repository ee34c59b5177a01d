// SPDX-License-Identifier: Apache-2.0
#include "lab/pictures/picture_score.h"

#include "core/error.h"

#include <fmt/format.h>

#include <cmath>

namespace umbrameter {
namespace {

constexpr double kOtherQuantityShare = 0.5;  // of the RMSE: the other quantity is named

void require_size(const EngineImage& picture, const std::string& name, const Image& reference) {
  if (picture.width == reference.width && picture.height == reference.height) return;
  fail_input(fmt::format("'{}' is {} x {} px and the reference {} x {}", name, picture.width, picture.height,
                         reference.width, reference.height),
             {}, "render the picture at the reference's size; scaling would make other shadows");
}

std::string pixels(size_t count) {
  return fmt::format("{} {}", count, count == 1 ? "pixel" : "pixels");
}

void note_left_out(const EngineVisibility& values, std::vector<std::string>& notes) {
  if (values.missing > 0)
    notes.push_back(pixels(values.missing) + " left out: outside the picture's data window");
  if (values.dark > 0)
    notes.push_back(pixels(values.dark) + " left out: so dark without shadows that their ratio is 0 / 0");
  if (values.brighter > 0)
    notes.push_back(pixels(values.brighter) + " left out: brighter with shadows than without");
  if (values.nudged > 0)
    notes.push_back(fmt::format("{} up to {:.2g} outside [0, 1]: set to 0 or 1", pixels(values.nudged),
                                values.largest_nudge));
  if (values.largest_step > 0.0)
    notes.push_back(fmt::format(
        "the pictures' steps are up to {:.4f} of visibility; their rounding, {:.5f} in the root mean "
        "square, is added to the uncertainty",
        values.largest_step, std::sqrt(values.mean_square_rounding)));
}

void take_surfaces(const PictureInput& input, SurfaceReading reading, const Image& reference,
                   EnginePicture& out) {
  const bool is_own_file = input.files.surfaces.empty();
  EngineSurfaces surfaces =
      read_surfaces(is_own_file ? std::vector{input.files.name()} : input.files.surfaces);
  if (is_own_file) surfaces.not_understood.clear();  // nobody promised any
  const bool has_position = surfaces.channels.has("position.x");
  const bool drops_depth = is_own_file && !has_position && reading.camera == nullptr &&
                           surfaces.channels.planes.erase("depth") > 0;
  if (drops_depth && input.files.choice.channel.empty())
    out.notes.push_back(
        "the picture's depth is not looked at: where points are needs the camera, give --scene");
  for (std::string& note : add_surfaces(surfaces, reading, reference, out.test))
    out.notes.push_back(std::move(note));
  if (!surfaces.understood() && is_own_file)
    out.notes.push_back(
        "no surface channels: not known whether the picture shows the same places under the same light; give "
        "--surfaces");
}

Score score_as(const EnginePicture& picture, const Image& reference, const glm::dvec3& eye_world,
               const ScoreSettings& settings) {
  Score score = score_image(picture.test, reference, eye_world, settings);
  if (!score.error) return score;
  widen_by_rounding(picture.values.mean_square_rounding, *score.error);
  if (settings.limit_rmse)
    score.judgement.limit = judge_against(*settings.limit_rmse, *score.error, reference, score.mask);
  return score;
}

double size_of(const std::optional<Interval>& rmse) {
  return rmse ? std::abs(rmse->value) : 0.0;
}

void note_readings(const EnginePicture& picture, PictureScore& out) {
  if (is_inverted(picture.test, out.reference, picture.values.known)) {
    out.notes.emplace_back(
        "the picture fits the truth far better when it is inverted: it seems to hold shadow, not visibility");
    return;
  }
  if (out.score.has_surfaces && out.score.parity.passes) return;
  if (const auto better = better_alignment(picture.test, out.reference, picture.values.known))
    out.notes.push_back("the picture fits the truth far better when it is read " + *better);
}

}  // namespace

PictureInput read_picture_input(const PictureFiles& files) {
  PictureInput input;
  input.files = files;
  input.picture = read_engine_image(files.name(), files.transfer, files.choice);
  if (files.is_pair()) input.unshadowed = read_engine_image(files.unshadowed, files.transfer, files.choice);
  return input;
}

EnginePicture align_picture(const PictureInput& input, const SurfaceReading& reading,
                            const Image& reference) {
  const std::vector<uint8_t> scorable = scorable_mask(reference);
  EnginePicture out;
  out.name = input.files.name();
  out.is_pair = input.files.is_pair();
  out.notes = input.picture.notes;
  require_size(input.picture, out.name, reference);
  if (out.is_pair) {
    out.notes.insert(out.notes.end(), input.unshadowed.notes.begin(), input.unshadowed.notes.end());
    if (is_swapped(input.picture, input.unshadowed, reference, scorable))
      fail_input(fmt::format("the pair is swapped: '{}' is brighter than '{}' in what the truth calls shadow",
                             input.files.shadowed, input.files.unshadowed),
                 {}, "give the picture with shadows as --shadowed");
    out.values = visibility_of_pair(input.picture, input.unshadowed, scorable);
  } else {
    out.values = visibility_of(input.picture, scorable);
  }
  out.test = std::move(out.values.image);
  take_surfaces(input, reading, reference, out);
  note_left_out(out.values, out.notes);
  return out;
}

PictureScore score_picture(const EnginePicture& picture, const Image& reference, const glm::dvec3& eye_world,
                           ScoreSettings settings, std::optional<ShadowQuantity> quantity) {
  settings.known = picture.values.known;
  PictureScore out;
  out.notes = picture.notes;
  out.mean_square_rounding = picture.values.mean_square_rounding;
  out.is_quantity_given = quantity.has_value();
  out.quantity = quantity.value_or(ShadowQuantity::visibility);
  const bool knows_other = !quantity && reference.has("irradiance_half_a");
  ScoreSettings error_only;
  error_only.metrics = choose_metrics("error");
  error_only.known = settings.known;
  const auto truth_of = [&](ShadowQuantity wanted) {
    Image truth = with_quantity(reference, wanted);
    add_rounding(picture.values, truth);
    return truth;
  };
  if (knows_other) {
    const Score v = score_as(picture, truth_of(ShadowQuantity::visibility), eye_world, error_only);
    const Score s = score_as(picture, truth_of(ShadowQuantity::irradiance), eye_world, error_only);
    if (v.error && s.error) {
      const double rmse_v = size_of(v.error->rmse), rmse_s = size_of(s.error->rmse);
      if (picture.is_pair && rmse_s < rmse_v) out.quantity = ShadowQuantity::irradiance;
      out.other_rmse = out.quantity == ShadowQuantity::visibility ? s.error->rmse : v.error->rmse;
      if (!picture.is_pair && rmse_s < kOtherQuantityShare * rmse_v)
        out.notes.push_back(
            fmt::format("the picture fits the irradiance ratio far better than visibility (RMSE {:.5f} "
                        "instead of {:.5f}): "
                        "see --quantity",
                        rmse_s, rmse_v));
    }
  }
  out.reference = truth_of(out.quantity);
  out.score = score_as(picture, out.reference, eye_world, settings);
  note_readings(picture, out);
  return out;
}

void widen_by_rounding(double mean_square_rounding, VisibilityError& error) {
  if (!(mean_square_rounding > 0.0) || !error.mse || !error.rmse) return;
  error.mse->low -= mean_square_rounding;
  error.rmse->low = std::copysign(std::sqrt(std::abs(error.mse->low)), error.mse->low);
}

}  // namespace umbrameter
