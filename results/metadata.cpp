// SPDX-License-Identifier: Apache-2.0
#include "results/metadata.h"

#include "core/version.h"

#include <fmt/format.h>

#include <cctype>

namespace umbrameter {

void add_metadata(Frame& frame, const Scene& scene, const RenderRequest& request) {
  auto& metadata = frame.image.metadata;
  const glm::dvec3& eye = scene.camera.eye_world;
  metadata["scene"] = scene.name;
  metadata["scene_hash"] = scene.hash;
  metadata["light"] = fmt::format("{} ({})", scene.light().name, to_text(scene.light().type));
  for (const AnimatedMesh& mesh : scene.animated)
    metadata["animated"] += fmt::format("{}{}: {} at {} s", metadata["animated"].empty() ? "" : ", ",
                                        mesh.mesh, mesh.animation, mesh.time_s);
  metadata["eye_world"] = fmt::format("{} {} {}", eye.x, eye.y, eye.z);
  metadata["seed"] = std::to_string(request.seed);
  metadata["device"] = frame.device;
  metadata["version"] = kVersion;
  metadata["commit"] = kCommit;
  if (request.technique.empty()) return;
  metadata["technique"] = request.technique;
  metadata["parameters"] = to_text(frame.parameters);
}

std::string to_text(const ParameterValues& parameters) {
  std::string text;
  for (const auto& [name, value] : parameters) {
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", name, to_text(value));
  }
  return text;
}

std::string file_name_of(const std::string& label) {
  std::string name;
  for (const char c : label) {
    const bool is_plain =
        std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '_' || c == '-';
    name += is_plain ? c : '-';
  }
  const size_t first = name.find_first_not_of('.');  // no hidden files, no ".."
  return first == std::string::npos ? "unnamed" : name.substr(first);
}

}  // namespace umbrameter
