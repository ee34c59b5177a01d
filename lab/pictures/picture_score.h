// SPDX-License-Identifier: Apache-2.0
#pragma once
// Pictures of another renderer scored against the truth: read, made visibility, aligned, compared with the right quantity.
// What `score` and engines ask. Not here: files (lab/pictures/engine_file.h) and results folders.

#include "lab/pictures/engine_image.h"
#include "lab/pictures/engine_surfaces.h"
#include "lab/score.h"
#include "metrics/image/shadow_quantity.h"

#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

/// The files of one picture: visibility, or the scene lit with and without shadows.
struct PictureFiles {
  std::string picture;
  std::string shadowed, unshadowed;  // instead of `picture`
  std::string transfer;              // of files of 8 and 16 bits
  PictureChoice choice;              // of part and channel
  std::vector<std::string>
      surfaces;  // as read_surfaces has them; empty: whatever surfaces the picture's own file has

  bool is_pair() const { return picture.empty(); }
  const std::string& name() const { return is_pair() ? shadowed : picture; }
};

/// Read, not compared with anything yet.
struct PictureInput {
  PictureFiles files;
  EngineImage picture;     // or the shadowed one
  EngineImage unshadowed;  // of a pair
};

/// Error{input} for files that are no pictures (lab/pictures/engine_file.h).
PictureInput read_picture_input(const PictureFiles& files);

/// A picture on the truth's pixels.
struct EnginePicture {
  std::string name;
  bool is_pair = false;
  Image test;               // visibility, and surfaces where any were understood
  EngineVisibility values;  // what is known and what was left out; its image went to `test`
  std::vector<std::string> notes;
};

/// Error{input} for other sizes, swapped pairs and values that are no visibility.
EnginePicture align_picture(const PictureInput& input, const SurfaceReading& reading, const Image& reference);

struct PictureScore {
  ShadowQuantity quantity = ShadowQuantity::visibility;
  bool is_quantity_given = false;      // else the nearer one
  std::optional<Interval> other_rmse;  // as the other quantity, when none was given
  Score score;
  double mean_square_rounding = 0.0;
  Image reference;  // with that quantity as visibility, and the picture's rounding in its error
  std::vector<std::string> notes;  // of the picture, and what only the comparison tells
};

/// Without `quantity` a pair is scored as both and takes the nearer one; a lone picture is visibility.
PictureScore score_picture(const EnginePicture& picture, const Image& reference, const glm::dvec3& eye_world,
                           ScoreSettings settings, std::optional<ShadowQuantity> quantity);

/// The rounding of pictures may be all of this much of the mean squared error: its interval gets so much longer below.
void widen_by_rounding(double mean_square_rounding, VisibilityError& error);

}  // namespace umbrameter
