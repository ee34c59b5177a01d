// SPDX-License-Identifier: Apache-2.0
#include "scenes/export_scene.h"

#include "core/hash.h"
#include "scenes/instances.h"
#include "scenes/scene_hash.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <glm/geometric.hpp>

#include <iterator>
#include <numbers>

namespace umbrameter {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson vector_json(const glm::dvec3& v) {
  return {v.x, v.y, v.z};
}

/// Rows, as written on paper.
OrderedJson matrix_json(const glm::dmat4& m) {
  OrderedJson rows = OrderedJson::array();
  for (int row = 0; row < 4; ++row) rows.push_back({m[0][row], m[1][row], m[2][row], m[3][row]});
  return rows;
}

OrderedJson camera_json(const Camera& camera, int width_px, int height_px) {
  const glm::dmat4 view = view_from_world(camera);
  const glm::dmat4 clip = clip_from_world(camera, width_px, height_px);
  return {{"eye_world", vector_json(camera.eye_world)},
          {"at_world", vector_json(camera.at_world)},
          {"up_world", vector_json(camera.up_world)},
          {"vertical_fov_deg", camera.vertical_fov_deg},
          {"near_world", camera.near_world},
          {"width_px", width_px},
          {"height_px", height_px},
          {"view_from_world", matrix_json(view)},
          {"clip_from_view", matrix_json(clip * glm::inverse(view))},
          {"clip_from_world", matrix_json(clip)},
          {"clip_depth", "reversed: near 1, infinity 0; x right, y up, -1 to 1; row 0 of a picture on top"}};
}

OrderedJson corners_json(const Light& light) {
  OrderedJson corners = OrderedJson::array();
  for (const auto& [u, v] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
    corners.push_back(vector_json(light.center_world + u * light.size_world.x * light.tangent_world +
                                  v * light.size_world.y * light.bitangent_world));
  }
  return corners;
}

OrderedJson light_json(const Light& light) {
  OrderedJson json = {{"name", light.name}, {"type", to_text(light.type)}};
  json["direction_world"] = vector_json(light.direction_world);
  json["tangent_world"] = vector_json(light.tangent_world);
  json["bitangent_world"] = vector_json(light.bitangent_world);
  if (light.type == LightType::sun) {
    json["angular_diameter_deg"] = 2.0 * light.half_angle_rad * 180.0 / std::numbers::pi;
    json["irradiance_at_normal_incidence"] = 1.0;
    return json;
  }
  json["center_world"] = vector_json(light.center_world);
  json["radiance"] = 1.0;
  if (light.type != LightType::rect) {
    json["radius_world"] = light.radius_world;
    return json;
  }
  json["size_world"] = {light.size_world.x, light.size_world.y};
  json["corners_world"] = corners_json(light);
  return json;
}

}  // namespace

std::string scene_obj_text(const Scene& scene) {
  if (!scene.instanced.empty()) return scene_obj_text(flattened(scene));
  std::string text =
      fmt::format("# {}, hash {}; world space, y up, counter-clockwise\n", scene.name, scene.hash);
  auto out = std::back_inserter(text);
  for (const glm::vec3& p : scene.positions_world)
    fmt::format_to(out, "v {:.9g} {:.9g} {:.9g}\n", p.x, p.y, p.z);
  const bool has_normals = !scene.normals_world.empty();
  for (const glm::vec3& n : scene.normals_world)
    fmt::format_to(out, "vn {:.9g} {:.9g} {:.9g}\n", n.x, n.y, n.z);
  for (const MeshPart& part : scene.parts) {
    fmt::format_to(out, "g {}\n", part.name);
    for (uint32_t k = 0; k < part.triangle_count; ++k) {
      const glm::uvec3 t = scene.triangles[part.first_triangle + k] + 1u;
      if (has_normals)
        fmt::format_to(out, "f {0}//{0} {1}//{1} {2}//{2}\n", t.x, t.y, t.z);
      else
        fmt::format_to(out, "f {} {} {}\n", t.x, t.y, t.z);
    }
  }
  return text;
}

std::string scene_json_text(const Scene& scene, const std::string& name, int width_px, int height_px) {
  const OrderedJson json = {
      {"scene", name},
      {"hash", scene.hash},
      {"mesh", "scene.obj"},
      {"mesh_hash", mesh_hash(scene)},
      {"triangles", count_shown_triangles(scene)},
      {"space", "world: right-handed, y up, metres; matrices in rows, for column vectors"},
      {"camera", camera_json(scene.camera, width_px, height_px)},
      {"light", light_json(scene.light())}};
  return json.dump(2) + "\n";
}

std::string mesh_hash(const Scene& scene) {
  Hasher hasher;
  hasher.values(std::span<const glm::vec3>(scene.positions_world));
  hasher.values(std::span<const glm::vec3>(scene.normals_world));
  hasher.values(std::span<const glm::uvec3>(scene.triangles));
  for (const MeshPart& part : scene.parts)
    hasher.text(part.name).number(part.first_triangle).number(part.triangle_count);
  hash_instances(hasher, scene);
  return hasher.hex();
}

}  // namespace umbrameter
