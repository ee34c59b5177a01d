// SPDX-License-Identifier: Apache-2.0
#pragma once
// Scenes of other renderers for tests: written into a folder, read, and compared.

#include "core/files.h"
#include "core/image_io.h"
#include "scene_text.h"
#include "scenes/import_scene.h"
#include "tests/support/temporary_folder.h"

#include <algorithm>
#include <array>

namespace umbrameter {

class ForeignTest : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) const {
    create_folder((folder_.path() / name).parent_path());
    write_file_atomically(folder_.path() / name, text);
  }
  Scene load(const std::string& name, const std::string& text) const {
    write(name, text);
    return load_scene(folder_.path() / name, {});
  }
  MeshData mesh(const std::string& name, const std::string& text, const MeshFilter& filter = {}) {
    write(name, text);
    warnings_.clear();
    return load_foreign_mesh(folder_.path() / name, filter, warnings_);
  }
  /// Without the folder's name.
  std::string error_of(const std::string& name, const std::string& text) const {
    std::string message = message_of([&] { load(name, text); });
    const std::string folder = folder_.path().string() + "/";
    for (size_t at = message.find(folder); at != std::string::npos; at = message.find(folder))
      message.erase(at, folder.size());
    return message;
  }
  /// Rows from the top.
  void write_grey(const std::string& name, int width, const std::vector<uint8_t>& levels) const {
    std::vector<uint8_t> rgb;
    for (const uint8_t level : levels) rgb.insert(rgb.end(), 3, level);
    write_png(folder_.path() / name, width, static_cast<int>(levels.size()) / width, rgb);
  }
  /// A tent of four triangles over the unit square of x and z.
  void write_tent() const {
    write("tent.ply",
          "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
          "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
          "0 0 0\n1 0 0\n1 0 1\n0 0 1\n0.5 1 0.5\n3 1 0 4\n3 2 1 4\n3 3 2 4\n3 0 3 4\n");
  }

  TemporaryFolder folder_;
  std::vector<std::string> warnings_;
};

using Corners = std::array<std::array<float, 3>, 3>;

/// All triangles, each from its least corner on, in order: equal for equal surfaces with equal outsides.
inline std::vector<Corners> sorted_triangles(const Scene& scene) {
  std::vector<Corners> all;
  for (const glm::uvec3& t : scene.triangles) {
    Corners corners{};
    for (int i = 0; i < 3; ++i) {
      const glm::vec3& p = scene.positions_world[t[i]];
      corners[static_cast<size_t>(i)] = {p.x + 0.0f, p.y + 0.0f, p.z + 0.0f};  // no -0
    }
    std::ranges::rotate(corners, std::ranges::min_element(corners));
    all.push_back(corners);
  }
  std::ranges::sort(all);
  return all;
}

/// Where a point is in a picture of that size: -1 to 1, x right, y up.
inline glm::dvec2 place_in_picture(const Scene& scene, const glm::dvec3& p_world, int width_px,
                                   int height_px) {
  const glm::dvec4 clip = clip_from_world(scene.camera, width_px, height_px) * glm::dvec4(p_world, 1.0);
  return glm::dvec2(clip) / clip.w;
}

}  // namespace umbrameter
