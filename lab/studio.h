// SPDX-License-Identifier: Apache-2.0
#pragma once
// Pictures of a technique on views with their truth, and what is measured of them, kept. The truth and the seed are the same
// for all parameters, so that only they make a difference.

#include "lab/answers.h"
#include "lab/keys.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
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

}  // namespace umbrameter
