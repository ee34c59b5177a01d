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
  covered,        // one triangle blocks every ray
  lit,            // no triangle meets the shaft, the hull of the ray origin and the light
};

/// As many pixels as one walk of the tree serves.
inline constexpr uint32_t kShafts = 16;

struct ShaftPixel {
  const LightPatch* patch = nullptr;
  glm::vec3 ray_origin_world{0.0f};
  glm::vec3 n_geometric_world{0.0f};
};

/// Proofs for up to kShafts pixels, best near each other. All tests err towards `none`: a triangle counts as met
/// within rounding of a shaft, and as covering only when it does so by more than rounding, so that tracing the
/// rays all the same gives the same bits. `scene` is the one the tree was built over, `scene_extent_world` its
/// greatest coordinate.
std::array<LightProof, kShafts> prove_light(const OccluderTree& tree, const Scene& scene,
                                            double scene_extent_world, std::span<const ShaftPixel> pixels);

}  // namespace umbrameter
