// SPDX-License-Identifier: Apache-2.0
#include "scenes/check_scene.h"

#include "scenes/instances.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace umbrameter {
namespace {

using glm::dvec3;

constexpr double kFarthestTarget_world = 50.0;
constexpr double kNearestTarget_world = 0.02;
constexpr size_t kEdgesPerHoleEdge = 10;  // with more holes than that a part is a sheet, and meant to be

bool is_behind(const Scene& scene, const Light& light) {
  const auto lies_behind = [&](const dvec3& p) {
    return glm::dot(p - light.center_world, light.direction_world) <= 0.0;
  };
  const auto all_behind = [&](const Instance& instance) {
    for (uint32_t v = 0; v < instance.mesh->positions.size(); ++v) {
      if (!lies_behind(instance.p_world(v))) return false;
    }
    return true;
  };
  return std::ranges::all_of(scene.positions_world, [&](const glm::vec3& p) { return lies_behind(p); }) &&
         std::ranges::all_of(list_instances(scene), all_behind);
}

void check_lights(const Scene& scene, std::vector<std::string>& found) {
  for (const Light& light : scene.lights) {
    const bool is_flat = light.type == LightType::rect || light.type == LightType::disk;
    if (is_flat && is_behind(scene, light))
      found.push_back(fmt::format("light '{}' faces away: all of the scene is behind it", light.name));
    if (light.type == LightType::sun && light.direction_world.y > 0.0)
      found.push_back(fmt::format("sun '{}' shines upwards: 'direction' points away from it", light.name));
  }
}

/// The inner side of a plane through the eye or before it: dot(n, p - eye) > distance.
struct Side {
  dvec3 n;
  double distance = 0.0;
};

/// For a picture twice as wide as high: wider than usual, so that no camera is blamed for a narrow one.
std::array<Side, 5> sides_of(const Camera& camera) {
  constexpr double kWidth = 2.0;  // over the height
  const dvec3 forward = glm::normalize(camera.at_world - camera.eye_world);
  const dvec3 right = glm::normalize(glm::cross(forward, camera.up_world));
  const dvec3 up = glm::cross(right, forward);
  const double half_height = std::tan(0.5 * glm::radians(camera.vertical_fov_deg));
  return {{{forward, camera.near_world},
           {forward * half_height + up},
           {forward * half_height - up},
           {forward * (half_height * kWidth) + right},
           {forward * (half_height * kWidth) - right}}};
}

/// What of the convex polygon lies on the inner side (Sutherland and Hodgman 1974); corners from the eye.
std::vector<dvec3> clipped(const std::vector<dvec3>& polygon, const Side& side) {
  std::vector<dvec3> kept;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const dvec3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double at_p = glm::dot(side.n, p) - side.distance, at_q = glm::dot(side.n, q) - side.distance;
    if (at_p > 0.0) kept.push_back(p);
    if ((at_p > 0.0) != (at_q > 0.0)) kept.push_back(p + (q - p) * (at_p / (at_p - at_q)));
  }
  return kept;
}

bool sees_anything(const Scene& scene) {
  const std::array<Side, 5> sides = sides_of(scene.camera);
  const auto is_seen = [&](const std::array<dvec3, 3>& corners) {
    std::vector<dvec3> polygon;
    for (const dvec3& p : corners) polygon.push_back(p - scene.camera.eye_world);
    for (const Side& side : sides) polygon = clipped(polygon, side);
    return !polygon.empty();
  };
  const auto shows_any = [&](const Instance& instance) {
    for (uint32_t t = 0; t < instance.mesh->triangles.size(); ++t) {
      if (is_seen(instance.corners_world(t))) return true;
    }
    return false;
  };
  const auto& p = scene.positions_world;
  return std::ranges::any_of(scene.triangles,
                             [&](const glm::uvec3& t) {
                               return is_seen({p[t.x], p[t.y], p[t.z]});
                             }) ||
         std::ranges::any_of(list_instances(scene), shows_any);
}

void check_camera(const Scene& scene, std::vector<std::string>& found) {
  if (!sees_anything(scene)) found.push_back("the camera sees nothing");
  const double distance = glm::distance(scene.camera.eye_world, scene.camera.at_world);
  if (distance >= kNearestTarget_world && distance <= kFarthestTarget_world) return;
  found.push_back(fmt::format(
      "the camera is {:.4g} m from its target: are these metres? ('scale' of a mesh turns other units)",
      distance));
}

/// Every vertex by the lowest one at its place.
std::vector<uint32_t> merged_vertices(const Scene& scene, const MeshPart& part) {
  std::vector<uint32_t> vertices;
  for (uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
    for (int c = 0; c < 3; ++c) vertices.push_back(scene.triangles[t][c]);
  }
  std::vector<uint32_t> order(vertices.size());
  for (uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto place = [&](uint32_t i) {
    const glm::vec3& p = scene.positions_world[vertices[i]];
    return std::tie(p.x, p.y, p.z);
  };
  std::sort(order.begin(), order.end(), [&](uint32_t i, uint32_t j) { return place(i) < place(j); });
  std::vector<uint32_t> merged(vertices.size());
  for (size_t i = 0; i < order.size(); ++i) {
    const bool is_same = i > 0 && place(order[i]) == place(order[i - 1]);
    merged[order[i]] = is_same ? merged[order[i - 1]] : order[i];
  }
  return merged;
}

struct EdgeCount {
  size_t all = 0;
  size_t open = 0;  // with one triangle
};

EdgeCount count_edges(const Scene& scene, const MeshPart& part) {
  const std::vector<uint32_t> vertex = merged_vertices(scene, part);
  std::vector<std::pair<uint32_t, uint32_t>> edges;
  for (size_t i = 0; i < vertex.size(); ++i) {
    const uint32_t from = vertex[i], to = vertex[i % 3 == 2 ? i - 2 : i + 1];
    edges.push_back(std::minmax(from, to));
  }
  std::sort(edges.begin(), edges.end());
  EdgeCount count;
  for (size_t i = 0; i < edges.size();) {
    size_t next = i + 1;
    while (next < edges.size() && edges[next] == edges[i]) ++next;
    ++count.all;
    count.open += next - i == 1 ? 1 : 0;
    i = next;
  }
  return count;
}

/// Six times the volume that the part encloses; negative when its triangles face inwards.
double signed_volume(const Scene& scene, const MeshPart& part) {
  const auto corner = [&](uint32_t t, int c) { return dvec3(scene.positions_world[scene.triangles[t][c]]); };
  const dvec3 origin = corner(part.first_triangle, 0);
  double sum = 0.0;
  for (uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t)
    sum += glm::dot(corner(t, 0) - origin, glm::cross(corner(t, 1) - origin, corner(t, 2) - origin));
  return sum;
}

/// A room faces inwards.
bool holds_camera(const Scene& scene, const MeshPart& part) {
  Bounds3 bounds;
  for (uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
    for (int c = 0; c < 3; ++c) {
      const dvec3 p(scene.positions_world[scene.triangles[t][c]]);
      bounds.min = glm::min(bounds.min, p);
      bounds.max = glm::max(bounds.max, p);
    }
  }
  const dvec3& eye = scene.camera.eye_world;
  return glm::all(glm::greaterThan(eye, bounds.min)) && glm::all(glm::lessThan(eye, bounds.max));
}

void check_part(const Scene& scene, const MeshPart& part, std::vector<std::string>& found) {
  const EdgeCount edges = count_edges(scene, part);
  if (edges.open > 0 && edges.open * kEdgesPerHoleEdge <= edges.all) {
    found.push_back(fmt::format("'{}' is not closed: {} of {} edges have one triangle", part.name, edges.open,
                                edges.all));
  } else if (edges.open == 0 && !holds_camera(scene, part) && signed_volume(scene, part) < 0.0) {
    found.push_back(fmt::format("'{}' is inside out: its triangles face inwards", part.name));
  }
}

/// The mesh itself, as its first instance stands to the camera: no instance turns it inside out or opens it.
void check_instanced(const Scene& scene, const InstancedMesh& mesh, std::vector<std::string>& found) {
  const glm::mat4x3& place = mesh.world_from_mesh.front();
  Scene alone;
  alone.positions_world = mesh.positions;
  alone.triangles = mesh.triangles;
  alone.camera.eye_world =
      glm::inverse(glm::dmat3(place[0], place[1], place[2])) * (scene.camera.eye_world - dvec3(place[3]));
  std::vector<std::string> own;
  for (const MeshPart& part : mesh.parts) check_part(alone, part, own);
  for (std::string& one : own) {  // its mirror image has said the same
    if (std::ranges::find(found, one) == found.end()) found.push_back(std::move(one));
  }
}

}  // namespace

std::vector<std::string> check_scene(const Scene& scene) {
  std::vector<std::string> found;
  check_lights(scene, found);
  check_camera(scene, found);
  for (const MeshPart& part : scene.parts) check_part(scene, part, found);
  for (const auto& mesh : scene.instanced) check_instanced(scene, *mesh, found);
  return found;
}

}  // namespace umbrameter
