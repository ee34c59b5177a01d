// SPDX-License-Identifier: Apache-2.0
#include "cli/run_renderer.h"

#include "core/error.h"
#include "engines/engines.h"
#include "metrics/parity.h"
#include "realtime/device_identity.h"

#include <fmt/format.h>

#include <filesystem>

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
    for (const char* name :
         {"position.x", "position.y", "position.z", "primitive_id", "unshadowed_irradiance"})
      image.planes[name] = ours.planes.at(name);
  }
  if (image.has("normal.x")) return;
  frame.warnings.emplace_back(kNoNormals);
  for (const char* name : {"normal.x", "normal.y", "normal.z", "unshadowed_irradiance"})
    image.planes[name] = ours.planes.at(name);
}

std::string parity_text(const Parity& parity) {
  return fmt::format("{:.3f} % of {} px ({} hit by one alone, {} another surface, {} other light)",
                     100.0 * parity.agreement, parity.covered, parity.coverage_mismatch,
                     parity.surface_mismatch, parity.irradiance_mismatch);
}

/// Error{environment} unless the surfaces agree; those of `ours` stay, with what is known.
void take_surfaces(const Scene& scene, const Image& ours, Frame& frame) {
  const glm::dvec3& eye = scene.camera.eye_world;
  const double eye_world[3] = {eye.x, eye.y, eye.z};
  const Parity parity = compare_surfaces(frame.image, ours, eye_world);
  if (!parity.passes)
    fail_environment(fmt::format("the engine's surfaces agree in {}, fewer than {:.4g} %",
                                 parity_text(parity), 100.0 * ParityTolerance{}.required_agreement));
  Image image = ours;
  image.planes["visibility"] = std::move(frame.image.planes.at("visibility"));
  const std::span<float> known = image.add_plane("known");
  for (size_t i = 0; i < known.size(); ++i) known[i] = parity.classes[i] == ParityClass::agrees ? 1.0f : 0.0f;
  image.metadata["engine_parity"] = parity_text(parity);
  frame.image = std::move(image);
}

}  // namespace

bool RunRenderer::is_engine(const RenderRequest& request) const {
  return !request.technique.empty() && !find_engine_folder(request.technique, places_).empty();
}

Frame RunRenderer::render_engine(const Scene& scene, const RenderRequest& request, Progress& progress) {
  if (!engines_) {
    work_.emplace(std::filesystem::temp_directory_path() / "umbrameter-engines");
    engines_ = make_engine_renderer({places_, work_->folder()});
  }
  Frame frame = engines_->render(scene, request, progress);
  RenderRequest plain = request;
  plain.technique.clear();
  plain.parameters.clear();
  const Frame ours = gl_->render(scene, plain, progress);
  complete(ours.image, frame);
  take_surfaces(scene, ours.image, frame);
  return frame;
}

Frame RunRenderer::render(const Scene& scene, const RenderRequest& request, Progress& progress) {
  return is_engine(request) ? render_engine(scene, request, progress) : gl_->render(scene, request, progress);
}

PreparedRun RunRenderer::prepare(const Scene& scene, const RenderRequest& request, Progress& progress) {
  if (!is_engine(request)) return gl_->prepare(scene, request, progress);
  return {render_engine(scene, request, progress), {}, {}, {}};
}

std::string run_identity(const Renderer& renderer) {
  const auto* runs = dynamic_cast<const RunRenderer*>(&renderer);
  UMBRAMETER_ASSERT(runs != nullptr, "not a renderer of runs");
  return device_identity(runs->gl());
}

}  // namespace umbrameter
