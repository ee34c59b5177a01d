// SPDX-License-Identifier: Apache-2.0
#include "scenes/foreign/foreign_scene.h"

#include "core/error.h"
#include "scenes/instances.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace umbrameter {
namespace {

using glm::dvec3;

void say(const ForeignScene& scene, const std::vector<std::string>& lines,
         std::vector<std::string>& warnings) {
  for (const std::string& line : lines)
    warnings.push_back(fmt::format("{}: {}", scene.path.filename().string(), line));
}

std::vector<const ForeignShape*> kept_shapes(const ForeignScene& scene, const MeshFilter& filter) {
  NameFilter names(filter);
  std::vector<const ForeignShape*> kept;
  for (const ForeignShape& shape : scene.shapes) {
    std::set<std::string> known(shape.aliases.begin(), shape.aliases.end());
    known.insert(shape.name);
    if (names.keeps(known)) kept.push_back(&shape);
  }
  names.require_all_seen(scene.path);
  return kept;
}

}  // namespace

MeshData foreign_mesh(ForeignScene scene, const MeshFilter& filter, std::vector<std::string>& warnings) {
  const std::vector<const ForeignShape*> shapes = kept_shapes(scene, filter);
  std::vector<std::vector<glm::dmat4>> places(scene.meshes.size());
  for (const ForeignShape* shape : shapes) places[shape->mesh].push_back(shape->world_from_mesh);
  std::vector<Primitive> placed;
  std::vector<std::vector<Primitive>> repeated(scene.meshes.size());
  size_t count = 0;
  for (const ForeignShape* shape : shapes) {
    const Primitive& mesh = scene.meshes[shape->mesh];
    if (!repeated[shape->mesh].empty()) continue;
    const bool is_once = is_kept_once(mesh.triangles.size(), places[shape->mesh]);
    Primitive& made = (is_once ? repeated[shape->mesh] : placed).emplace_back(mesh);
    made.label = shape->name;
    if (!is_once) place(made, shape->world_from_mesh);
    count += made.triangles.size();
    if (count > kMaxTriangles)
      fail_input(fmt::format("more than {} triangles", kMaxTriangles), {scene.path.string()});
  }
  if (count == 0) fail_input("the file has no triangles", {scene.path.string()});
  MeshData result = assemble_mesh(placed, scene.masks);
  keep_used_masks(result);
  for (size_t mesh = 0; mesh < repeated.size(); ++mesh) {
    if (repeated[mesh].empty()) continue;
    result.repeated.push_back({assemble_mesh(repeated[mesh], scene.masks), places[mesh]});
    keep_used_masks(result.repeated.back().mesh);
  }
  result.side_files = std::move(scene.side_files);
  warnings.insert(warnings.end(), scene.mesh_warnings.begin(), scene.mesh_warnings.end());
  say(scene, scene.of_meshes.lines(), warnings);
  return result;
}

FoundScene find_foreign_scene(ForeignScene scene) {
  FoundScene found;
  found.path = scene.path;
  found.cameras = scene.cameras;
  found.known_lights = scene.lights;
  found.lights = scene.lamps;
  say(scene, scene.of_views.lines(), found.warnings);
  std::vector<std::string> said_later;  // when the mesh is loaded
  found.bounds_world = bounds_of(foreign_mesh(std::move(scene), {}, said_later));
  return found;
}

Primitive primitive_of(const MeshData& mesh, std::optional<uint32_t> mask) {
  Primitive made;
  made.has_normals = !mesh.normals.empty();
  const auto vertex = [&mesh](uint32_t i) {
    return Primitive::Vertex{mesh.positions[i], mesh.normals.empty() ? dvec3(0.0) : mesh.normals[i]};
  };
  if (!mask || mesh.cutouts.empty()) {
    for (uint32_t i = 0; i < mesh.positions.size(); ++i) made.vertices.push_back(vertex(i));
    made.triangles = mesh.triangles;
    return made;
  }
  made.mask = mask;
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto first = static_cast<uint32_t>(made.vertices.size());
    for (int corner = 0; corner < 3; ++corner) {
      made.vertices.push_back(vertex(mesh.triangles[t][corner]));
      made.vertices.back().uv = mesh.cutouts[mesh.cutout_of_triangle[t]].uv[static_cast<size_t>(corner)];
    }
    made.triangles.emplace_back(first, first + 1, first + 2);
  }
  return made;
}

bool place_texture(Primitive& mesh, const glm::dmat3& uv_from_file) {
  const auto is_first = [&mesh](const auto& vertex) { return vertex.uv == mesh.vertices.front().uv; };
  if (std::ranges::all_of(mesh.vertices, is_first)) return false;
  for (Primitive::Vertex& vertex : mesh.vertices) {
    const dvec3 uv = uv_from_file * dvec3(vertex.uv, 1.0);
    if (!(std::abs(uv.x) <= kMaxUv && std::abs(uv.y) <= kMaxUv)) return false;
    vertex.uv = glm::vec2(uv);
  }
  return true;
}

}  // namespace umbrameter
