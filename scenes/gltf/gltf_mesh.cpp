// SPDX-License-Identifier: Apache-2.0
#include "scenes/gltf/gltf_mesh.h"

#include "core/error.h"
#include "scenes/gltf/gltf_accessor.h"
#include "scenes/gltf/gltf_deform.h"
#include "scenes/gltf/gltf_mask.h"
#include "scenes/gltf/tinygltf.h"
#include "scenes/instances.h"
#include "scenes/primitives.h"

#include <cmath>
#include <map>
#include <tuple>

namespace umbrameter {
namespace {

using glm::dvec3;

/// Fans and strips as lists.
std::vector<glm::uvec3> triangles_of(int mode, const std::vector<uint32_t>& indices) {
  std::vector<glm::uvec3> triangles;
  const size_t count = indices.size();
  if (mode == TINYGLTF_MODE_TRIANGLES) {
    for (size_t i = 0; i + 2 < count; i += 3)
      triangles.emplace_back(indices[i], indices[i + 1], indices[i + 2]);
  } else if (mode == TINYGLTF_MODE_TRIANGLE_FAN) {
    for (size_t i = 1; i + 1 < count; ++i) triangles.emplace_back(indices[0], indices[i], indices[i + 1]);
  } else {
    for (size_t i = 0; i + 2 < count; ++i)
      triangles.emplace_back(indices[i], indices[i + 1 + i % 2], indices[i + 2 - i % 2]);
  }
  return triangles;
}

class GltfReader {
 public:
  GltfReader(const GltfFile& file, const MeshFilter& filter, std::vector<std::string>& warnings)
      : file_(file), model_(*file.model), names_(filter), warnings_(warnings) {}

  MeshData read() {
    warnings_.insert(warnings_.end(), file_.warnings.begin(), file_.warnings.end());
    for (const GltfNode& node : file_.nodes) note_node(node);
    for (const Shown& shown : shown_) read_node(shown);
    say_what_is_left_out();
    names_.require_all_seen(file_.path);
    if (triangle_count_ == 0) fail_input("the file has no triangles", {file_.path.string()});
    MeshData mesh = assemble_mesh(primitives_, masks_);
    for (const std::vector<Primitive>& repeated : repeated_) {
      const Places& places = *places_of_repeated_[mesh.repeated.size()];
      mesh.repeated.push_back({assemble_mesh(repeated, masks_), places.world_from_mesh});
      keep_used_masks(mesh.repeated.back().mesh);
    }
    mesh.side_files = file_.side_files;
    mesh.animation = file_.animation;
    mesh.moved_views = moved_views_;
    return mesh;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { fail_input(message, {file_.path.string()}); }

  /// The primitives of a mesh that pass the filter, in one shape, and where they all stand.
  struct Places {
    std::vector<glm::dmat4> world_from_mesh;
    bool is_read = false;
  };
  struct Shown {
    const GltfNode* node;
    std::vector<size_t> primitives;  // of its mesh
    Places* places;                  // null: a skin moves it
  };

  const tinygltf::Node& source_of(const GltfNode& node) const {
    return model_.nodes[static_cast<size_t>(node.node)];
  }
  const tinygltf::Mesh& mesh_of(const GltfNode& node) const {
    return model_.meshes[static_cast<size_t>(source_of(node).mesh)];
  }
  static int mode_of(const tinygltf::Primitive& primitive) {
    return primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
  }
  std::string material_of(const tinygltf::Primitive& source) const {
    const bool has_material =
        source.material >= 0 && static_cast<size_t>(source.material) < model_.materials.size();
    return has_material ? model_.materials[static_cast<size_t>(source.material)].name : "";
  }

  const std::vector<double>& weights_of(const GltfNode& node) const {
    return file_.morph_weights[static_cast<size_t>(node.node)];
  }

  void note_node(const GltfNode& node) {
    const tinygltf::Node& source = source_of(node);
    const bool is_view = source.camera >= 0 || source.extensions.count("KHR_lights_punctual") > 0;
    if (is_view && node.is_moved) ++moved_views_;
    if (source.mesh < 0) return;
    if (static_cast<size_t>(source.mesh) >= model_.meshes.size())
      fail(fmt::format("{} names mesh {}, but there are {}", gltf_node_name(file_, node.node), source.mesh,
                       model_.meshes.size()));
    std::vector<size_t> kept;
    const std::vector<tinygltf::Primitive>& primitives = mesh_of(node).primitives;
    for (size_t i = 0; i < primitives.size(); ++i) {
      if (keeps(primitives[i], node)) kept.push_back(i);
    }
    if (kept.empty()) return;
    if (source.skin >= 0) {
      shown_.push_back({&node, std::move(kept), nullptr});
      return;
    }
    Places& places = places_[{source.mesh, kept, weights_of(node)}];
    places.world_from_mesh.push_back(node.world_from_node);
    shown_.push_back({&node, std::move(kept), &places});
  }

  bool keeps(const tinygltf::Primitive& source, const GltfNode& node) {
    if (mode_of(source) < TINYGLTF_MODE_TRIANGLES) {
      ++lines_;
      return false;
    }
    return names_.keeps({material_of(source), mesh_of(node).name, source_of(node).name});
  }

  /// As far as it can be told without reading them.
  uint64_t triangles_in(const Shown& shown) const {
    uint64_t count = 0;
    for (const size_t i : shown.primitives) {
      const tinygltf::Primitive& primitive = mesh_of(*shown.node).primitives[i];
      const int* position = find_gltf_attribute(primitive, "POSITION");
      const int accessor = primitive.indices >= 0 || position == nullptr ? primitive.indices : *position;
      if (accessor < 0 || static_cast<size_t>(accessor) >= model_.accessors.size()) continue;
      const size_t corners = model_.accessors[static_cast<size_t>(accessor)].count;
      count += mode_of(primitive) == TINYGLTF_MODE_TRIANGLES ? corners / 3 : corners;
    }
    return count;
  }

  void read_node(const Shown& shown) {
    if (shown.places == nullptr || !is_kept_once(triangles_in(shown), shown.places->world_from_mesh)) {
      for (const size_t i : shown.primitives)
        primitives_.push_back(
            read_primitive(mesh_of(*shown.node).primitives[i], *shown.node, shown.node->world_from_node));
      return;
    }
    if (shown.places->is_read) return;
    shown.places->is_read = true;
    std::vector<Primitive>& repeated = repeated_.emplace_back();
    for (const size_t i : shown.primitives)
      repeated.push_back(read_primitive(mesh_of(*shown.node).primitives[i], *shown.node, glm::dmat4(1.0)));
    places_of_repeated_.push_back(shown.places);
  }

  Primitive read_primitive(const tinygltf::Primitive& source, const GltfNode& node,
                           const glm::dmat4& world_from_mesh) {
    const std::string material = material_of(source), mesh = mesh_of(node).name;
    Primitive made;
    made.label = !material.empty() ? material : !mesh.empty() ? mesh : source_of(node).name;
    read_vertices(source, node, made);
    read_triangles(source, mode_of(source), node, made);
    read_holes(source, made);
    apply_gltf_morphs(file_, source, weights_of(node), made);
    if (const int skin = source_of(node).skin; skin >= 0)
      place_by_joints(made, read_gltf_skin(file_, source, skin, made.vertices.size()));
    else
      place(made, world_from_mesh);
    triangle_count_ += made.triangles.size();
    if (triangle_count_ > kMaxTriangles) fail(fmt::format("more than {} triangles", kMaxTriangles));
    return made;
  }

  void read_vertices(const tinygltf::Primitive& source, const GltfNode& node, Primitive& made) const {
    const int* position = find_gltf_attribute(source, "POSITION");
    if (position == nullptr)
      fail(fmt::format("a primitive of {} has no positions", gltf_node_name(file_, node.node)));
    for (const glm::dvec4& p : read_gltf_vectors(file_, *position, "POSITION"))
      made.vertices.push_back({dvec3(p)});
    const int* normal = find_gltf_attribute(source, "NORMAL");
    if (normal == nullptr) return;
    const std::vector<glm::dvec4> normals = read_gltf_vectors(file_, *normal, "NORMAL");
    if (normals.size() != made.vertices.size()) fail("a primitive has not as many normals as positions");
    for (size_t i = 0; i < normals.size(); ++i) made.vertices[i].n = dvec3(normals[i]);
    made.has_normals = true;
  }

  void read_triangles(const tinygltf::Primitive& source, int mode, const GltfNode& node,
                      Primitive& made) const {
    std::vector<uint32_t> indices;
    if (source.indices >= 0) {
      indices = read_gltf_indices(file_, source.indices);
    } else {
      for (uint32_t i = 0; i < made.vertices.size(); ++i) indices.push_back(i);
    }
    for (const uint32_t index : indices) {
      if (index >= made.vertices.size())
        fail(fmt::format("a primitive of {} refers to vertex {}, but has {}",
                         gltf_node_name(file_, node.node), index, made.vertices.size()));
    }
    made.triangles = triangles_of(mode, indices);
  }

  void read_holes(const tinygltf::Primitive& source, Primitive& made) {
    const auto [known, is_new] = holes_.try_emplace(source.material);
    if (is_new) {
      if (auto holes = read_gltf_holes(file_, source.material, warnings_)) {
        known->second = std::pair(static_cast<uint32_t>(masks_.size()), *holes);
        masks_.push_back(std::move(holes->mask));
      }
    }
    if (!known->second) return;
    const GltfHoles& holes = known->second->second;
    made.mask = known->second->first;
    const int* texture = find_gltf_attribute(source, fmt::format("TEXCOORD_{}", holes.texture_set));
    if (texture == nullptr) return;
    const std::vector<glm::dvec4> points = read_gltf_vectors(file_, *texture, "texture points");
    if (points.size() != made.vertices.size())
      fail("a primitive has not as many texture points as positions");
    for (size_t i = 0; i < points.size(); ++i) {
      const glm::vec2 uv(glm::dvec2(holes.uv_from_file * dvec3(points[i].x, points[i].y, 1.0)));
      if (!(std::abs(uv.x) <= kMaxUv && std::abs(uv.y) <= kMaxUv))
        fail(fmt::format("a texture point of material {} is not finite or beyond {}", source.material,
                         kMaxUv));
      made.vertices[i].uv = uv;
    }
  }

  void say(size_t count, const char* one, const char* many) {
    if (count > 0)
      warnings_.push_back(
          fmt::format("{}: {} {}", file_.path.filename().string(), count, count == 1 ? one : many));
  }

  void say_what_is_left_out() {
    say(lines_, "primitive of points or lines is left out", "primitives of points or lines are left out");
  }

  const GltfFile& file_;
  const tinygltf::Model& model_;
  NameFilter names_;
  std::vector<std::string>& warnings_;
  std::vector<AlphaMask> masks_;
  std::map<std::tuple<int, std::vector<size_t>, std::vector<double>>, Places>
      places_;                // by mesh, primitives and weights of morph targets
  std::vector<Shown> shown_;  // in the order of the nodes
  std::vector<Primitive> primitives_;
  std::vector<std::vector<Primitive>> repeated_;  // in their meshes' own space
  std::vector<const Places*> places_of_repeated_;
  std::map<int, std::optional<std::pair<uint32_t, GltfHoles>>> holes_;  // by material; with the mask's index
  size_t triangle_count_ = 0;
  size_t lines_ = 0, moved_views_ = 0;
};

}  // namespace

MeshData load_gltf_mesh(const GltfFile& file, const MeshFilter& filter, std::vector<std::string>& warnings) {
  return GltfReader(file, filter, warnings).read();
}

}  // namespace umbrameter
