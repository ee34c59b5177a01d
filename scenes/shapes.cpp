// SPDX-License-Identifier: Apache-2.0
#include "scenes/shapes.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace umbrameter {
namespace {

using glm::dvec3;
using glm::uvec3;

uint32_t add_vertex(MeshData& mesh, const dvec3& p) {
  mesh.positions.push_back(p);
  return static_cast<uint32_t>(mesh.positions.size() - 1);
}

/// Corners counter-clockwise seen from outside.
void add_quad(MeshData& mesh, uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

/// Horizontal rectangle facing +y.
void add_sheet(MeshData& mesh, double x0, double x1, double y, double z0, double z1) {
  const uint32_t a = add_vertex(mesh, {x0, y, z1});
  const uint32_t b = add_vertex(mesh, {x1, y, z1});
  const uint32_t c = add_vertex(mesh, {x1, y, z0});
  const uint32_t d = add_vertex(mesh, {x0, y, z0});
  add_quad(mesh, a, b, c, d);
}

void add_box(MeshData& mesh, const dvec3& min, const dvec3& max) {
  uint32_t corner[8];
  for (uint32_t i = 0; i < 8; ++i) {
    corner[i] =
        add_vertex(mesh, {(i & 1u) ? max.x : min.x, (i & 2u) ? max.y : min.y, (i & 4u) ? max.z : min.z});
  }
  add_quad(mesh, corner[0], corner[4], corner[6], corner[2]);  // -x
  add_quad(mesh, corner[1], corner[3], corner[7], corner[5]);  // +x
  add_quad(mesh, corner[0], corner[1], corner[5], corner[4]);  // -y
  add_quad(mesh, corner[2], corner[6], corner[7], corner[3]);  // +y
  add_quad(mesh, corner[0], corner[2], corner[3], corner[1]);  // -z
  add_quad(mesh, corner[4], corner[5], corner[7], corner[6]);  // +z
}

/// Unit circle in the plane of x and z, counter-clockwise seen from +y.
glm::dvec2 circle_xz(int index, int count) {
  const double angle_rad = 2.0 * std::numbers::pi * index / count;
  return {std::cos(angle_rad), -std::sin(angle_rad)};
}

/// Closed prism around the line x = x0, z = 0.
void add_cylinder(MeshData& mesh, double x0, double y0, double y1, double radius, int segments) {
  const uint32_t bottom = add_vertex(mesh, {x0, y0, 0.0});
  const uint32_t top = add_vertex(mesh, {x0, y1, 0.0});
  const uint32_t first = top + 1;
  for (int i = 0; i < segments; ++i) {
    const glm::dvec2 c = radius * circle_xz(i, segments);
    add_vertex(mesh, {x0 + c.x, y0, c.y});
    add_vertex(mesh, {x0 + c.x, y1, c.y});
  }
  const auto n = static_cast<uint32_t>(segments);
  for (uint32_t i = 0; i < n; ++i) {
    const uint32_t low = first + 2 * i;
    const uint32_t next_low = first + 2 * ((i + 1) % n);
    add_quad(mesh, low, next_low, next_low + 1, low + 1);
    mesh.triangles.push_back({bottom, next_low, low});
    mesh.triangles.push_back({top, low + 1, next_low + 1});
  }
}

}  // namespace

MeshData make_plane(const glm::dvec2& size) {
  MeshData mesh;
  add_sheet(mesh, -size.x / 2, size.x / 2, 0.0, -size.y / 2, size.y / 2);
  return mesh;
}

MeshData make_box(const glm::dvec3& size) {
  MeshData mesh;
  add_box(mesh, {-size.x / 2, 0.0, -size.z / 2}, {size.x / 2, size.y, size.z / 2});
  return mesh;
}

MeshData make_plate(const glm::dvec2& size, double thickness) {
  if (thickness == 0.0) return make_plane(size);
  const dvec3 half{size.x / 2, thickness / 2, size.y / 2};
  MeshData mesh;
  add_box(mesh, -half, half);
  return mesh;
}

MeshData make_sphere(double radius, int segments, bool smooth) {
  MeshData mesh;
  const int rings = segments / 2;
  const uint32_t top = add_vertex(mesh, {0, radius, 0});
  const uint32_t bottom = add_vertex(mesh, {0, -radius, 0});
  for (int ring = 1; ring < rings; ++ring) {
    const double polar_rad = std::numbers::pi * ring / rings;
    for (int i = 0; i < segments; ++i) {
      const glm::dvec2 c = std::sin(polar_rad) * circle_xz(i, segments);
      add_vertex(mesh, radius * dvec3(c.x, std::cos(polar_rad), c.y));
    }
  }
  const auto n = static_cast<uint32_t>(segments);
  const auto vertex = [&](uint32_t ring, uint32_t i) { return 2 + (ring - 1) * n + i % n; };
  const auto last = static_cast<uint32_t>(rings - 1);
  for (uint32_t i = 0; i < n; ++i) {
    mesh.triangles.push_back({top, vertex(1, i), vertex(1, i + 1)});
    for (uint32_t ring = 1; ring < last; ++ring) {
      add_quad(mesh, vertex(ring, i), vertex(ring + 1, i), vertex(ring + 1, i + 1), vertex(ring, i + 1));
    }
    mesh.triangles.push_back({bottom, vertex(last, i + 1), vertex(last, i)});
  }
  if (smooth) {
    for (const dvec3& p : mesh.positions) mesh.normals.push_back(glm::normalize(p));
  }
  return mesh;
}

MeshData make_disk(double radius, int segments) {
  MeshData mesh;
  const uint32_t center = add_vertex(mesh, {0, 0, 0});
  for (int i = 0; i < segments; ++i) {
    const glm::dvec2 c = radius * circle_xz(i, segments);
    add_vertex(mesh, {c.x, 0.0, c.y});
  }
  const auto n = static_cast<uint32_t>(segments);
  for (uint32_t i = 0; i < n; ++i) mesh.triangles.push_back({center, 1 + i, 1 + (i + 1) % n});
  return mesh;
}

MeshData make_comb(int count, double period, double bar, double length) {
  MeshData mesh;
  const double width = (count - 1) * period + bar;
  for (int i = 0; i < count; ++i) {
    const double x0 = -width / 2 + i * period;
    add_sheet(mesh, x0, x0 + bar, 0.0, -length / 2, length / 2);
  }
  return mesh;
}

MeshData make_wire(double radius, double length, int segments) {
  MeshData mesh;
  add_cylinder(mesh, 0.0, -length / 2, length / 2, radius, segments);
  for (dvec3& p : mesh.positions) p = {p.y, p.z, p.x};  // a cyclic permutation keeps the orientation
  return mesh;
}

MeshData make_stairs(int count, const glm::dvec3& size) {
  MeshData mesh;
  const double half_width = size.x / 2;
  // Step k is a column from the ground up, between z = -k d and z = -(k + 1) d; only its outside is built.
  for (int k = 0; k < count; ++k) {
    const double z0 = -k * size.z;
    const double z1 = -(k + 1) * size.z;
    const double y0 = k * size.y;
    const double y1 = (k + 1) * size.y;
    const auto v = [&](double x, double y, double z) { return add_vertex(mesh, {x, y, z}); };
    const auto quad = [&](uint32_t a, uint32_t b, uint32_t c, uint32_t d) { add_quad(mesh, a, b, c, d); };
    const double l = -half_width;
    const double r = half_width;
    quad(v(l, y0, z0), v(r, y0, z0), v(r, y1, z0), v(l, y1, z0));  // riser
    quad(v(l, y1, z0), v(r, y1, z0), v(r, y1, z1), v(l, y1, z1));  // tread
    quad(v(l, 0, z1), v(l, 0, z0), v(l, y1, z0), v(l, y1, z1));    // left side
    quad(v(r, 0, z0), v(r, 0, z1), v(r, y1, z1), v(r, y1, z0));    // right side
    quad(v(l, 0, z1), v(r, 0, z1), v(r, 0, z0), v(l, 0, z0));      // underside
  }
  const double back_z = -count * size.z;
  const double height = count * size.y;
  const uint32_t a = add_vertex(mesh, {half_width, 0, back_z});
  const uint32_t b = add_vertex(mesh, {-half_width, 0, back_z});
  const uint32_t c = add_vertex(mesh, {-half_width, height, back_z});
  const uint32_t d = add_vertex(mesh, {half_width, height, back_z});
  add_quad(mesh, a, b, c, d);
  return mesh;
}

MeshData make_colonnade(int count, double spacing, double radius, double height, int segments,
                        const glm::dvec2& lintel) {
  MeshData mesh;
  const double half_row = (count - 1) * spacing / 2;
  for (int i = 0; i < count; ++i) add_cylinder(mesh, -half_row + i * spacing, 0.0, height, radius, segments);
  if (lintel.x > 0.0) {
    const double half_length = half_row + radius;
    add_box(mesh, {-half_length, height, -lintel.x / 2}, {half_length, height + lintel.y, lintel.x / 2});
  }
  return mesh;
}

}  // namespace umbrameter
