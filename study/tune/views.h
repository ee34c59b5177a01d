#pragma once
// What a tuner looks at: scenes from cameras, each with its truth, rendered once and kept. The truth and the seed are
// the same for all parameters, so that only they make a difference.

#include "study/tune/objective.h"
#include "study/validation.h"

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
  std::string name;  // "plate", "plate, +20 deg"
  SceneJob* job = nullptr;
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

  /// Error{input} when the renderers disagree there, so that no number would count.
  View make_view(SceneJob& job, const Camera& camera, const std::string& name, const Fidelity& fidelity);
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

/// The camera turned around what it looks at, about its up direction.
Camera orbit(const Camera& camera, double angle_deg);

/// The scene's camera, and with `count` = 5 also those turned by 10 and 26 degrees to either side (5 and 17 where the
/// further one does not see enough of the scene and of its shadow). Tuned on one picture alone, values learn how the map's
/// texels happen to lie in it. Error{input} when the first is not comparable.
std::vector<View> make_trained_views(Studio& studio, SceneJob& job, const Fidelity& fidelity, int count);

/// Cameras turned 20 degrees to either side, or 14 where the further one does not see enough: between those tuned on, and
/// none of them. `notes` name those left out. `trained` is the scene's own camera.
std::vector<View> make_held_out_views(Studio& studio, SceneJob& job, const View& trained,
                                      std::vector<std::string>& notes);

}  // namespace umbrameter
