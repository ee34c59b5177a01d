// SPDX-License-Identifier: Apache-2.0
#include "scenes/pbrt/pbrt_shapes.h"

#include "core/names.h"
#include "scenes/file_ending.h"
#include "scenes/foreign/area_lights.h"
#include "scenes/foreign/mesh_of_file.h"
#include "scenes/foreign/round_shapes.h"
#include "scenes/pbrt/pbrt_meshes.h"
#include "scenes/read_mask.h"

#include <glm/geometric.hpp>

namespace umbrameter {
namespace {

namespace fs = std::filesystem;
using glm::dmat4;

/// Whole disks and spheres; absent for parts of them.
std::optional<dmat4> shape_from_unit(const std::string& type, const PbrtParameters& parameters) {
  const double radius = parameters.number("radius", 1.0);
  const bool is_part =
      parameters.number("phimax", 360.0) < 360.0 || parameters.number("innerradius", 0.0) > 0.0 ||
      parameters.number("zmin", -radius) > -radius || parameters.number("zmax", radius) < radius;
  if (is_part) return std::nullopt;
  dmat4 matrix(radius);
  matrix[3] = glm::dvec4(0, 0, type == "disk" ? parameters.number("height", 0.0) : 0.0, 1);
  return matrix;
}

bool is_round(const std::string& type) {
  return type == "disk" || type == "sphere";
}

glm::dmat3 uv_of(const PbrtParameters& texture) {
  return {
      texture.number("uscale", 1.0), 0, 0, 0, texture.number("vscale", 1.0), 0, texture.number("udelta", 0.0),
      texture.number("vdelta", 0.0), 1};
}

}  // namespace

void PbrtShapes::add_texture(const std::string& name, const std::string& kind,
                             const PbrtParameters& parameters) {
  textures_.insert_or_assign(name, Texture{kind, parameters, {}});
}

fs::path PbrtShapes::find_file(const PbrtParameters& parameters) {
  const std::string name = parameters.text("filename", "");
  std::error_code ignored;
  // pbrt looks beside the first file.
  fs::path file = scene_.path.parent_path() / name;
  if (!name.empty() && fs::is_regular_file(file, ignored)) {
    scene_.side_files.push_back(file);
    return file;
  }
  fail_input(fmt::format("file '{}' is not there", name), parameters.where());
}

std::optional<PbrtShapes::Holes> PbrtShapes::all_holes(double alpha) {
  if (alpha > 0.0 && alpha < 1.0)
    scene_.of_meshes.add("mesh of an even alpha is solid from 0.5 on, and a hole below",
                         "meshes of an even alpha are solid from 0.5 on, and holes below");
  if (alpha >= static_cast<double>(kLeastAlpha)) return std::nullopt;
  scene_.masks.push_back({"alpha", 1, 1, {0}});
  return Holes{static_cast<uint32_t>(scene_.masks.size() - 1)};
}

std::optional<PbrtShapes::Holes> PbrtShapes::holes_of(const PbrtParameters& parameters) {
  const PbrtParameter* alpha = parameters.find("alpha");
  if (alpha == nullptr) return std::nullopt;
  if (alpha->type != "texture") return all_holes(parameters.number("alpha", 1.0));
  return read_texture(parameters.text("alpha", ""), alpha->where);
}

std::optional<PbrtShapes::Holes> PbrtShapes::read_texture(const std::string& name,
                                                          const FileLocation& where) {
  const auto found = textures_.find(name);
  if (found == textures_.end()) {
    std::vector<std::string> known;
    for (const auto& [other, texture] : textures_) known.push_back(other);
    fail_input(fmt::format("no texture is called '{}'", name), where, suggest_name(name, known));
  }
  Texture& texture = found->second;
  if (texture.kind == "constant") return all_holes(texture.parameters.number("value", 1.0));
  if (texture.kind != "imagemap" || texture.parameters.text("mapping", "uv") != "uv") {
    scene_.of_meshes.add("alpha by another texture than an imagemap over uv is left out: it is solid",
                         "alphas by other textures than an imagemap over uv are left out: they are solid");
    return std::nullopt;
  }
  if (!texture.is_read) {
    texture.is_read = true;
    if (texture.parameters.text("wrap", "repeat") != "repeat")
      scene_.of_meshes.add("mask is repeated, not cut off or clamped",
                           "masks are repeated, not cut off or clamped");
    scene_.masks.push_back(mask_by_colour(
        find_file(texture.parameters), {.is_encoded = texture.parameters.text("encoding", "sRGB") != "linear",
                                        .scale = static_cast<float>(texture.parameters.number("scale", 1.0)),
                                        .inverts = texture.parameters.boolean("invert", false)}));
    texture.mask = static_cast<uint32_t>(scene_.masks.size() - 1);
  }
  return Holes{*texture.mask, uv_of(texture.parameters)};
}

std::optional<Primitive> PbrtShapes::read_ply(const PbrtParameters& parameters, bool wants_uv) {
  const fs::path file = find_file(parameters);
  if (!has_ending(file.string(), ".ply"))
    fail_input(fmt::format("'{}' does not end in '.ply'", file.filename().string()), parameters.where(),
               has_ending(file.string(), ".gz") ? "unpack it first" : "");
  const MeshData data =
      load_mesh_of_file(file, wants_uv ? MeshMasks::given : MeshMasks::none, scene_.mesh_warnings);
  return primitive_of(data, wants_uv ? std::optional(0u) : std::nullopt);
}

std::optional<Primitive> PbrtShapes::read_geometry(const std::string& type, const PbrtParameters& parameters,
                                                   dmat4& shape_from_mesh, bool wants_uv) {
  if (type == "trianglemesh") return pbrt_triangles(parameters);
  if (type == "bilinearmesh") return pbrt_patches(parameters, scene_.of_meshes);
  if (type == "plymesh") return read_ply(parameters, wants_uv);
  if (!is_round(type)) return std::nullopt;
  const auto matrix = shape_from_unit(type, parameters);
  if (!matrix) return std::nullopt;
  shape_from_mesh = *matrix;
  return type == "disk" ? unit_disk() : unit_sphere();
}

std::optional<PbrtShapes::Mesh> PbrtShapes::mesh_of(const std::string& type,
                                                    const PbrtParameters& parameters) {
  const auto holes = holes_of(parameters);
  Mesh result;
  auto mesh = std::optional<Primitive>();
  std::string key;
  if (is_round(type)) {
    if (const auto matrix = shape_from_unit(type, parameters)) {
      key = type;
      result.shape_from_mesh = *matrix;
      scene_.of_meshes.add(fmt::format("{} is made of triangles", type),
                           fmt::format("{}s are made of triangles", type));
    }
  }
  if (type == "plymesh") key = find_file(parameters).string();
  if (holes) {
    key += key.empty() ? "" : fmt::format(" {}", holes->mask);
    for (int i = 0; i < 9 && !key.empty(); ++i) key += fmt::format(" {}", holes->to_uv[i / 3][i % 3]);
  }
  if (const auto known = known_.find(key); !key.empty() && known != known_.end()) {
    result.mesh = known->second;
    return result;
  }
  mesh = read_geometry(type, parameters, result.shape_from_mesh, holes.has_value());
  if (!mesh) {
    scene_.of_meshes.leave_out(is_round(type) ? "part of a shape" : "shape", type);
    return std::nullopt;
  }
  mesh->mask.reset();
  if (holes) {
    const bool is_all_hole = scene_.masks[holes->mask].bits == std::vector<uint32_t>{0};
    if (place_texture(*mesh, holes->to_uv) || is_all_hole)
      mesh->mask = holes->mask;
    else
      scene_.of_meshes.add("mesh has holes, but no texture coordinates that can be used: it is solid",
                           "meshes have holes, but no texture coordinates that can be used: they are solid");
  }
  result.mesh = scene_.meshes.size();
  if (!key.empty()) known_[key] = result.mesh;
  scene_.meshes.push_back(std::move(*mesh));
  return result;
}

std::optional<Light> PbrtShapes::light_of(const std::string& type, const PbrtParameters& parameters,
                                          const dmat4& world_from_shape, bool reverses) {
  dmat4 shape_from_mesh(1.0);
  std::optional<Light> light;
  bool is_exact = true;
  if (is_round(type)) {
    const auto matrix = shape_from_unit(type, parameters);
    if (!matrix || (type == "sphere" && reverses)) return std::nullopt;
    const dmat4 world = world_from_shape * *matrix;
    light = type == "disk" ? disk_light(world, is_exact) : sphere_light(world, is_exact);
  } else if (auto mesh = read_geometry(type, parameters, shape_from_mesh, false)) {
    place(*mesh, world_from_shape);
    light = rect_light(*mesh);
    // A mesh shines to where its normals look.
    if (light && mesh->has_normals &&
        glm::dot(mesh->vertices[mesh->triangles.front().x].n, light->direction_world) < 0.0)
      turn_around(*light);
  }
  if (light && reverses) turn_around(*light);
  if (light && !is_exact)
    scene_.of_views.add("ellipse that shines is a round one of the same size",
                        "ellipses that shine are round ones of the same size");
  return light;
}

}  // namespace umbrameter
