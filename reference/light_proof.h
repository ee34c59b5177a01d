// SPDX-License-Identifier: Apache-2.0
#pragma once
// Pixels whose light needs no ray: proven to see all of it or nothing of it.

#include "reference/light_patch.h"
#include "reference/occluder_tree.h"
#include "scenes/scene.h"

#include <array>
#include <cstdint>
#include <span>

namespace umbrameter {

enum class LightProof : uint8_t {
  none,
  below_horizon,  // the receiver's own surface hides the light
  covered,        // one triangle without holes blocks every ray
  lit,            // no triangle meets the shaft, the hull of the ray origin and the light
};

/// As many pixels as one walk of the tree serves.
inline constexpr uint32_t kShafts = 16;

struct ShaftPixel {
  LightPatch patch;
  glm::vec3 ray_origin_world{0.0f};
  glm::vec3 n_geometric_world{0.0f};
};

/// The ways from the ray origin to the patch's corners, in turn around it.
struct PatchCorners {
  std::array<glm::vec3, 4> ways_world;
  float greatest_length = 0.0f;
};
PatchCorners corners_of(const LightPatch& patch);
/// Where the shaft ends, in ways to the patch: far enough for all of the scene when the light is at infinity.
float shaft_end(const LightPatch& patch, double scene_extent_world);
/// Whether nothing but an occluder can keep the pixel from seeing all of the light, by more than rounding.
bool only_occluders_matter(const LightPatch& patch, const PatchCorners& corners);
/// Of the scene's size: rays and edges are off by less.
inline constexpr float kShaftRoundoffs = 4e-6f;

/// Proofs for up to kShafts pixels, best near each other. All tests err towards `none`: a triangle counts as met
/// within rounding of a shaft, and as covering only when it does so by more than rounding, so that tracing the
/// rays all the same gives the same bits. `scene` is the one the tree was built over, `scene_extent_world` its
/// greatest coordinate.
std::array<LightProof, kShafts> prove_light(const OccluderTree& tree, const Scene& scene,
                                            double scene_extent_world, std::span<const ShaftPixel> pixels);

}  // namespace umbrameter
