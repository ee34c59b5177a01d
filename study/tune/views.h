// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a tuner looks at: scenes from cameras, each with its truth, rendered once and kept. The truth and the seed are
// the same for all parameters, so that only they make a difference.

#include "lab/validation.h"
#include "study/tune/objective.h"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace umbrameter {

/// Size of the picture, and who renders its truth.
struct Fidelity {
  int width_px = 0;
  int height_px = 0;
  Renderer* reference = nullptr;
};

struct View {
  std::string name;  // "plate", "plate, +13 deg"
  SceneJob* job = nullptr;
  double angle_deg = 0.0;  // from the scene's camera, around what that looks at
  Camera camera;
  Fidelity fidelity;
  Image reference;
  std::vector<uint8_t> mask;  // scored pixels
};

/// Renders `technique` on views. Cameras of the jobs' scenes are moved while this works and put back.
class Studio {
 public:
  Studio(Renderer& realtime, std::string technique, uint64_t seed, Progress& progress)
      : realtime_(realtime), technique_(std::move(technique)), seed_(seed), progress_(progress) {}

  /// The scene's camera turned by so much. Error{input} when the renderers disagree there, so that no number would count.
  View make_view(SceneJob& job, double angle_deg, const Fidelity& fidelity);
  Frame render(const View& view, const ParameterValues& values);

 private:
  Frame render(Renderer& renderer, const View& view, const std::string& technique,
               const ParameterValues& values, Progress& progress);

  Renderer& realtime_;
  std::string technique_;
  uint64_t seed_;
  Progress& progress_;     // of the truth
  SilentProgress silent_;  // of hundreds of quick frames
};

/// How far the cameras of a scene go to the left and to the right, in degrees; 0 where none sees enough.
struct Arc {
  double left_deg = 0.0, right_deg = 0.0;
  std::vector<View> ends;  // as they were made to find this, until they are taken
};

/// 26 degrees to either side, or a half or a quarter of that where the outermost camera does not see 30 % of the scene, of the
/// light and of the shadow that the scene's own sees. `own` is that one's view.
Arc find_arc(Studio& studio, const View& own);

/// Cameras between 0 (the scene's own) and 1 (the arc's end) of either side of an arc; the one at 0 is made apart. Those
/// searched with, those that say whether what was found holds elsewhere, and those that are scored and never asked: no two
/// of them share a camera, and each set is spread over the arc.
inline constexpr std::array kSearchedShares = {0.5, 1.0};
inline constexpr std::array kCheckedShares = {0.25, 0.75};
inline constexpr std::array kHeldOutShares = {0.125, 0.375, 0.625, 0.875};

/// Views from there, as `own` is made; takes the arc's ends where they are asked for. A camera is left out where the renderers disagree, and where it does not see enough.
std::vector<View> make_turned_views(Studio& studio, const View& own, Arc& arc,
                                    std::span<const double> shares);

}  // namespace umbrameter
