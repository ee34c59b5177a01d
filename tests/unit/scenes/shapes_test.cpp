// SPDX-License-Identifier: Apache-2.0
// Without these: an oracle scene's caster could have the wrong size, or a solid could be inside out or open.
#include "scenes/shapes.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <numbers>

namespace umbrameter {
namespace {

/// Volume by the divergence theorem: positive for closed, outward-facing meshes.
double signed_volume(const MeshData& mesh) {
  double volume = 0.0;
  for (const glm::uvec3& t : mesh.triangles) {
    volume += glm::dot(mesh.positions[t.x], glm::cross(mesh.positions[t.y], mesh.positions[t.z])) / 6.0;
  }
  return volume;
}

/// Sum of the triangles' area vectors: 0 for a closed mesh, (0, area, 0) for a sheet facing up.
glm::dvec3 area_vector(const MeshData& mesh) {
  glm::dvec3 area(0.0);
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a = mesh.positions[t.x];
    area += glm::cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a) / 2.0;
  }
  return area;
}

Bounds3 bounds(const MeshData& mesh) {
  Bounds3 result;
  for (const glm::dvec3& p : mesh.positions) {
    result.min = glm::min(result.min, p);
    result.max = glm::max(result.max, p);
  }
  return result;
}

void expect_closed(const MeshData& mesh, double volume) {
  EXPECT_NEAR(signed_volume(mesh), volume, 1e-12 * volume);
  EXPECT_NEAR(glm::length(area_vector(mesh)), 0.0, 1e-12);
}

TEST(Shapes, SheetsFaceUpWithTheirArea) {
  EXPECT_EQ(area_vector(make_plane({3, 2})), glm::dvec3(0, 6, 0));
  EXPECT_EQ(area_vector(make_plate({3, 2}, 0.0)), glm::dvec3(0, 6, 0));
  // n-gon in a circle of radius r: n r^2 sin(2 pi / n) / 2; a square for n = 4.
  EXPECT_NEAR(area_vector(make_disk(3.0, 4)).y, 18.0, 1e-12);
  EXPECT_NEAR(area_vector(make_disk(1.0, 4096)).y, std::numbers::pi, 2e-6);
}

TEST(Shapes, PlaneIsCentred) {
  EXPECT_EQ(bounds(make_plane({3, 2})).min, glm::dvec3(-1.5, 0, -1));
  EXPECT_EQ(bounds(make_plane({3, 2})).max, glm::dvec3(1.5, 0, 1));
}

TEST(Shapes, BoxStandsOnTheFloor) {
  const MeshData box = make_box({2, 3, 4});
  expect_closed(box, 24.0);
  EXPECT_EQ(bounds(box).min, glm::dvec3(-1, 0, -2));
  EXPECT_EQ(bounds(box).max, glm::dvec3(1, 3, 2));
}

TEST(Shapes, ThickPlateIsCentredInHeight) {
  const MeshData plate = make_plate({2, 4}, 0.5);
  expect_closed(plate, 4.0);
  EXPECT_EQ(bounds(plate).min, glm::dvec3(-1, -0.25, -2));
}

TEST(Shapes, OctahedronIsTheSmallestSphere) {
  // Four meridians, two rings: the octahedron of volume 4/3 r^3.
  const MeshData sphere = make_sphere(2.0, 4, false);
  EXPECT_EQ(sphere.triangles.size(), 8u);
  expect_closed(sphere, 32.0 / 3.0);
  EXPECT_TRUE(sphere.normals.empty());
}

TEST(Shapes, SphereIsClosedAndItsVerticesLieOnIt) {
  const MeshData sphere = make_sphere(2.0, 32, true);
  EXPECT_NEAR(glm::length(area_vector(sphere)), 0.0, 1e-12);
  EXPECT_GT(signed_volume(sphere), 0.97 * 4.0 / 3.0 * std::numbers::pi * 8.0);
  EXPECT_LT(signed_volume(sphere), 4.0 / 3.0 * std::numbers::pi * 8.0);
  for (size_t i = 0; i < sphere.positions.size(); ++i) {
    EXPECT_NEAR(glm::length(sphere.positions[i]), 2.0, 1e-12);
    EXPECT_NEAR(glm::length(2.0 * sphere.normals[i] - sphere.positions[i]), 0.0, 1e-12);
  }
}

TEST(Shapes, CombHasBarsAsWideAsAskedOnePerPeriod) {
  const MeshData comb = make_comb(3, 1.0, 0.25, 2.0);
  EXPECT_NEAR(area_vector(comb).y, 3 * 0.25 * 2.0, 1e-12);
  EXPECT_EQ(bounds(comb).min, glm::dvec3(-1.125, 0, -1));
  EXPECT_EQ(bounds(comb).max, glm::dvec3(1.125, 0, 1));
  EXPECT_EQ(comb.positions[4].x - comb.positions[0].x, 1.0);
}

TEST(Shapes, WireIsAClosedPrismAlongX) {
  // Square prism: the square with corners at radius r has the area 2 r^2.
  const MeshData wire = make_wire(0.5, 3.0, 4);
  expect_closed(wire, 1.5);
  EXPECT_EQ(bounds(wire).min.x, -1.5);
  EXPECT_EQ(bounds(wire).max.x, 1.5);
}

TEST(Shapes, StairsRiseTowardsMinusZ) {
  // Steps of 2 x 0.5 x 1: heights 0.5, 1, 1.5 over a depth of 1 each, so 2 * (0.5 + 1 + 1.5) = 6.
  const MeshData stairs = make_stairs(3, {2, 0.5, 1});
  expect_closed(stairs, 6.0);
  EXPECT_EQ(bounds(stairs).min, glm::dvec3(-1, 0, -3));
  EXPECT_EQ(bounds(stairs).max, glm::dvec3(1, 1.5, 0));
}

TEST(Shapes, ColonnadeHasColumnsAndALintel) {
  // Square columns of half diagonal 0.5: area 0.5; lintel 4 + 2 * 0.5 = 5 long, 1 deep, 0.25 high.
  expect_closed(make_colonnade(3, 2.0, 0.5, 4.0, 4, {0, 0}), 3 * 0.5 * 4.0);
  const MeshData roofed = make_colonnade(3, 2.0, 0.5, 4.0, 4, {1, 0.25});
  expect_closed(roofed, 6.0 + 1.25);
  EXPECT_EQ(bounds(roofed).max, glm::dvec3(2.5, 4.25, 0.5));
}

}  // namespace
}  // namespace umbrameter
