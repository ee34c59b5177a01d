// SPDX-License-Identifier: Apache-2.0
#include "scenes/obj/obj_builder.h"

#include "core/names.h"
#include "scenes/obj/triangulate.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace umbrameter {
namespace {

constexpr size_t kMaxVertices = 3 * size_t{kMaxTriangles};
constexpr uint32_t kNoNormal = ~0u;

bool is_finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool can_normalize(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0.0 && std::isfinite(length);
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

glm::dvec3 unnormalised_normal(const MeshData& mesh, const glm::uvec3& triangle) {
  const glm::dvec3& a = mesh.positions[triangle.x];
  return glm::cross(mesh.positions[triangle.y] - a, mesh.positions[triangle.z] - a);
}

/// How a triangle's normals at its corners lie to its own.
enum class Shading { flat, smooth, unusable };

/// Unusable: none, or one in the triangle's plane, which has no side. A triangle without area is dropped later.
Shading shading_of(const glm::dvec3& own, const std::vector<glm::dvec3>& normals, const glm::uvec3& indices) {
  constexpr double kInPlane = 1e-6;     // cosine
  constexpr double kSame = 1.0 - 1e-7;  // cosine; files hold four digits
  bool is_flat = true;
  for (int c = 0; c < 3; ++c) {
    if (indices[c] == kNoNormal || !can_normalize(normals[indices[c]])) return Shading::unusable;
    if (!can_normalize(own)) continue;
    const double cosine = std::abs(glm::dot(glm::normalize(own), glm::normalize(normals[indices[c]])));
    if (cosine < kInPlane) return Shading::unusable;
    is_flat &= cosine > kSame;
  }
  return is_flat ? Shading::flat : Shading::smooth;
}

/// Gives triangle `t` three vertices of its own with its geometric normal.
void split_flat_triangle(MeshData& mesh, size_t t, std::vector<glm::dvec3>& positions) {
  const glm::dvec3 own = unnormalised_normal(mesh, mesh.triangles[t]);
  for (int c = 0; c < 3; ++c) {
    positions.push_back(mesh.positions[mesh.triangles[t][c]]);
    mesh.normals.push_back(can_normalize(own) ? glm::normalize(own) : glm::dvec3(0, 1, 0));
    mesh.triangles[t][c] = static_cast<uint32_t>(positions.size() - 1);
  }
}

/// Makes one vertex of each pair of position and normal that occurs.
void split_vertices(MeshData& mesh, const std::vector<glm::dvec3>& normals,
                    const std::vector<glm::uvec3>& triangle_normals, const std::vector<bool>& is_usable) {
  std::unordered_map<uint64_t, uint32_t> vertex_of_pair;
  std::vector<glm::dvec3> positions;
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!is_usable[t]) {
      split_flat_triangle(mesh, t, positions);
      continue;
    }
    for (int c = 0; c < 3; ++c) {
      const uint32_t position = mesh.triangles[t][c];
      const uint32_t normal = triangle_normals[t][c];
      const auto next = static_cast<uint32_t>(positions.size());
      const auto [found, is_new] = vertex_of_pair.try_emplace(uint64_t{position} << 32 | normal, next);
      if (is_new) {
        positions.push_back(mesh.positions[position]);
        mesh.normals.push_back(glm::normalize(normals[normal]));
      }
      mesh.triangles[t][c] = found->second;
    }
  }
  mesh.positions = std::move(positions);
}

}  // namespace

ObjBuilder::ObjBuilder(ObjLines& lines, const MeshFilter& filter)
    : lines_(lines), filter_(filter), cutouts_(lines.file()) {}

void ObjBuilder::fail(const std::string& message, const std::string& hint) const {
  fail_input(message, {lines_.file(), lines_.line()}, hint);
}

void ObjBuilder::add_position(const glm::dvec3& p) {
  if (!is_finite(p)) fail("the vertex is not finite");
  if (mesh_.positions.size() == kMaxVertices) fail(fmt::format("more than {} vertices", kMaxVertices));
  mesh_.positions.push_back(p);
}

void ObjBuilder::add_normal(const glm::dvec3& n) {
  if (!is_finite(n)) lines_.repairs().add(ObjRepair::normal_not_finite, lines_.line());
  if (normals_.size() == kMaxVertices) fail(fmt::format("more than {} normals", kMaxVertices));
  normals_.push_back(n);
}

void ObjBuilder::add_texture_point(const glm::dvec2& uv) {
  if (texture_points_.size() == kMaxVertices) fail(fmt::format("more than {} texture points", kMaxVertices));
  texture_points_.emplace_back(uv);
}

void ObjBuilder::set_name(std::string& slot, const std::string& name) {
  slot = name;
  seen_.insert(name);
  names_changed_ = true;
}

bool ObjBuilder::is_kept() const {
  const auto matches = [&](const std::vector<std::string>& names) {
    return contains(names, material_) || contains(names, group_) || contains(names, object_);
  };
  return (filter_.include.empty() || matches(filter_.include)) && !matches(filter_.exclude);
}

uint32_t ObjBuilder::label_index() {
  const std::string& name = !material_.empty() ? material_ : !group_.empty() ? group_ : object_;
  const auto [found, is_new] = labels_.try_emplace(name, static_cast<uint32_t>(label_names_.size()));
  if (is_new) label_names_.push_back(name);
  return found->second;
}

uint32_t ObjBuilder::resolve(int index, size_t count, const char* what) const {
  const int64_t zero_based = index > 0 ? int64_t{index} - 1 : static_cast<int64_t>(count) + index;
  if (zero_based < 0 || zero_based >= static_cast<int64_t>(count)) {
    fail(fmt::format("the face refers to {} {}, but {} are defined above it", what, index, count),
         "is the file cut off or put together from parts?");
  }
  return static_cast<uint32_t>(zero_based);
}

void ObjBuilder::add_face(std::span<const ObjCorner> corners) {
  if (names_changed_) {
    kept_ = is_kept();
    label_ = kept_ ? label_index() : 0;
    has_holes_ = cutouts_.find(material_) != nullptr;
    names_changed_ = false;
  }
  std::vector<uint32_t> positions;
  std::vector<uint32_t> normals;
  std::vector<glm::dvec3> points;
  for (const ObjCorner& corner : corners) {
    positions.push_back(resolve(corner.position, mesh_.positions.size(), "vertex"));
    points.push_back(mesh_.positions[positions.back()]);
    normals.push_back(corner.normal == 0 ? kNoNormal : resolve(corner.normal, normals_.size(), "normal"));
  }
  if (!kept_) return;
  const Triangulation parts = triangulate(points);
  if (parts.equal_neighbours > 0)
    lines_.repairs().add(ObjRepair::equal_neighbours, lines_.line(), parts.equal_neighbours);
  if (parts.is_guess) lines_.repairs().add(ObjRepair::crossing_face, lines_.line());
  for (const auto& [a, b, c] : parts.triangles) {
    const auto uv = [&, a = a, b = b, c = c] {
      return std::array{texture_point(corners[a]), texture_point(corners[b]), texture_point(corners[c])};
    };
    if (has_holes_) cutouts_.add(mesh_.triangles.size(), material_, uv());
    if (filter_.masks == MeshMasks::given) {
      mesh_.cutout_of_triangle.push_back(static_cast<uint32_t>(mesh_.cutouts.size()));
      mesh_.cutouts.push_back({uv(), 0});
    }
    add_triangle({positions[a], positions[b], positions[c]}, {normals[a], normals[b], normals[c]});
  }
}

/// (0, 0) for a corner without one, as renderers do.
glm::vec2 ObjBuilder::texture_point(const ObjCorner& corner) const {
  if (corner.texture == 0) return glm::vec2(0.0f);
  return texture_points_[resolve(corner.texture, texture_points_.size(), "texture point")];
}

void ObjBuilder::add_triangle(const glm::uvec3& positions, const glm::uvec3& normals) {
  if (mesh_.triangles.size() == kMaxTriangles) fail(fmt::format("more than {} triangles", kMaxTriangles));
  mesh_.triangles.push_back(positions);
  triangle_labels_.push_back(label_);
  const bool has_none = normals == glm::uvec3(kNoNormal);
  if (has_none && triangle_normals_.empty()) return;
  triangle_normals_.resize(mesh_.triangles.size() - 1, glm::uvec3(kNoNormal));
  triangle_normals_.push_back(normals);
}

void ObjBuilder::require_names_seen() const {
  const std::vector<std::string> known(seen_.begin(), seen_.end());
  for (const auto* names : {&filter_.include, &filter_.exclude}) {
    for (const std::string& name : *names) {
      if (seen_.count(name) > 0) continue;
      fail_input(fmt::format("no material, group or object is called '{}'", name), {lines_.file()},
                 suggest_name(name, known));
    }
  }
}

/// Normals at corners that only repeat their triangles' own are dropped: the mesh is flat.
void ObjBuilder::finish_normals(std::vector<std::string>& warnings) {
  if (triangle_normals_.empty()) return;
  triangle_normals_.resize(mesh_.triangles.size(), glm::uvec3(kNoNormal));
  std::vector<bool> is_usable(mesh_.triangles.size());
  size_t unusable = 0, smooth = 0;
  for (size_t t = 0; t < mesh_.triangles.size(); ++t) {
    const glm::dvec3 own = unnormalised_normal(mesh_, mesh_.triangles[t]);
    const Shading shading = shading_of(own, normals_, triangle_normals_[t]);
    is_usable[t] = shading != Shading::unusable;
    unusable += is_usable[t] ? 0 : 1;
    smooth += shading == Shading::smooth ? 1 : 0;
  }
  if (unusable > 0) {
    warnings.push_back(fmt::format("{}: {} of {} triangles without usable normals: shaded flat", file_name(),
                                   unusable, mesh_.triangles.size()));
  }
  if (smooth > 0) split_vertices(mesh_, normals_, triangle_normals_, is_usable);
}

std::string ObjBuilder::file_name() const {
  return std::filesystem::path(lines_.file()).filename().string();
}

void ObjBuilder::group_by_label(MeshData& mesh) {
  std::vector<uint32_t> first(label_names_.size() + 1, 0);
  for (const uint32_t label : triangle_labels_) ++first[label + 1];
  for (size_t i = 0; i < label_names_.size(); ++i) {
    mesh.parts.push_back({label_names_[i], first[i], first[i + 1]});
    first[i + 1] += first[i];
  }
  std::vector<glm::uvec3> sorted(mesh.triangles.size());
  std::vector<uint32_t> sorted_cutouts(mesh.cutout_of_triangle.size());
  for (size_t t = 0; t < sorted.size(); ++t) {
    const uint32_t place = first[triangle_labels_[t]]++;
    sorted[place] = mesh.triangles[t];
    if (!sorted_cutouts.empty()) sorted_cutouts[place] = mesh.cutout_of_triangle[t];
  }
  mesh.triangles = std::move(sorted);
  mesh.cutout_of_triangle = std::move(sorted_cutouts);
}

MeshData ObjBuilder::finish(std::vector<std::string>& warnings) {
  require_names_seen();
  if (mesh_.triangles.empty()) {
    const bool is_filtered = !filter_.include.empty() || !filter_.exclude.empty();
    fail_input(is_filtered ? "no face is left after 'include' and 'exclude'" : "the mesh has no faces",
               {lines_.file()});
  }
  lines_.repairs().report(file_name(), warnings);
  finish_normals(warnings);
  cutouts_.finish(mesh_, warnings);
  group_by_label(mesh_);
  return std::move(mesh_);
}

}  // namespace umbrameter
