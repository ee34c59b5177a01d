// SPDX-License-Identifier: Apache-2.0
#include "scenes/mitsuba/read_mitsuba.h"

#include "scenes/file_ending.h"
#include "scenes/foreign/area_lights.h"
#include "scenes/foreign/mesh_of_file.h"
#include "scenes/foreign/round_shapes.h"
#include "scenes/mitsuba/mitsuba_masks.h"
#include "scenes/mitsuba/mitsuba_numbers.h"
#include "scenes/mitsuba/mitsuba_views.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <string_view>

namespace umbrameter {
namespace {

namespace fs = std::filesystem;
using glm::dmat4;
using glm::dvec3;

// Appearance and settings: nothing that a shadow depends on.
constexpr std::array<std::string_view, 14> kOtherObjects = {
    "bsdf",     "texture", "integrator", "film", "sampler", "rfilter", "default",
    "spectrum", "rgb",     "alias",      "path", "string",  "integer", "boolean"};
const glm::dmat3 kVUpwards(dvec3(1, 0, 0), dvec3(0, -1, 0), dvec3(0, 1, 1));
constexpr int kDeepestShape = 16;

bool is_meshed(const std::string& type) {
  return type == "obj" || type == "ply";
}

class MitsubaReader {
 public:
  explicit MitsubaReader(const fs::path& path)
      : tree_(read_mitsuba_tree(path)),
        objects_(tree_.root),
        masks_(
            objects_, [this](const auto& name, const auto& where) { return find_file(name, where); },
            scene_) {
    scene_.path = path;
    scene_.side_files = tree_.files;
  }

  ForeignScene run() {
    for (const MitsubaNode& child : tree_.root.children) {
      if (child.tag == "path") folders_.push_back(scene_.path.parent_path() / child.get("value"));
    }
    for (const MitsubaNode& child : tree_.root.children) {
      const MitsubaNode& object = objects_.resolve(child);
      if (object.tag == "shape") {
        for (ForeignShape& shape : shapes_of(object, 0)) scene_.shapes.push_back(std::move(shape));
      } else if (object.tag == "sensor") {
        add_mitsuba_camera(object, objects_, scene_);
      } else if (object.tag == "emitter") {
        add_mitsuba_lamp(object, scene_);
      } else if (std::ranges::find(kOtherObjects, object.tag) == kOtherObjects.end()) {
        scene_.of_meshes.leave_out("object", object.tag);
      }
    }
    return std::move(scene_);
  }

 private:
  /// Beside the file that names it, then beside the scene, then in its <path>s.
  fs::path find_file(const std::string& name, const MitsubaNode& node) {
    std::vector<fs::path> folders{fs::path(node.where.file).parent_path(), scene_.path.parent_path()};
    folders.insert(folders.end(), folders_.begin(), folders_.end());
    std::error_code ignored;
    for (const fs::path& folder : folders) {
      if (name.empty() || !fs::is_regular_file(folder / name, ignored)) continue;
      scene_.side_files.push_back(folder / name);
      return folder / name;
    }
    fail_input(fmt::format("file '{}' is not there", name), node.where);
  }

  /// What `node` shows; a group shows nothing by itself. `depth` 0: in the scene, where shapes may shine.
  std::vector<ForeignShape> shapes_of(const MitsubaNode& node, int depth) {
    const std::string& type = node.get("type");
    if (depth > kDeepestShape) fail_input("shapes are nested deeper than 16", node.where);
    if (type == "instance") return instance_of(node, depth);
    if (type == "shapegroup") return {};
    if (type == "merge") return members_of(node, depth + 1);
    if (depth == 0 && add_light(node)) return {};
    const MitsubaSurface surface = masks_.surface_of(node);
    if (surface.is_nothing) {
      scene_.of_meshes.add("shape without a surface (null) is left out",
                           "shapes without a surface (null) are left out");
      return {};
    }
    const auto mesh = mesh_of(node, surface);
    if (!mesh) return {};
    return {{*mesh, name_of(node), aliases_of(node), placed(node)}};
  }

  std::vector<ForeignShape> members_of(const MitsubaNode& group, int depth) {
    std::vector<ForeignShape> members;
    for (const MitsubaNode* shape : objects_.nested(group, "shape")) {
      if (depth > 0 && !objects_.nested(*shape, "emitter").empty())
        scene_.of_views.add("emitter in a group of shapes is left out",
                            "emitters in groups of shapes are left out");
      std::ranges::move(shapes_of(*shape, depth), std::back_inserter(members));
    }
    return members;
  }

  std::vector<ForeignShape> instance_of(const MitsubaNode& node, int depth) {
    const dmat4 world_from_group = mitsuba_transform(node, "to_world");
    std::vector<ForeignShape> shown;
    for (const MitsubaNode* group : objects_.nested(node, "shape")) {
      const auto [known, is_new] = groups_.try_emplace(group);
      if (!is_new && !known->second) fail_input("a group of shapes holds itself", node.where);
      if (is_new) known->second = members_of(*group, depth + 1);
      for (ForeignShape shape : *known->second) {
        shape.world_from_mesh = world_from_group * shape.world_from_mesh;
        if (!node.get("id").empty()) shape.aliases.push_back(node.get("id"));
        shown.push_back(std::move(shape));
      }
      shown_ += known->second->size();
      if (shown_ > kMaxShownShapes) fail_input("instances show more than 2,000,000 shapes", node.where);
    }
    return shown;
  }

  static std::string name_of(const MitsubaNode& node) {
    if (!node.get("id").empty()) return node.get("id");
    const std::string file = fs::path(node.text("filename", "")).stem().string();
    return file.empty() ? node.get("type") : file;
  }

  std::vector<std::string> aliases_of(const MitsubaNode& node) const {
    std::vector<std::string> names;
    for (const MitsubaNode* bsdf : objects_.nested(node, "bsdf")) {
      if (!bsdf->get("id").empty()) names.push_back(bsdf->get("id"));
    }
    return names;
  }

  static dmat4 placed(const MitsubaNode& node) {
    dmat4 world = mitsuba_transform(node, "to_world");
    if (node.get("type") != "sphere") return world;
    const MitsubaNode* center = node.find("center");
    dmat4 own(node.number("radius", 1.0));
    own[3] = glm::dvec4(center == nullptr ? dvec3(0.0) : mitsuba_vector(*center, 0.0), 1.0);
    return world * own;
  }

  /// In scene_.meshes; absent and counted for what is not read.
  std::optional<size_t> mesh_of(const MitsubaNode& node, const MitsubaSurface& surface) {
    const std::string& type = node.get("type");
    std::string key = type;
    if (is_meshed(type)) {
      key += fmt::format(" {} {} {}", find_file(node.text("filename", ""), node).string(),
                         node.boolean("face_normals", false), node.boolean("flip_tex_coords", type == "obj"));
    }
    if (surface.mask) {
      key += fmt::format(" {}", *surface.mask);
      for (int i = 0; i < 9; ++i) key += fmt::format(" {}", surface.to_uv[i / 3][i % 3]);
    }
    const auto [known, is_new] = meshes_.try_emplace(key);
    if (is_new) {
      if (auto mesh = read_mesh(node, surface)) {
        known->second = scene_.meshes.size();
        scene_.meshes.push_back(std::move(*mesh));
      }
    }
    if (!known->second) scene_.of_meshes.leave_out("shape", type);
    if (type == "sphere" || type == "disk")
      scene_.of_meshes.add(fmt::format("{} is made of triangles", type),
                           fmt::format("{}s are made of triangles", type));
    return known->second;
  }

  std::optional<Primitive> read_mesh(const MitsubaNode& node, const MitsubaSurface& surface) {
    auto mesh = read_geometry(node, surface.mask);
    if (!mesh || !surface.mask) return mesh;
    mesh->mask = surface.mask;
    glm::dmat3 from_file(1.0);
    if (is_meshed(node.get("type")) && node.boolean("flip_tex_coords", node.get("type") == "obj"))
      from_file = kVUpwards;
    const bool is_all_hole = scene_.masks[*surface.mask].bits == std::vector<uint32_t>{0};
    if (place_texture(*mesh, kVUpwards * surface.to_uv * from_file) || is_all_hole) return mesh;
    mesh->mask.reset();
    scene_.of_meshes.add("mesh has holes, but no texture coordinates that can be used: it is solid",
                         "meshes have holes, but no texture coordinates that can be used: they are solid");
    return mesh;
  }

  std::optional<Primitive> read_geometry(const MitsubaNode& node, std::optional<uint32_t> mask) {
    const std::string& type = node.get("type");
    if (type == "rectangle") return unit_rectangle();
    if (type == "disk") return unit_disk();
    if (type == "sphere") return unit_sphere();
    if (type == "cube") return unit_cube();
    if (!is_meshed(type)) return std::nullopt;
    const fs::path file = find_file(node.text("filename", ""), node);
    if (!has_ending(file.string(), "." + type) && !has_ending(file.string(), ".obj.zst"))
      fail_input(fmt::format("'{}' does not end in '.{}'", file.filename().string(), type), node.where);
    const MeshData data =
        load_mesh_of_file(file, mask ? MeshMasks::given : MeshMasks::none, scene_.mesh_warnings);
    scene_.side_files.insert(scene_.side_files.end(), data.side_files.begin(), data.side_files.end());
    Primitive mesh = primitive_of(data, mask);
    const bool is_flat = node.boolean("face_normals", false);
    if (!is_flat && !mesh.has_normals)
      scene_.of_meshes.add("mesh without normals is shaded flat, not smoothed",
                           "meshes without normals are shaded flat, not smoothed");
    if (is_flat) {
      mesh.has_normals = false;
      for (Primitive::Vertex& vertex : mesh.vertices) vertex.n = dvec3(0.0);
    }
    return mesh;
  }

  /// Whether the shape of `node` is a light, and thereby no mesh.
  bool add_light(const MitsubaNode& node) {
    const auto emitters = objects_.nested(node, "emitter");
    if (emitters.empty()) return false;
    const MitsubaNode& emitter = *emitters.front();
    if (emitter.get("type") != "area") {
      scene_.of_views.leave_out("emitter", emitter.get("type"));
      return false;
    }
    bool is_exact = true;
    std::optional<Light> light = light_of(node, is_exact);
    if (!light) {
      scene_.of_views.add(
          "shape that shines is no rectangle, disk or sphere: it is a mesh, not a light",
          "shapes that shine are no rectangles, disks or spheres: they are meshes, not lights");
      return false;
    }
    if (!is_exact)
      scene_.of_views.add("ellipse that shines is a round one of the same size",
                          "ellipses that shine are round ones of the same size");
    if (const MitsubaNode* radiance = emitter.find("radiance");
        radiance != nullptr && objects_.resolve(*radiance).tag == "texture")
      scene_.of_views.add("light of a textured radiance shines evenly",
                          "lights of a textured radiance shine evenly");
    light->name = mitsuba_light_name(emitter, node.get("id"));
    scene_.lights.push_back(std::move(*light));
    return true;
  }

  std::optional<Light> light_of(const MitsubaNode& node, bool& is_exact) {
    const std::string& type = node.get("type");
    const dmat4 world = placed(node);
    const bool flips = node.boolean("flip_normals", false);
    if (type == "sphere") {
      if (flips) return std::nullopt;  // it shines inwards
      return sphere_light(world, is_exact);
    }
    std::optional<Light> light;
    bool is_turned = flips;
    if (type == "disk") {
      light = disk_light(world, is_exact);
    } else if (auto mesh = type == "rectangle" || is_meshed(type) ? read_geometry(node, {}) : std::nullopt) {
      place(*mesh, world);
      light = rect_light(*mesh);
      if (light && is_meshed(type) &&
          shines_backwards(*mesh, *light, glm::determinant(glm::dmat3(world)) < 0.0))
        is_turned = !is_turned;
    }
    if (light && is_turned) turn_around(*light);
    return light;
  }

  /// A mesh shines to where its normals look, else to where its winding faces after the transform.
  static bool shines_backwards(const Primitive& mesh, const Light& light, bool is_mirrored) {
    if (!mesh.has_normals) return is_mirrored;
    return glm::dot(mesh.vertices[mesh.triangles.front().x].n, light.direction_world) < 0.0;
  }

  static constexpr size_t kMaxShownShapes = 2'000'000;

  MitsubaTree tree_;
  MitsubaObjects objects_;
  ForeignScene scene_;
  std::vector<fs::path> folders_;
  MitsubaMasks masks_;
  std::map<const MitsubaNode*, std::optional<std::vector<ForeignShape>>> groups_;  // unset: being read
  size_t shown_ = 0;                                                               // by instances
  std::map<std::string, std::optional<size_t>> meshes_;
};

}  // namespace

ForeignScene read_mitsuba(const fs::path& path) {
  return MitsubaReader(path).run();
}

}  // namespace umbrameter
