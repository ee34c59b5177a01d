// SPDX-License-Identifier: Apache-2.0
#include "tests/support/procedural_scene.h"

#include "core/hash.h"
#include "scenes/scene_hash.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>
#include <utility>

namespace umbrameter {

namespace {

uint32_t add_vertex(Scene& scene, const glm::dvec3& p) {
  scene.positions_world.edit().emplace_back(p);
  return static_cast<uint32_t>(scene.positions_world.size() - 1);
}

Light facing_down(LightType type, const glm::dvec3& center) {
  Light light;  // its default frame faces -y
  light.name = std::string(to_text(type));
  light.type = type;
  light.center_world = center;
  return light;
}

}  // namespace

void add_quad(Scene& scene, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
              const glm::dvec3& d) {
  const uint32_t first = add_vertex(scene, a);
  add_vertex(scene, b);
  add_vertex(scene, c);
  add_vertex(scene, d);
  scene.triangles.edit().emplace_back(first, first + 1, first + 2);
  scene.triangles.edit().emplace_back(first, first + 2, first + 3);
}

void add_floor(Scene& scene, const glm::dvec2& size, double y, const glm::dvec2& center_xz) {
  const glm::dvec2 low = center_xz - 0.5 * size;
  const glm::dvec2 high = center_xz + 0.5 * size;
  add_quad(scene, {low.x, y, high.y}, {high.x, y, high.y}, {high.x, y, low.y}, {low.x, y, low.y});
}

void add_box(Scene& scene, const glm::dvec3& min, const glm::dvec3& max) {
  const auto corner = [&](int x, int y, int z) {
    return glm::dvec3(x == 0 ? min.x : max.x, y == 0 ? min.y : max.y, z == 0 ? min.z : max.z);
  };
  add_quad(scene, corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), corner(0, 1, 0));
  add_quad(scene, corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1), corner(1, 0, 1));
  add_quad(scene, corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1));
  add_quad(scene, corner(0, 1, 0), corner(0, 1, 1), corner(1, 1, 1), corner(1, 1, 0));
  add_quad(scene, corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0), corner(1, 0, 0));
  add_quad(scene, corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1));
}

void add_disk(Scene& scene, const glm::dvec3& center, double radius, int corners) {
  const uint32_t middle = add_vertex(scene, center);
  for (int i = 0; i < corners; ++i) {
    const double angle_rad = 2.0 * std::numbers::pi * i / corners;
    add_vertex(scene, center + radius * glm::dvec3(std::cos(angle_rad), 0.0, -std::sin(angle_rad)));
  }
  const auto rim = [&](int i) { return middle + 1 + static_cast<uint32_t>(i % corners); };
  for (int i = 0; i < corners; ++i) scene.triangles.edit().emplace_back(middle, rim(i), rim(i + 1));
}

void add_sphere(Scene& scene, const glm::dvec3& center, double radius, int rings) {
  const int segments = 2 * rings;
  const auto first = static_cast<uint32_t>(scene.positions_world.size());
  for (int ring = 0; ring <= rings; ++ring) {
    const double polar_rad = std::numbers::pi * ring / rings;
    for (int s = 0; s < segments; ++s) {
      const double azimuth_rad = 2.0 * std::numbers::pi * s / segments;
      add_vertex(scene, center + radius * glm::dvec3(std::sin(polar_rad) * std::cos(azimuth_rad),
                                                     std::cos(polar_rad),
                                                     -std::sin(polar_rad) * std::sin(azimuth_rad)));
    }
  }
  const auto at = [&](int ring, int s) {
    return first + static_cast<uint32_t>(ring * segments + s % segments);
  };
  for (int ring = 0; ring < rings; ++ring) {
    for (int s = 0; s < segments; ++s) {
      if (ring > 0) scene.triangles.edit().emplace_back(at(ring, s), at(ring + 1, s), at(ring, s + 1));
      if (ring + 1 < rings) {
        scene.triangles.edit().emplace_back(at(ring, s + 1), at(ring + 1, s), at(ring + 1, s + 1));
      }
    }
  }
}

Camera camera_above(const glm::dvec3& at, double width, double height_above) {
  Camera camera;
  camera.eye_world = at + glm::dvec3(0, height_above, 0);
  camera.at_world = at;
  camera.up_world = {0, 0, -1};
  camera.vertical_fov_deg = 2.0 * std::atan(0.5 * width / height_above) * 180.0 / std::numbers::pi;
  return camera;
}

Light rect_light_above(const glm::dvec3& center, const glm::dvec2& size_xz) {
  Light light = facing_down(LightType::rect, center);
  light.size_world = size_xz;
  return light;
}

Light disk_light_above(const glm::dvec3& center, double radius) {
  Light light = facing_down(LightType::disk, center);
  light.radius_world = radius;
  return light;
}

Light sphere_light(const glm::dvec3& center, double radius) {
  Light light = facing_down(LightType::sphere, center);
  light.radius_world = radius;
  return light;
}

Light sun_light(const glm::dvec3& to_sun, double half_angle_rad) {
  Light light = facing_down(LightType::sun, glm::dvec3(0.0));
  light.half_angle_rad = half_angle_rad;
  light.direction_world = -glm::normalize(to_sun);
  const glm::dvec3 helper =
      std::abs(light.direction_world.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
  light.tangent_world =
      glm::normalize(helper - light.direction_world * glm::dot(helper, light.direction_world));
  light.bitangent_world = glm::cross(light.direction_world, light.tangent_world);
  return light;
}

void finish_scene(Scene& scene) {
  scene.bounds_world = {};
  for (const glm::dvec3 p : scene.positions_world) {
    scene.bounds_world.min = glm::min(scene.bounds_world.min, p);
    scene.bounds_world.max = glm::max(scene.bounds_world.max, p);
  }
  scene.camera.near_world = 1e-4 * scene.bounds_world.diagonal();
  Hasher hasher;
  hasher.values(std::span(std::as_const(scene.positions_world)));
  hasher.values(std::span(std::as_const(scene.triangles)));
  for (const Light& light : scene.lights) {
    hasher.text(to_text(light.type)).bytes(&light.center_world, sizeof light.center_world);
    hasher.bytes(&light.direction_world, sizeof light.direction_world);
    hasher.number(light.size_world.x).number(light.size_world.y);
    hasher.number(light.radius_world).number(light.half_angle_rad);
  }
  hash_cutouts(hasher, scene);
  scene.hash = hasher.hex();
}

Scene moved_scene(const Scene& scene, const glm::dmat4& moved_from_world) {
  const auto point = [&](const glm::dvec3& p) { return glm::dvec3(moved_from_world * glm::dvec4(p, 1.0)); };
  const auto vector = [&](const glm::dvec3& v) { return glm::normalize(glm::dmat3(moved_from_world) * v); };
  Scene moved = scene;
  for (glm::vec3& p : moved.positions_world.edit()) p = point(p);
  for (glm::vec3& n : moved.normals_world.edit()) n = vector(n);
  moved.camera.eye_world = point(scene.camera.eye_world);
  moved.camera.at_world = point(scene.camera.at_world);
  moved.camera.up_world = vector(scene.camera.up_world);
  for (Light& light : moved.lights) {
    light.center_world = point(light.center_world);
    light.tangent_world = vector(light.tangent_world);
    light.bitangent_world = vector(light.bitangent_world);
    light.direction_world = vector(light.direction_world);
  }
  finish_scene(moved);
  return moved;
}

Scene scaled_scene(const Scene& scene, double scale) {
  glm::dmat4 scaling(scale);
  scaling[3][3] = 1.0;
  Scene scaled = moved_scene(scene, scaling);
  for (Light& light : scaled.lights) {
    light.size_world *= scale;
    light.radius_world *= scale;
  }
  finish_scene(scaled);
  return scaled;
}

}  // namespace umbrameter
