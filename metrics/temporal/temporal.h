// SPDX-License-Identifier: Apache-2.0
#pragma once
// What moves that should not (METRICS 6.11): visibility of fixed world points while the camera moves, the
// error's change while the light moves, and the spread over a technique's seeds. Ours. Not here: making the
// frames (lab/temporal.h).

#include "core/image.h"

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace umbrameter {

/// A frame of a sequence; the images must outlive it.
struct SequenceFrame {
  const Image* test = nullptr;
  const Image* reference = nullptr;
  std::span<const uint8_t> mask;  // scored pixels
  glm::dmat4 clip_from_world{1.0};
};

/// Root mean squares in visibility; absent with no point.
struct Flicker {
  size_t points = 0;    // seen in every frame
  size_t rejected = 0;  // left the picture, were hidden or unscored in one
  std::optional<double> test, reference;
  /// sign(d) sqrt|d|, d = test^2 - reference^2: the technique's own.
  std::optional<double> excess;
};

/// Visibility at fixed world points of the first frame, found again by their position: root of the mean over
/// points of the variance over frames. Sampling between pixel centres is bilinear on one surface and moves a
/// sharp true shadow as well; the reference tells how much, by the covariance of its independent halves, which is
/// free of its noise. Needs visibility in the tests; half_a, half_b, position, normal and primitive_id in the
/// references. Error{input} for fewer than two frames, size mismatch, missing channels, NaN, values outside
/// [0,1].
Flicker measure_flicker(std::span<const SequenceFrame> frames, int point_spacing_px = 2);

struct Popping {
  size_t pixels = 0;          // scored in both frames of a step, summed over steps
  std::optional<double> rms;  // sign(m) sqrt|m|, m = mean (a_t - a_t-1)(b_t - b_t-1); absent without pixels
};

/// Change of the error from frame to frame under a still camera and a moving light, a = V - half_a and
/// b = V - half_b, so that the reference's noise averages out. 0 for a constant error. Input as above, without
/// surfaces.
Popping measure_popping(std::span<const SequenceFrame> frames);

/// Root of the mean over scored pixels of the variance over `tests`, frames that differ by their seed only;
/// absent without scored pixels. Error{input} for fewer than two, size mismatch, NaN.
std::optional<double> measure_seed_noise(std::span<const Image* const> tests, std::span<const uint8_t> mask);

}  // namespace umbrameter
