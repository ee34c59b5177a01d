// SPDX-License-Identifier: Apache-2.0
#pragma once
// The points at which lights are sampled. A few Owen-scrambled Sobol sets are made once; every pixel and
// replicate takes one of them and moves it by a random digital shift of its own. Given the set, the shift
// alone makes each point uniform, so estimates of different pixels and replicates are unbiased and
// independent, at the price of two exclusive-ors a point. (Owen, "Randomly permuted (t,m,s)-nets and
// (t,s)-sequences", 1995; the digital shift is a special case of the scrambling.)

#include <cstdint>
#include <vector>

namespace umbrameter {

/// The first round of every set; later rounds double the points: [0,16), [16,32), [32,64), ...
inline constexpr uint32_t kFirstRound = 16;

/// The part of a set that one replicate of one pixel uses.
struct SampleStream {
  const uint32_t* x = nullptr;  // 32-bit fractions, to be shifted
  const uint32_t* y = nullptr;
  uint32_t shift_x = 0;
  uint32_t shift_y = 0;
};

class SampleSets {
 public:
  /// Sets of `points` points, readable for 16 points past any of them. Each dyadic round is sorted along a Z
  /// curve, so that neighbours in a packet of rays stay neighbours; a digital shift keeps that.
  explicit SampleSets(uint32_t points);

  uint32_t points() const { return points_; }
  /// The stream of `replicate` of the pixel that `pixel_seed` stands for.
  SampleStream stream(uint32_t pixel_seed, uint32_t replicate) const;

 private:
  static constexpr uint32_t kSets = 16;
  uint32_t points_;
  uint32_t stride_;
  std::vector<uint32_t> x_;  // [kSets][stride_]
  std::vector<uint32_t> y_;
};

/// The seed of one pixel: equal for equal (request seed, pixel index), mixed everywhere else.
uint32_t pixel_seed(uint64_t request_seed, uint32_t pixel_index);

}  // namespace umbrameter
