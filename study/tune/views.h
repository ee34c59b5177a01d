// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a tuner looks at: scenes from cameras, each with its truth, rendered once and kept. The truth and the seed are
// the same for all parameters, so that only they make a difference.

#include "lab/answers.h"
#include "lab/keys.h"
#include "study/tune/objective.h"

#include <array>
#include <functional>
#include <optional>
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
  std::string key = {};       // of all above, for what is kept
  std::string device = {};    // of real time
};

/// Where evaluations are kept; without answers nowhere.
struct EvaluationStore {
  Makers makers = {};
  Answers* answers = nullptr;
};

/// What was measured of one picture; absent: there was nothing to measure.
using Numbers = std::optional<std::vector<double>>;

/// Renders a technique on views. Cameras of the jobs' scenes are moved while this works and put back.
class Studio {
 public:
  Studio(Renderer& realtime, TechniqueRun technique, uint64_t seed, Progress& progress,
         EvaluationStore kept = {})
      : realtime_(realtime),
        technique_(std::move(technique)),
        seed_(seed),
        progress_(progress),
        kept_(std::move(kept)) {}

  /// The scene's camera turned by so much. Error{input} when the renderers disagree there, so that no number would count.
  View make_view(SceneJob& job, double angle_deg, const Fidelity& fidelity);
  Frame render(const View& view, const ParameterValues& values);

  /// What `measure` says of each view's picture, in order; `what` it is tells it from what else is kept of the same pictures. One
  /// picture is measured while the next is drawn, and what was measured before is not drawn. With `stops_at_none` the first
  /// picture without numbers ends it. Throws what drawing and measuring do.
  std::vector<Numbers> evaluate(std::span<const View> views, const ParameterValues& values,
                                const std::string& what, bool stops_at_none,
                                const std::function<Numbers(const Image&, const View&)>& measure);
  /// The same of something else that depends on these values on this view.
  Numbers ask(const View& view, std::span<const ParameterValues> values, const std::string& what,
              const std::function<Numbers()>& measure);

 private:
  Frame render(Renderer& renderer, const View& view, const std::string& technique,
               const ParameterValues& values, Progress& progress);
  std::string key_of(const View& view, const ParameterValues& values, const std::string& what) const;
  bool find(const std::string& key, Numbers& numbers) const;
  void keep(const std::string& key, const Numbers& numbers) const;

  Renderer& realtime_;
  TechniqueRun technique_;
  uint64_t seed_;
  Progress& progress_;     // of the truth
  SilentProgress silent_;  // of hundreds of quick frames
  EvaluationStore kept_;
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
