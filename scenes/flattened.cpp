// SPDX-License-Identifier: Apache-2.0
#include "scenes/instances.h"

#include "core/error.h"
#include "scenes/scene_hash.h"

#include <map>

namespace umbrameter {
namespace {

class Flattener {
 public:
  explicit Flattener(const Scene& scene) : scene_(scene), instances_(list_instances(scene)) {}

  Scene run() {
    Scene flat = scene_;
    flat.instanced.clear();
    flat.parts.clear();
    add_vertices(flat);
    add_masks(flat);
    for (const bool wants_holes : {false, true}) {
      add_triangles({scene_.triangles, scene_.parts, scene_.cutouts, scene_.first_cutout(), 0, 0},
                    wants_holes, flat);
      for (size_t i = 0; i < instances_.size(); ++i) {
        const InstancedMesh& mesh = *instances_[i].mesh;
        add_triangles({mesh.triangles, mesh.parts, mesh.cutouts, mesh.first_cutout(), first_vertex_[i],
                       first_mask_.at(&mesh)},
                      wants_holes, flat);
      }
    }
    UMBRAMETER_ASSERT(triangles_.size() == count_shown_triangles(scene_), "parts cover {} of {} triangles",
                      triangles_.size(), count_shown_triangles(scene_));
    flat.triangles = std::move(triangles_);
    flat.cutouts = std::move(cutouts_);
    if (!flat.hash.empty()) flat.hash = hash_scene(flat);
    return flat;
  }

 private:
  struct Source {
    const SharedList<glm::uvec3>& triangles;
    const std::vector<MeshPart>& parts;
    const SharedList<Cutout>& cutouts;
    uint32_t first_cutout;
    uint32_t first_vertex;
    uint32_t first_mask;
  };

  void add_vertices(Scene& flat) {
    std::vector<glm::vec3>& positions = flat.positions_world.edit();
    for (const Instance& instance : instances_) {
      first_vertex_.push_back(static_cast<uint32_t>(positions.size()));
      const auto count = static_cast<uint32_t>(instance.mesh->positions.size());
      for (uint32_t v = 0; v < count; ++v) positions.emplace_back(instance.p_world(v));
      if (instance.mesh->normals.empty()) continue;
      std::vector<glm::vec3>& normals = flat.normals_world.edit();
      for (uint32_t v = 0; v < count; ++v) normals.emplace_back(instance.n_world(v));
    }
  }

  void add_masks(Scene& flat) {
    for (const auto& mesh : scene_.instanced) {
      first_mask_[mesh.get()] = static_cast<uint32_t>(flat.masks.size());
      if (mesh->masks.empty()) continue;
      std::vector<AlphaMask>& masks = flat.masks.edit();
      masks.insert(masks.end(), mesh->masks.begin(), mesh->masks.end());
    }
  }

  /// The parts that are solid, or those that are not: each is one or the other.
  void add_triangles(const Source& from, bool wants_holes, Scene& flat) {
    for (const MeshPart& part : from.parts) {
      if ((part.first_triangle >= from.first_cutout) != wants_holes) continue;
      flat.parts.push_back({part.name, static_cast<uint32_t>(triangles_.size()), part.triangle_count});
      for (uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
        triangles_.push_back(from.triangles[t] + from.first_vertex);
        if (!wants_holes) continue;
        const Cutout& cutout = from.cutouts[t - from.first_cutout];
        cutouts_.push_back({cutout.uv, cutout.mask + from.first_mask});
      }
    }
  }

  const Scene& scene_;
  std::vector<Instance> instances_;
  std::vector<uint32_t> first_vertex_;  // by instance
  std::map<const InstancedMesh*, uint32_t> first_mask_;
  std::vector<glm::uvec3> triangles_;
  std::vector<Cutout> cutouts_;
};

}  // namespace

Scene flattened(const Scene& scene) {
  if (scene.instanced.empty()) return scene;
  const uint64_t count = count_shown_triangles(scene);
  if (count > kMaxTriangles) {
    fail_input(
        fmt::format("scene '{}' shows {} triangles with its instances; at most {} can be had each on its own",
                    scene.name, count, kMaxTriangles),
        scene.source, "what knows no instances needs fewer of them");
  }
  return Flattener(scene).run();
}

}  // namespace umbrameter
