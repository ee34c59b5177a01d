// SPDX-License-Identifier: Apache-2.0
#include "scenes/read_mesh.h"

#include "scenes/assimp/assimp_mesh.h"
#include "scenes/file_ending.h"
#include "scenes/gltf/gltf_mesh.h"
#include "scenes/obj/load_obj.h"
#include "scenes/read_shape.h"
#include "scenes/read_values.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <array>
#include <cmath>

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

/// Cosine and sine, exact at multiples of 90 degrees, so that boxes stay on round numbers.
glm::dvec2 circle_deg(double angle_deg) {
  const double quarters = angle_deg / 90.0;
  if (quarters == std::floor(quarters)) {
    constexpr std::array<std::array<double, 2>, 4> kExact = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    const auto& [cosine, sine] = kExact[static_cast<size_t>(quarters - 4.0 * std::floor(quarters / 4.0))];
    return {cosine, sine};
  }
  const double angle_rad = glm::radians(angle_deg);
  return {std::cos(angle_rad), std::sin(angle_rad)};
}

/// Right-handed rotation about the unit `axis` (Rodrigues).
dmat3 rotation(const dvec3& axis, double angle_deg) {
  const glm::dvec2 circle = circle_deg(angle_deg);
  const dmat3 cross(dvec3(0, axis.z, -axis.y), dvec3(-axis.z, 0, axis.x), dvec3(axis.y, -axis.x, 0));
  return circle.x * dmat3(1.0) + circle.y * cross + (1.0 - circle.x) * glm::outerProduct(axis, axis);
}

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

void apply(const Transform& transform, MeshData& mesh) {
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
      !is_read_by_assimp(name)) {
    reader.fail("file", fmt::format("mesh file '{}' has an unknown format", name),
                "'.obj', '.obj.zst', '.gltf', '.glb', '.fbx', '.dae', '.ply' and '.stl' are read");
  }
  if (const auto found = find_mesh_file(name, folder, search)) return *found;
  std::string places = fmt::format("'{}'", folder.empty() ? "." : folder.string());
  if (!search.assets.empty()) places += fmt::format(" and '{}'", search.assets.string());
  reader.fail("file", fmt::format("mesh file '{}' is not in {}", name, places),
              "give the folder of the models with --assets DIR or UMBRAMETER_ASSETS");
}

MeshData load_mesh_file(const fs::path& file, const MeshFilter& filter, std::vector<std::string>& warnings) {
  if (is_gltf(file.string())) return load_gltf_mesh(open_gltf(file), filter, warnings);
  if (is_read_by_assimp(file.string())) return load_assimp_mesh(file, filter, warnings);
  return load_obj(file, filter, warnings);
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

NamedMesh read_mesh(const TomlNode& table, const fs::path& folder, const SceneSearch& search,
                    std::vector<std::string>& warnings) {
  TomlReader reader(table, "[[mesh]]");
  NamedMesh result;
  result.where = table.where;
  if (reader.has("file") == reader.has("shape")) {
    reader.fail("shape", "a mesh needs either 'file' or 'shape'", "file = \"x.obj\" or shape = \"box\"");
  }
  const Transform transform = read_transform(reader);
  if (reader.has("shape")) {
    result.name = reader.text("name", reader.text("shape"));
    result.label = result.name;
    result.mesh = read_shape(reader);
    reader.finish();
  } else {
    const std::string file = reader.text("file");
    const std::string file_name = fs::path(file).filename().string();
    result.name = reader.text("name", file_name.substr(0, file_name.find('.')));
    result.label = file_name;
    const MeshFilter filter{reader.texts("include"), reader.texts("exclude")};
    reader.finish();  // a misspelt key is cheaper to find than a large file is to load
    const fs::path found = require_mesh_file(reader, file, folder, search);
    result.mesh = load_mesh_file(found, filter, warnings);
  }
  apply(transform, result.mesh);
  return result;
}

}  // namespace umbrameter
