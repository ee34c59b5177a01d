// SPDX-License-Identifier: Apache-2.0
#include "lab/studio.h"

#include "core/error.h"
#include "core/hash.h"
#include "lab/draw_and_score.h"
#include "metrics/image/parity.h"
#include "metrics/image/shadow_quantity.h"
#include "results/json/json_optional.h"
#include "scenes/orbit.h"
#include "scenes/scene_hash.h"
#include "store/code_hashes.h"

namespace umbrameter {

namespace {

/// Puts the scene's camera back whatever happens.
class MovedCamera {
 public:
  MovedCamera(Scene& scene, const Camera& camera) : scene_(scene), before_(scene.camera) {
    scene.camera = camera;
  }
  ~MovedCamera() { scene_.camera = before_; }
  MovedCamera(const MovedCamera&) = delete;
  MovedCamera& operator=(const MovedCamera&) = delete;

 private:
  Scene& scene_;
  Camera before_;
};

std::string name_of(const SceneJob& job, double angle_deg) {
  return angle_deg == 0.0 ? job.name : fmt::format("{}, {:+.4g} deg", job.name, angle_deg);
}

/// The truth is hashed as it is, with the samples that it has.
std::string hash_view(const View& view) {
  Hasher hasher;
  hasher.text("tuned view");
  for (const auto& [name, plane] : view.reference.planes)
    hasher.text(name).values(std::span<const float>(plane));
  hasher.values(std::span<const uint8_t>(view.mask));
  const MovedCamera moved(view.job->scene, view.camera);
  return hasher.text(hash_scene(view.job->scene)).number(view.reference.width).hex();
}

}  // namespace

View Studio::make_view(SceneJob& job, double angle_deg, const Fidelity& fidelity) {
  const Camera& own = job.scene.camera;
  const Camera camera = angle_deg == 0.0 ? own : orbit(own, angle_deg);
  View view{name_of(job, angle_deg), &job, angle_deg, camera, fidelity, {}, {}};
  view.reference = render(*fidelity.reference, view, {}, {}, progress_).image;
  const Frame surfaces = render(realtime_, view, {}, {}, silent_);
  const glm::dvec3& eye_world = camera.eye_world;
  const Parity parity = compare_surfaces(surfaces.image, view.reference, eye_world);
  if (!parity.passes) {
    fail_input(fmt::format("{}: the renderers agree on {:.2f} % of the pixels only", view.name,
                           100.0 * parity.agreement));
  }
  view.device = surfaces.device;
  view.mask = scored_mask(parity, view.reference);
  view.key = hash_view(view);
  return view;
}

Frame Studio::render(const View& view, const ParameterValues& values) {
  Frame frame = render(realtime_, view, technique_.technique, values, silent_);
  if (quantity_of(frame.image) != ShadowQuantity::visibility)
    fail_input("pictures that integrate the light are not tuned: the search compares visibility");
  return frame;
}

std::string Studio::key_of(const View& view, const ParameterValues& values, const std::string& what) const {
  TechniqueRun run = technique_;
  run.parameters = values;
  const std::string picture = run_key(view.key, run, seed_, {}, kept_.makers);
  return Hasher().text("evaluation").text(kTuneCodeHash).text(what).text(picture).hex();
}

bool Studio::find(const std::string& key, Numbers& numbers) const {
  return kept_.answers != nullptr && kept_.answers->find(key, [&](const nlohmann::json& json) {
    numbers = read_optional<std::vector<double>>(json.at("numbers"));
  });
}

void Studio::keep(const std::string& key, const Numbers& numbers) const {
  if (kept_.answers != nullptr) kept_.answers->keep(key, {{"numbers", optional_json(numbers)}});
}

std::vector<Numbers> Studio::evaluate(std::span<const View> views, const ParameterValues& values,
                                      const std::string& what, bool stops_at_none,
                                      const std::function<Numbers(const Image&, const View&)>& measure) {
  std::vector<Numbers> found(views.size());
  std::vector<size_t> missing;
  for (size_t i = 0; i < views.size(); ++i) {
    if (!find(key_of(views[i], values, what), found[i])) missing.push_back(i);
  }
  size_t measured = 0;
  draw_and_score(
      missing.size(), [&](size_t k) { return render(views[missing[k]], values); },
      [&](size_t k, const Frame& frame) {
        Numbers& numbers = found[missing[k]];
        numbers = measure(frame.image, views[missing[k]]);
        measured = k + 1;
        return numbers.has_value() || !stops_at_none;
      });
  for (size_t k = 0; k < measured; ++k) keep(key_of(views[missing[k]], values, what), found[missing[k]]);
  return found;
}

Numbers Studio::ask(const View& view, std::span<const ParameterValues> values, const std::string& what,
                    const std::function<Numbers()>& measure) {
  Hasher hasher;
  for (const ParameterValues& one : values) hasher.text(key_of(view, one, what));
  const std::string key = hasher.hex();
  Numbers numbers;
  if (find(key, numbers)) return numbers;
  numbers = measure();
  keep(key, numbers);
  return numbers;
}

Frame Studio::render(Renderer& renderer, const View& view, const std::string& technique,
                     const ParameterValues& values, Progress& progress) {
  const MovedCamera moved(view.job->scene, view.camera);
  return renderer.render(view.job->scene,
                         {.width_px = view.fidelity.width_px,
                          .height_px = view.fidelity.height_px,
                          .seed = seed_,
                          .technique = technique,
                          .parameters = values},
                         progress);
}

}  // namespace umbrameter
