#include "study/tune/views.h"

#include "core/error.h"
#include "study/guard.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace umbrameter {
namespace {

/// A camera turned so far to one side, and nearer where it does not see enough from there.
struct Turn {
  double far_deg = 0.0, near_deg = 0.0;
};
// Those held out lie between those tuned on, also where both come nearer.
constexpr std::array kTrained = {Turn{10.0, 5.0}, Turn{26.0, 17.0}};
constexpr Turn kHeldOut = {20.0, 14.0};
constexpr std::array kSides = {-1.0, 1.0};
constexpr double kLeastShare =
    0.3;  // of the covered and of the shadowed pixels of the camera that was tuned on

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
  double shadow = 0.0;  // sum of what is not visible of the light
};

Sight sight_of(const View& view) {
  Sight sight;
  const auto visibility = view.reference.plane("visibility");
  for (size_t i = 0; i < view.mask.size(); ++i) {
    if (view.mask[i] == 0) continue;
    sight.scored += 1.0;
    sight.shadow += 1.0 - static_cast<double>(visibility[i]);
  }
  return sight;
}

bool sees_enough(const View& view, const View& trained) {
  const Sight now = sight_of(view), before = sight_of(trained);
  return now.scored >= kLeastShare * before.scored && now.shadow >= kLeastShare * before.shadow;
}

}  // namespace

View Studio::make_view(SceneJob& job, const Camera& camera, const std::string& name,
                       const Fidelity& fidelity) {
  View view{name, &job, camera, fidelity, {}, {}};
  view.reference = render(*fidelity.reference, view, {}, {}, progress_).image;
  const Frame surfaces = render(realtime_, view, {}, {}, silent_);
  const double eye_world[3] = {camera.eye_world.x, camera.eye_world.y, camera.eye_world.z};
  const Parity parity = compare_surfaces(surfaces.image, view.reference, eye_world);
  if (!parity.passes) {
    fail_input(fmt::format("{}: the renderers agree on {:.2f} % of the pixels only", name,
                           100.0 * parity.agreement));
  }
  view.mask = scored_mask(parity, view.reference);
  return view;
}

Frame Studio::render(const View& view, const ParameterValues& values) {
  return render(realtime_, view, technique_, values, silent_);
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

Camera orbit(const Camera& camera, double angle_deg) {
  const double angle_rad = angle_deg * std::numbers::pi / 180.0;
  const glm::dvec3 axis = glm::normalize(camera.up_world);
  const glm::dvec3 arm = camera.eye_world - camera.at_world;
  const glm::dvec3 along = glm::dot(arm, axis) * axis;
  const glm::dvec3 across = arm - along;
  Camera moved = camera;
  moved.eye_world =
      camera.at_world + along + std::cos(angle_rad) * across + std::sin(angle_rad) * glm::cross(axis, across);
  return moved;
}

namespace {

/// Absent when it is not comparable or does not see enough.
std::optional<View> turned_view(Studio& studio, SceneJob& job, const View& trained, double angle_deg) {
  std::optional<View> view;
  guarded([&] {
    view = studio.make_view(job, orbit(trained.camera, angle_deg),
                            fmt::format("{}, {:+.0f} deg", job.name, angle_deg), trained.fidelity);
  });
  return view && sees_enough(*view, trained) ? std::move(view) : std::nullopt;
}

std::optional<View> turned_view(Studio& studio, SceneJob& job, const View& trained, const Turn& turn,
                                double side) {
  auto view = turned_view(studio, job, trained, side * turn.far_deg);
  return view ? std::move(view) : turned_view(studio, job, trained, side * turn.near_deg);
}

}  // namespace

std::vector<View> make_trained_views(Studio& studio, SceneJob& job, const Fidelity& fidelity, int count) {
  std::vector<View> views;
  views.push_back(studio.make_view(job, job.scene.camera, job.name, fidelity));
  if (count == 1) return views;
  for (const Turn& turn : kTrained) {
    for (const double side : kSides) {
      if (auto view = turned_view(studio, job, views.front(), turn, side)) views.push_back(std::move(*view));
    }
  }
  return views;
}

std::vector<View> make_held_out_views(Studio& studio, SceneJob& job, const View& trained,
                                      std::vector<std::string>& notes) {
  std::vector<View> views;
  for (const double side : kSides) {
    if (auto view = turned_view(studio, job, trained, kHeldOut, side)) {
      views.push_back(std::move(*view));
    } else {
      notes.push_back(fmt::format("{}: no held-out camera at {:+.0f} degrees sees enough", job.name,
                                  side * kHeldOut.near_deg));
    }
  }
  return views;
}

}  // namespace umbrameter
