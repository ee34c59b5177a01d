// SPDX-License-Identifier: Apache-2.0
#include "scenes/read_mesh.h"

#include "scenes/assimp/assimp_mesh.h"
#include "scenes/file_ending.h"
#include "scenes/gltf/gltf_mesh.h"
#include "scenes/import_scene.h"
#include "scenes/instances.h"
#include "scenes/obj/load_obj.h"
#include "scenes/read_shape.h"
#include "scenes/read_values.h"
#include "scenes/rotation.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <array>
#include <cmath>
#include <map>
#include <set>

namespace umbrameter {
namespace {

namespace fs = std::filesystem;
using glm::dmat3;
using glm::dvec3;

const std::array<std::string, 2> kUpAxes = {"y", "z"};

/// Model to world: world = linear * model + translation.
struct Transform {
  dmat3 linear{1.0};
  dvec3 translation{0.0};
};

dvec3 read_scale(TomlReader& reader) {
  const TomlNode* node = reader.find("scale");
  if (node == nullptr) return dvec3(1.0);
  const dvec3 scale =
      node->type == TomlNode::Type::array ? reader.vec3("scale") : dvec3(reader.number("scale"));
  for (int i = 0; i < 3; ++i) {
    const double size = std::abs(scale[i]);
    if (size >= kMinLength_world && size <= kMaxLength_world) continue;
    reader.fail("scale", fmt::format("'scale' holds {}, which flattens the mesh or blows it up", scale[i]));
  }
  return scale;
}

dmat3 read_rotation(TomlReader& reader) {
  const dvec3 axis = read_unit_vector(reader, "axis", dvec3(0, 1, 0));
  const double angle_deg = reader.number("rotate_deg", 0.0);
  if (std::abs(angle_deg) <= 36000.0) return rotation(axis, angle_deg);
  reader.fail("rotate_deg", fmt::format("'rotate_deg' = {} is over a hundred turns", angle_deg));
}

Transform read_transform(TomlReader& reader) {
  const dvec3 scale = read_scale(reader);
  const bool z_up = reader.choice("up", kUpAxes, 0) == 1;
  const dmat3 y_up_from_z_up(dvec3(1, 0, 0), dvec3(0, 0, -1), dvec3(0, 1, 0));
  Transform transform;
  transform.linear = dmat3(dvec3(scale.x, 0, 0), dvec3(0, scale.y, 0), dvec3(0, 0, scale.z));
  if (z_up) transform.linear = transform.linear * y_up_from_z_up;
  transform.linear = read_rotation(reader) * transform.linear;
  transform.translation = read_point(reader, "translate", dvec3(0.0));
  return transform;
}

glm::dmat4 matrix_of(const Transform& transform) {
  glm::dmat4 matrix(transform.linear);
  matrix[3] = glm::dvec4(transform.translation, 1.0);
  return matrix;
}

void apply(const Transform& transform, MeshData& mesh) {
  for (RepeatedMesh& repeated : mesh.repeated) {
    for (glm::dmat4& place : repeated.world_from_mesh) place = matrix_of(transform) * place;
  }
  for (dvec3& p : mesh.positions) p = transform.linear * p + transform.translation;
  const double volume = glm::determinant(transform.linear);
  const dmat3 normal_matrix = glm::transpose(glm::inverse(transform.linear));
  for (dvec3& n : mesh.normals) n = glm::normalize(normal_matrix * n);
  if (volume > 0.0) return;
  for (Cutout& cutout : mesh.cutouts) std::swap(cutout.uv[1], cutout.uv[2]);
  for (glm::uvec3& t : mesh.triangles) std::swap(t.y, t.z);  // a mirrored mesh keeps its outside outside
}

fs::path require_mesh_file(const TomlReader& reader, const std::string& name, const fs::path& folder,
                           const SceneSearch& search) {
  if (!has_ending(name, ".obj") && !has_ending(name, ".obj.zst") && !is_gltf(name) &&
      !is_read_by_assimp(name) && !is_foreign_scene(name)) {
    reader.fail(
        "file", fmt::format("mesh file '{}' has an unknown format", name),
        "'.obj', '.obj.zst', '.gltf', '.glb', '.fbx', '.dae', '.ply', '.stl', '.xml' and '.pbrt' are read");
  }
  if (const auto found = find_mesh_file(name, folder, search)) return *found;
  std::string places = fmt::format("'{}'", folder.empty() ? "." : folder.string());
  if (!search.assets.empty()) places += fmt::format(" and '{}'", search.assets.string());
  reader.fail("file", fmt::format("mesh file '{}' is not in {}", name, places),
              "give the folder of the models with --assets DIR or UMBRAMETER_ASSETS");
}

/// What reads one way is one mesh.
struct FileRequest {
  fs::path file;
  MeshFilter filter;
  std::optional<AnimationTime> at;
  auto operator<=>(const FileRequest&) const = default;
};

MeshData load_mesh_file(const FileRequest& wanted, std::vector<std::string>& warnings) {
  const auto& [file, filter, at] = wanted;
  if (is_foreign_scene(file.string())) return load_foreign_mesh(file, filter, warnings);
  if (is_gltf(file.string())) return load_gltf_mesh(open_gltf(file, at), filter, warnings);
  if (is_read_by_assimp(file.string())) return load_assimp_mesh(file, filter, at, warnings);
  return load_obj(file, filter, warnings);
}

/// A [[mesh]] table that is read, but for its file.
struct MeshTable {
  NamedMesh mesh;  // of a shape: all there is
  Transform transform;
  FileRequest request;        // no file: a shape
  std::string file;           // as it is named
  FileLocation time_where;    // of 'time', if it is there
  bool has_own_time = false;  // not that of the command line
};

/// Name or number; empty when absent.
std::string read_animation(TomlReader& reader) {
  const TomlNode* node = reader.find("animation");
  if (node != nullptr && node->type == TomlNode::Type::integer) return std::to_string(node->integer);
  return reader.text("animation", "");
}

/// `time` and `animation`; the command line's count more.
void read_time(TomlReader& reader, const SceneSearch& search, MeshTable& table) {
  AnimationTime own;
  own.animation = read_animation(reader);
  table.has_own_time = reader.has("time");
  if (table.has_own_time) {
    own.time_s = reader.number("time");
    if (!std::isfinite(own.time_s)) reader.fail("time", fmt::format("'time' = {} is not finite", own.time_s));
    table.time_where = reader.require("time").where;
    table.request.at = own;
  } else if (!own.animation.empty()) {
    reader.fail("animation", "'animation' goes with 'time', in seconds");
  }
  if (!search.at) return;
  table.has_own_time = false;
  table.request.at =
      AnimationTime{search.at->time_s, search.at->animation.empty() ? own.animation : search.at->animation};
}

MeshTable read_mesh_table(const TomlNode& table, const fs::path& folder, const SceneSearch& search) {
  TomlReader reader(table, "[[mesh]]");
  MeshTable result;
  NamedMesh& mesh = result.mesh;
  mesh.where = table.where;
  if (reader.has("file") == reader.has("shape")) {
    reader.fail("shape", "a mesh needs either 'file' or 'shape'", "file = \"x.obj\" or shape = \"box\"");
  }
  result.transform = read_transform(reader);
  if (reader.has("shape")) {
    mesh.name = reader.text("name", reader.text("shape"));
    mesh.label = mesh.name;
    mesh.mesh = read_shape(reader);
    reader.finish();
    return result;
  }
  const std::string file = reader.text("file");
  const std::string file_name = fs::path(file).filename().string();
  mesh.name = reader.text("name", file_name.substr(0, file_name.find('.')));
  mesh.label = file_name;
  result.file = file;
  result.request.filter = {reader.texts("include"), reader.texts("exclude")};
  read_time(reader, search, result);
  reader.finish();  // a misspelt key is cheaper to find than a large file is to load
  result.request.file = require_mesh_file(reader, file, folder, search);
  return result;
}

/// Of the file, and says what it moves that does not follow.
MeshData load_table(MeshTable& table, std::vector<std::string>& warnings) {
  MeshData mesh = load_mesh_file(table.request, warnings);
  if (!table.request.at) return mesh;
  if (mesh.animation.empty()) {
    if (table.has_own_time)
      fail_input(fmt::format("'time' is given, but '{}' has no animation", table.file), table.time_where);
    return mesh;
  }
  table.mesh.animated = {table.mesh.name, table.file, mesh.animation, table.request.at->time_s};
  if (mesh.moved_views > 0 && !table.has_own_time)
    warnings.push_back(
        fmt::format("{}: its animation also moves {} of its cameras and lights; those of the scene file stay",
                    table.file, mesh.moved_views));
  return mesh;
}

uint64_t triangles_in(const MeshData& mesh) {
  uint64_t count = mesh.triangles.size();
  for (const RepeatedMesh& repeated : mesh.repeated) count += repeated.mesh.triangles.size();
  return count;
}

/// `loaded`, and what it repeats itself, at each of `places`.
MeshData repeat(MeshData loaded, const std::vector<glm::dmat4>& places) {
  std::vector<RepeatedMesh> repeated = std::move(loaded.repeated);
  loaded.repeated.clear();
  for (RepeatedMesh& one : repeated) {
    std::vector<glm::dmat4> all;
    for (const glm::dmat4& place : places) {
      for (const glm::dmat4& inner : one.world_from_mesh) all.push_back(place * inner);
    }
    one.world_from_mesh = std::move(all);
  }
  MeshData result;
  result.side_files = std::move(loaded.side_files);
  if (!loaded.triangles.empty()) result.repeated.push_back({std::move(loaded), places});
  for (RepeatedMesh& one : repeated) result.repeated.push_back(std::move(one));
  return result;
}

}  // namespace

std::optional<fs::path> find_mesh_file(const std::string& name, const fs::path& folder,
                                       const SceneSearch& search) {
  std::error_code ignored;
  if (const fs::path beside = folder / name; fs::is_regular_file(beside, ignored)) return beside;
  if (search.assets.empty()) return {};
  if (const fs::path asset = search.assets / name; fs::is_regular_file(asset, ignored)) return asset;
  return {};
}

std::vector<NamedMesh> read_meshes(std::span<const TomlNode* const> tables, const fs::path& folder,
                                   const SceneSearch& search, std::vector<std::string>& warnings) {
  std::vector<MeshTable> read;
  std::map<FileRequest, std::vector<glm::dmat4>> places;
  for (const TomlNode* table : tables) {
    read.push_back(read_mesh_table(*table, folder, search));
    const FileRequest& request = read.back().request;
    if (!request.file.empty()) places[request].push_back(matrix_of(read.back().transform));
  }
  std::vector<NamedMesh> meshes;
  std::set<FileRequest> kept_once;
  for (MeshTable& table : read) {
    if (!table.request.file.empty()) {
      if (kept_once.count(table.request) > 0) continue;
      table.mesh.mesh = load_table(table, warnings);
      if (is_kept_once(triangles_in(table.mesh.mesh), places[table.request])) {
        kept_once.insert(table.request);
        table.mesh.mesh = repeat(std::move(table.mesh.mesh), places[table.request]);
        meshes.push_back(std::move(table.mesh));
        continue;
      }
    }
    apply(table.transform, table.mesh.mesh);
    meshes.push_back(std::move(table.mesh));
  }
  return meshes;
}

}  // namespace umbrameter
