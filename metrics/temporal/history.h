// SPDX-License-Identifier: Apache-2.0
#pragma once
// What earlier frames do to a technique that carries history: what they mend while all stands still, and what they leave behind
// when something moved. Ours. Not here: making the pictures (lab/history.h).

#include "core/image.h"

#include <cstdint>
#include <optional>
#include <span>

namespace umbrameter {

/// A picture of a scene that stands still after so many frames; the image must outlive it.
struct StillPicture {
  int frames = 0;
  const Image* test = nullptr;
};

/// Error that motion leaves: sign(d) sqrt|d|, d = mean (V - A)(V - B) - mean (S - A)(S - B) over scored pixels, V the last frame
/// of a motion, S the same frame where nothing moved before it, A and B the truth's halves: its noise averages out. 0: no trail.
/// Needs `visibility` of `test` and `still`, half_a and half_b of `reference`. Absent without a scored pixel. Error{input} on
/// size mismatch and missing channels.
std::optional<double> measure_ghosting(const Image& test, const Image& still, const Image& reference,
                                       std::span<const uint8_t> mask);

/// Frames after which nine tenths of what the last picture's frames mend is mended: with r(n) = sqrt(max(0, mean (S_n - A)(S_n -
/// B))), the least n at which r(n) <= r(N) + (r(1) - r(N)) / 10, between the pictures' numbers of frames by r over log n. At
/// least two `pictures`, the first of one frame, more frames from each to the next. Absent without a scored pixel, and where
/// frames mend less than .001. Error{input} as above.
std::optional<double> measure_convergence(std::span<const StillPicture> pictures, const Image& reference,
                                          std::span<const uint8_t> mask);

}  // namespace umbrameter
