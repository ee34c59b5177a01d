// SPDX-License-Identifier: Apache-2.0
#include "cli/run_renderer.h"

#include "cli/draw_log.h"
#include "core/error.h"
#include "engines/engines.h"
#include "metrics/image/parity.h"
#include "metrics/image/surface.h"
#include "realtime/device_identity.h"

#include <fmt/format.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <filesystem>
#include <numbers>

namespace umbrameter {
namespace {

constexpr const char* kNoPlaces =
    "the engine gave no position: not known whether its picture shows the same places (camera, pixel "
    "centres, geometry)";
constexpr const char* kNoNormals = "the engine gave no normal: not known whether surfaces face the same way";

/// What the engine did not say is taken from `ours`.
void complete(const Image& ours, Frame& frame) {
  Image& image = frame.image;
  if (!image.has("position.x")) {
    frame.warnings.emplace_back(kNoPlaces);
    for (const char* name : {"position.x", "position.y", "position.z", "primitive_id"})
      image.planes[name] = ours.planes.at(name);
  }
  // Engines do not know our units: what the light would give is ours wherever the surfaces are.
  image.planes["unshadowed_irradiance"] = ours.planes.at("unshadowed_irradiance");
  if (image.has("normal.x")) return;
  frame.warnings.emplace_back(kNoNormals);
  for (const char* name : {"normal.x", "normal.y", "normal.z"}) image.planes[name] = ours.planes.at(name);
}

/// Rasterisers round corners to parts of a pixel, each to its own: the same triangle where a point lies within a quarter
/// of a pixel of ours and faces the same way. Elsewhere the tolerances of parity decide.
void match_triangles(const Image& ours, Image& theirs) {
  constexpr double kShare = 0.25;
  const double least_cosine = std::cos(ParityTolerance{}.normal_deg * std::numbers::pi / 180.0);
  const SurfaceView mine = checked_surface(ours), its = checked_surface(theirs);
  const std::span<float> primitive = theirs.plane("primitive_id");
  for (size_t i = 0; i < primitive.size(); ++i) {
    if (!mine.hit(i) || !its.hit(i)) continue;
    const double apart = glm::length(its.p_world(i) - mine.p_world(i));
    const bool is_here = apart <= kShare * pixel_extent_world(mine, i);
    if (is_here && glm::dot(its.n_world(i), mine.n_world(i)) >= least_cosine)
      primitive[i] = mine.primitive[i];
  }
}

/// Among receivers that the light can reach; absent when there are none.
std::optional<std::string> unknown_warning(const Parity& parity, const Image& image) {
  const std::span<const float> irradiance = image.plane("unshadowed_irradiance");
  size_t lit = 0, unknown = 0;
  for (size_t i = 0; i < irradiance.size(); ++i) {
    if (irradiance[i] <= 0.0f) continue;
    ++lit;
    if (parity.classes[i] == ParityClass::unknown) ++unknown;
  }
  if (unknown == 0) return std::nullopt;
  return fmt::format(
      "{:.3g} % of the receivers have no light in the engine's picture without shadows, or more "
      "with them: not scored",
      100.0 * static_cast<double>(unknown) / static_cast<double>(lit));
}

std::string parity_text(const Parity& parity) {
  return fmt::format("{:.3f} % of {} px ({} hit by one alone, {} another surface, {} other light)",
                     100.0 * parity.agreement, parity.covered, parity.coverage_mismatch,
                     parity.surface_mismatch, parity.irradiance_mismatch);
}

/// Error{environment} unless the surfaces agree; those of `ours` stay, with what is known.
void take_surfaces(const Scene& scene, const Image& ours, Frame& frame) {
  const glm::dvec3& eye_world = scene.camera.eye_world;
  match_triangles(ours, frame.image);
  const Parity parity = compare_surfaces(frame.image, ours, eye_world);
  if (!parity.passes)
    fail_environment(fmt::format("the engine's surfaces agree in {}, fewer than {:.4g} %",
                                 parity_text(parity), 100.0 * ParityTolerance{}.required_agreement));
  Image image = ours;
  image.planes["visibility"] = std::move(frame.image.planes.at("visibility"));
  const std::span<float> known = image.add_plane("known");
  for (size_t i = 0; i < known.size(); ++i) known[i] = parity.classes[i] == ParityClass::agrees ? 1.0f : 0.0f;
  image.metadata = std::move(frame.image.metadata);
  image.metadata["engine_parity"] = parity_text(parity);
  if (const auto warning = unknown_warning(parity, image)) frame.warnings.push_back(*warning);
  frame.image = std::move(image);
}

}  // namespace

bool RunRenderer::is_engine(const RenderRequest& request) const {
  return !request.technique.empty() && names_engine(request.technique, places_);
}

Renderer& RunRenderer::engines() {
  if (!engines_) {
    work_.emplace(std::filesystem::temp_directory_path() / "umbrameter-engines");
    engines_ = make_engine_renderer({places_, work_->folder()});
  }
  return *engines_;
}

void RunRenderer::compare_with_ours(const Scene& scene, const RenderRequest& request, Frame& frame,
                                    Progress& progress) {
  RenderRequest plain = request;
  plain.technique.clear();
  plain.parameters.clear();
  const Frame ours = gl_->render(scene, plain, progress);
  complete(ours.image, frame);
  take_surfaces(scene, ours.image, frame);
}

Frame RunRenderer::render(const Scene& scene, const RenderRequest& request, Progress& progress) {
  log_drawn(request.technique.empty() ? "surfaces" : "run", scene, request);
  if (!is_engine(request)) return gl_->render(scene, request, progress);
  Frame frame = engines().render(scene, request, progress);
  compare_with_ours(scene, request, frame, progress);
  return frame;
}

PreparedRun RunRenderer::prepare(const Scene& scene, const RenderRequest& request, Progress& progress) {
  log_drawn("timed", scene, request);
  if (!is_engine(request)) return gl_->prepare(scene, request, progress);
  PreparedRun run = engines().prepare(scene, request, progress);
  compare_with_ours(scene, request, run.frame, progress);
  return run;
}

std::string run_identity(const Renderer& renderer) {
  const auto* runs = dynamic_cast<const RunRenderer*>(&renderer);
  UMBRAMETER_ASSERT(runs != nullptr, "not a renderer of runs");
  return device_identity(runs->gl());
}

}  // namespace umbrameter
