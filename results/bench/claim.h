// SPDX-License-Identifier: Apache-2.0
#pragma once
// A paper's claim about two runs of a study. Not here: what becomes of it (results/bench/claims.h).

#include "core/error.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace umbrameter {

enum class Quantity { time, fps, memory, pass_time };

/// Whether a claim's two runs must draw other pictures, to the bit, the same one, or either.
enum class ClaimPictures { other, same, either };

/// A ratio as a paper gives it: one number, which says at least which of two is larger, or a range; `high` is infinite
/// for "at least".
struct PaperRatio {
  double low = 0.0;
  double high = 0.0;
  bool is_range() const { return low != high; }
};

/// quantity(numerator) / quantity(denominator), on every scene or on those named.
struct Claim {
  std::string text;
  std::string source;
  std::string numerator, denominator;  // labels of runs
  Quantity quantity = Quantity::time;
  std::string pass;                  // pass_time only
  std::vector<std::string> without;  // time and fps: passes of the frame that the paper leaves out
  ClaimPictures pictures = ClaimPictures::other;
  bool has_unequal_cost =
      false;  // the two sides compare the map unequally often, and that is what is claimed
  std::optional<PaperRatio> every_scene;
  std::vector<std::pair<std::string, PaperRatio>> by_scene;
  FileLocation where;
};

/// The paper's ratio for `scene`, or for the scene of which it is the view at a moment or under one light, if there is one.
std::optional<PaperRatio> paper_ratio(const Claim& claim, const std::string& scene);

/// By enumerator.
const std::array<std::string, 4>& quantity_names();
std::string_view to_text(Quantity quantity);

}  // namespace umbrameter
