// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the camera sees through the centres of pixels, to double precision, and where shadow rays start from there.

#include "reference/embree_scene.h"
#include "reference/light_patch.h"
#include "scenes/instances.h"

#include <array>
#include <optional>
#include <vector>

namespace umbrameter {

/// Pixels whose primary rays are traced together: a square.
inline constexpr int kBlock = 4;

struct PrimaryHit {
  uint32_t primitive = 0;  // primitive_id: shown_id() of the triangle
  /// Its shadow rays start just above the surface, as near as rounding allows: high enough that Embree cannot place the
  /// triangle in front of a ray that leaves it. On the way to the light's centre where that rises well over the surface,
  /// else on the normal.
  Receiver receiver;
};

/// Row by row; nothing where the camera sees no surface or the picture ends.
using PrimaryBlock = std::array<std::optional<PrimaryHit>, kBlock * kBlock>;

/// The camera of one picture, ready to shoot.
class PrimaryCamera {
 public:
  PrimaryCamera(const Scene& scene, int width_px, int height_px);

  /// First surfaces through the centres of the block whose first pixel is (x0, y0) that are not nearer than the near
  /// plane. Normals face the camera; the shading normal lies on the geometric normal's side.
  PrimaryBlock hits(const EmbreeScene& embree, int x0, int y0) const;

 private:
  const Scene& scene_;
  std::vector<Instance> instances_;
  int width_px_;
  int height_px_;
  // The direction that advances 1 along the view axis, through the picture's corner and per pixel.
  glm::dvec3 corner_world_;
  glm::dvec3 per_x_world_;
  glm::dvec3 per_y_world_;
};

}  // namespace umbrameter
