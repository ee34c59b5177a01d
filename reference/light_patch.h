// SPDX-License-Identifier: Apache-2.0
#pragma once
// A light as one ray origin sees it: a flat patch, square or round, over which many shadow rays are made at
// once. What a light is and how it weighs comes from scenes/light.h, which the patch is fitted to; tests
// compare both.

#include "reference/sample_sets.h"
#include "scenes/light.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>

namespace umbrameter {

/// A linear form over the patch: center + a * per_a + b * per_b.
struct PatchForm {
  float center = 0.0f;
  float per_a = 0.0f;
  float per_b = 0.0f;
  float at(float a, float b) const { return center + a * per_a + b * per_b; }
};

/// Patch coordinates (a, b) lie in [-1,1]^2, or in the unit disk when `round`.
struct LightPatch {
  bool dark = false;  // no light from here at all: behind a one-sided light, or inside a sphere
  bool round = false;
  PatchForm direction_x;  // from the ray origin to the patch; the sun's patch is at distance 1
  PatchForm direction_y;
  PatchForm direction_z;
  PatchForm above_surface;  // positive where the sample is above the receiver's geometric plane
  PatchForm shading;        // shading normal . unnormalised direction
  float strength = 0.0f;    // irradiance weight = strength * shading / length^falloff
  bool at_infinity = false;
  float sphere_radius_world = 0.0f;  // > 0: rays end on the sphere, not on the patch
  float end_fraction = 1.0f;         // rays end at this fraction of the way: 1 less rounding error
};

/// Unit direction towards the light's centre; zero at the very centre.
glm::dvec3 to_light_center(const Light& light, const glm::dvec3& p_world);

/// The receiver of light: a point, its normals, and where its shadow rays start.
struct Receiver {
  glm::dvec3 p_world{0.0};
  glm::dvec3 n_geometric_world{0.0};
  glm::dvec3 n_shading_world{0.0};
  glm::vec3 ray_origin_world{0.0f};
};

/// `scene_extent_world` bounds the coordinates of the scene; it scales the rounding error of ray ends.
LightPatch make_light_patch(const Light& light, const Receiver& receiver, double scene_extent_world);

/// True when no point of the light is above the receiver's geometric plane: visibility is 0, exactly.
bool is_below_horizon(const LightPatch& patch);
/// True when no point of the light has a positive shading cosine.
bool is_unlit(const LightPatch& patch);
/// True when some points have one and others have not.
bool straddles_horizon(const LightPatch& patch);

}  // namespace umbrameter
