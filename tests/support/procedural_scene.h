// SPDX-License-Identifier: Apache-2.0
#pragma once
// Small scenes in code, for tests whose answer is known in closed form. y is up.

#include "scenes/scene.h"

#include <glm/mat4x4.hpp>

namespace umbrameter {

/// Two triangles a b c, a c d; faces the side from which a b c d is counter-clockwise.
void add_quad(Scene& scene, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
              const glm::dvec3& d);

/// Horizontal rectangle at height y, `size` along x and z, facing +y.
void add_floor(Scene& scene, const glm::dvec2& size, double y = 0.0, const glm::dvec2& center_xz = {0, 0});

/// Closed axis-aligned box, facing outwards.
void add_box(Scene& scene, const glm::dvec3& min, const glm::dvec3& max);

/// Horizontal regular polygon inscribed in the circle, facing +y.
void add_disk(Scene& scene, const glm::dvec3& center, double radius, int corners);

/// Closed latitude-longitude sphere with its vertices on the sphere, facing outwards.
void add_sphere(Scene& scene, const glm::dvec3& center, double radius, int rings);

/// A camera straight above `at`, far enough for a square picture to show `width` world units across at that
/// height.
Camera camera_above(const glm::dvec3& at, double width, double height_above);

/// Lights that face straight down from `center`.
Light rect_light_above(const glm::dvec3& center, const glm::dvec2& size_xz);
Light disk_light_above(const glm::dvec3& center, double radius);
Light sphere_light(const glm::dvec3& center, double radius);
/// `to_sun` need not be unit.
Light sun_light(const glm::dvec3& to_sun, double half_angle_rad);

/// Derives bounds, the near plane and the hash after the triangles are in.
void finish_scene(Scene& scene);

/// The scene moved by a rigid motion or a uniform scaling about the origin: geometry, camera and lights.
Scene moved_scene(const Scene& scene, const glm::dmat4& moved_from_world);
Scene scaled_scene(const Scene& scene, double scale);

}  // namespace umbrameter
