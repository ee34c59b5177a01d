// SPDX-License-Identifier: Apache-2.0
#include "study/tune/views.h"

#include "core/error.h"
#include "core/hash.h"
#include "metrics/image/shadow_quantity.h"
#include "results/guard.h"
#include "results/json_optional.h"
#include "scenes/scene_hash.h"
#include "store/code_hashes.h"
#include "study/study_camera.h"
#include "study/tune/draw_and_score.h"

#include <algorithm>
#include <array>
#include <optional>

namespace umbrameter {
namespace {

constexpr std::array kArcs_deg = {26.0, 13.0, 6.5};
constexpr std::array kSides = {-1.0, 1.0};
constexpr double kLeastShare =
    0.3;  // of the covered, the lit and the shadowed pixels of the camera that was tuned on

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

struct Sight {
  double scored = 0.0;
  double lit = 0.0;     // sum of visibility
  double shadow = 0.0;  // sum of what is not visible of the light
};

Sight sight_of(const View& view) {
  Sight sight;
  const auto visibility = view.reference.plane("visibility");
  for (size_t i = 0; i < view.mask.size(); ++i) {
    if (view.mask[i] == 0) continue;
    sight.scored += 1.0;
    sight.lit += static_cast<double>(visibility[i]);
    sight.shadow += 1.0 - static_cast<double>(visibility[i]);
  }
  return sight;
}

bool sees_enough(const View& view, const View& own) {
  const Sight now = sight_of(view), before = sight_of(own);
  return now.scored >= kLeastShare * before.scored && now.lit >= kLeastShare * before.lit &&
         now.shadow >= kLeastShare * before.shadow;
}

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
  View view{name_of(job, angle_deg), &job, angle_deg, camera, fidelity, {}, {}, {}};
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

namespace {

/// Absent when it is not comparable or does not see enough: it may stand in a wall.
std::optional<View> turned_view(Studio& studio, const View& own, double angle_deg) {
  std::optional<View> view;
  const auto failure = guarded([&] { view = studio.make_view(*own.job, angle_deg, own.fidelity); });
  if (failure && failure->kind != ErrorKind::input) throw Error(failure->kind, failure->message);
  return view && sees_enough(*view, own) ? std::move(view) : std::nullopt;
}

double find_reach(Studio& studio, const View& own, double side, std::vector<View>& ends) {
  for (const double angle_deg : kArcs_deg) {
    auto view = turned_view(studio, own, side * angle_deg);
    if (!view) continue;
    ends.push_back(std::move(*view));
    return angle_deg;
  }
  return 0.0;
}

std::optional<View> take_end(Arc& arc, const View& own, double angle_deg) {
  const auto end = std::ranges::find_if(arc.ends, [&](const View& view) {
    return view.angle_deg == angle_deg && view.fidelity.width_px == own.fidelity.width_px &&
           view.fidelity.reference == own.fidelity.reference;
  });
  if (end == arc.ends.end()) return std::nullopt;
  std::optional<View> view = std::move(*end);
  arc.ends.erase(end);
  return view;
}

}  // namespace

Arc find_arc(Studio& studio, const View& own) {
  Arc arc;
  arc.left_deg = find_reach(studio, own, kSides[0], arc.ends);
  arc.right_deg = find_reach(studio, own, kSides[1], arc.ends);
  return arc;
}

std::vector<View> make_turned_views(Studio& studio, const View& own, Arc& arc,
                                    std::span<const double> shares) {
  std::vector<View> views;
  for (const double share : shares) {
    for (const double angle_deg : {-arc.left_deg * share, arc.right_deg * share}) {
      if (angle_deg == 0.0) continue;
      auto view = take_end(arc, own, angle_deg);
      if (!view) view = turned_view(studio, own, angle_deg);
      if (view) views.push_back(std::move(*view));
    }
  }
  return views;
}

}  // namespace umbrameter
