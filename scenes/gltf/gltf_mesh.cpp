// SPDX-License-Identifier: Apache-2.0
#include "scenes/gltf/gltf_mesh.h"

#include "core/error.h"
#include "core/names.h"
#include "scenes/gltf/gltf_mask.h"
#include "scenes/gltf/tinygltf.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace umbrameter {
namespace {

using glm::dvec3;

/// A triangle with all it has at its corners.
struct Corner {
  dvec3 p{0.0};
  dvec3 n{0.0};  // zero: none that can be used
  glm::vec2 uv{0.0f};
};

struct Primitive {
  std::string label;
  std::vector<Corner> vertices;
  std::vector<glm::uvec3> triangles;
  bool has_normals = false;
  std::optional<uint32_t> mask;
};

bool can_normalize(const dvec3& n) {
  const double length = glm::length(n);
  return length > 0.0 && std::isfinite(length);
}

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

class Reader {
 public:
  Reader(const GltfFile& file, const MeshFilter& filter, std::vector<std::string>& warnings)
      : file_(file), model_(*file.model), filter_(filter), warnings_(warnings) {}

  MeshData read() {
    for (const GltfNode& node : file_.nodes) read_node(node);
    say_what_is_left_out();
    require_names_seen();
    if (triangle_count_ == 0) fail_input("the file has no triangles", {file_.path.string()});
    return assemble();
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { fail_input(message, {file_.path.string()}); }

  void read_node(const GltfNode& node) {
    const tinygltf::Node& source = model_.nodes[static_cast<size_t>(node.node)];
    if (source.mesh < 0) return;
    if (static_cast<size_t>(source.mesh) >= model_.meshes.size())
      fail(fmt::format("{} names mesh {}, but there are {}", gltf_node_name(file_, node.node), source.mesh,
                       model_.meshes.size()));
    if (source.skin >= 0) ++skins_;
    const tinygltf::Mesh& mesh = model_.meshes[static_cast<size_t>(source.mesh)];
    for (const tinygltf::Primitive& primitive : mesh.primitives)
      read_primitive(primitive, mesh, source, node);
  }

  bool is_kept(const std::set<std::string>& names) const {
    const auto matches = [&](const std::vector<std::string>& list) {
      return std::any_of(list.begin(), list.end(),
                         [&](const std::string& name) { return names.count(name) > 0; });
    };
    return (filter_.include.empty() || matches(filter_.include)) && !matches(filter_.exclude);
  }

  void read_primitive(const tinygltf::Primitive& source, const tinygltf::Mesh& mesh,
                      const tinygltf::Node& owner, const GltfNode& node) {
    const int mode = source.mode < 0 ? TINYGLTF_MODE_TRIANGLES : source.mode;
    if (mode < TINYGLTF_MODE_TRIANGLES) {
      ++lines_;
      return;
    }
    const bool has_material =
        source.material >= 0 && static_cast<size_t>(source.material) < model_.materials.size();
    const std::string material =
        has_material ? model_.materials[static_cast<size_t>(source.material)].name : "";
    const std::set<std::string> names{material, mesh.name, owner.name};
    seen_.insert(names.begin(), names.end());
    if (!is_kept(names)) return;
    if (!source.targets.empty()) ++morphs_;
    Primitive made;
    made.label = !material.empty() ? material : !mesh.name.empty() ? mesh.name : owner.name;
    read_vertices(source, node, made);
    read_triangles(source, mode, node, made);
    read_holes(source, made);
    triangle_count_ += made.triangles.size();
    if (triangle_count_ > kMaxTriangles) fail(fmt::format("more than {} triangles", kMaxTriangles));
    primitives_.push_back(std::move(made));
  }

  const int* find(const tinygltf::Primitive& source, const std::string& name) const {
    const auto found = source.attributes.find(name);
    return found == source.attributes.end() ? nullptr : &found->second;
  }

  void read_vertices(const tinygltf::Primitive& source, const GltfNode& node, Primitive& made) const {
    const int* position = find(source, "POSITION");
    if (position == nullptr)
      fail(fmt::format("a primitive of {} has no positions", gltf_node_name(file_, node.node)));
    for (const glm::dvec4& p : read_gltf_vectors(file_, *position, "POSITION"))
      made.vertices.push_back({dvec3(node.world_from_node * glm::dvec4(dvec3(p), 1.0))});
    const int* normal = find(source, "NORMAL");
    if (normal == nullptr) return;
    const std::vector<glm::dvec4> normals = read_gltf_vectors(file_, *normal, "NORMAL");
    if (normals.size() != made.vertices.size()) fail("a primitive has not as many normals as positions");
    // The cofactors: right for mirrored and flattened nodes, too.
    const glm::dmat3 m(node.world_from_node);
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    const double side = glm::determinant(m) < 0.0 ? -1.0 : 1.0;
    for (size_t i = 0; i < normals.size(); ++i) {
      const dvec3 n = side * (cofactors * dvec3(normals[i]));
      made.vertices[i].n = can_normalize(n) ? glm::normalize(n) : dvec3(0.0);
    }
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
    if (glm::determinant(glm::dmat3(node.world_from_node)) >= 0.0) return;
    for (glm::uvec3& t : made.triangles) std::swap(t.y, t.z);  // a mirrored mesh keeps its outside outside
  }

  void read_holes(const tinygltf::Primitive& source, Primitive& made) {
    const auto [known, is_new] = holes_.try_emplace(source.material);
    if (is_new) {
      if (auto holes = read_gltf_holes(file_, source.material, warnings_)) {
        known->second = std::pair(static_cast<uint32_t>(mesh_.masks.size()), *holes);
        mesh_.masks.push_back(std::move(holes->mask));
      }
    }
    if (!known->second) return;
    const GltfHoles& holes = known->second->second;
    made.mask = known->second->first;
    const int* texture = find(source, fmt::format("TEXCOORD_{}", holes.texture_set));
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
    say(skins_, "skinned node stands in its rest pose", "skinned nodes stand in their rest pose");
    say(morphs_, "primitive with morph targets has its base shape",
        "primitives with morph targets have their base shape");
    say(model_.animations.size(), "animation is not read", "animations are not read");
  }

  void require_names_seen() const {
    const std::vector<std::string> known(seen_.begin(), seen_.end());
    for (const auto* names : {&filter_.include, &filter_.exclude}) {
      for (const std::string& name : *names) {
        if (seen_.count(name) > 0) continue;
        fail_input(fmt::format("no material, mesh or node is called '{}'", name), {file_.path.string()},
                   suggest_name(name, known));
      }
    }
  }

  /// Material by material; a vertex for each corner of flat triangles among smooth ones.
  MeshData assemble() {
    const bool is_smooth = std::any_of(primitives_.begin(), primitives_.end(),
                                       [](const Primitive& one) { return one.has_normals; });
    std::vector<std::string> labels;
    for (const Primitive& one : primitives_) {
      if (std::find(labels.begin(), labels.end(), one.label) == labels.end()) labels.push_back(one.label);
    }
    for (const std::string& label : labels) {
      const auto first = static_cast<uint32_t>(mesh_.triangles.size());
      for (const Primitive& one : primitives_) {
        if (one.label == label) append(one, is_smooth);
      }
      mesh_.parts.push_back({label, first, static_cast<uint32_t>(mesh_.triangles.size()) - first});
    }
    if (mesh_.cutouts.empty()) mesh_.cutout_of_triangle.clear();
    mesh_.side_files = file_.side_files;
    return std::move(mesh_);
  }

  void append(const Primitive& one, bool is_smooth) {
    const auto base = static_cast<uint32_t>(mesh_.positions.size());
    for (const Corner& vertex : one.vertices) {
      mesh_.positions.push_back(vertex.p);
      if (is_smooth) mesh_.normals.push_back(can_normalize(vertex.n) ? vertex.n : dvec3(0, 1, 0));
    }
    for (const glm::uvec3& t : one.triangles) {
      const bool is_usable = can_normalize(one.vertices[t.x].n) && can_normalize(one.vertices[t.y].n) &&
                             can_normalize(one.vertices[t.z].n);
      mesh_.triangles.push_back(is_smooth && !is_usable ? flat_triangle(one, t) : t + base);
      mesh_.cutout_of_triangle.push_back(one.mask ? static_cast<uint32_t>(mesh_.cutouts.size()) : kSolid);
      if (!one.mask) continue;
      mesh_.cutouts.push_back(
          {{one.vertices[t.x].uv, one.vertices[t.y].uv, one.vertices[t.z].uv}, *one.mask});
    }
  }

  glm::uvec3 flat_triangle(const Primitive& one, const glm::uvec3& t) {
    const dvec3 &a = one.vertices[t.x].p, &b = one.vertices[t.y].p, &c = one.vertices[t.z].p;
    const dvec3 n = glm::cross(b - a, c - a);
    const auto first = static_cast<uint32_t>(mesh_.positions.size());
    mesh_.positions.insert(mesh_.positions.end(), {a, b, c});
    mesh_.normals.insert(mesh_.normals.end(), 3, can_normalize(n) ? glm::normalize(n) : dvec3(0, 1, 0));
    return {first, first + 1, first + 2};
  }

  const GltfFile& file_;
  const tinygltf::Model& model_;
  const MeshFilter& filter_;
  std::vector<std::string>& warnings_;
  MeshData mesh_;
  std::vector<Primitive> primitives_;
  std::map<int, std::optional<std::pair<uint32_t, GltfHoles>>> holes_;  // by material; with the mask's index
  std::set<std::string> seen_;
  size_t triangle_count_ = 0;
  size_t lines_ = 0, skins_ = 0, morphs_ = 0;
};

}  // namespace

MeshData load_gltf_mesh(const GltfFile& file, const MeshFilter& filter, std::vector<std::string>& warnings) {
  return Reader(file, filter, warnings).read();
}

}  // namespace umbrameter
