#pragma once
// What the camera sees through the centre of a pixel, to double precision, and where shadow rays start from
// it.

#include "reference/embree_scene.h"
#include "reference/light_patch.h"

#include <optional>

namespace umbrameter {

struct PrimaryHit {
  uint32_t primitive = 0;
  Receiver receiver;
};

/// The camera of one picture, ready to shoot.
class PrimaryCamera {
 public:
  PrimaryCamera(const Scene& scene, int width_px, int height_px);

  /// First surface through the centre of pixel (x, y) that is not nearer than the near plane. Normals face
  /// the camera; the shading normal lies on the geometric normal's side.
  std::optional<PrimaryHit> hit(const EmbreeScene& embree, int x, int y) const;

 private:
  const Scene& scene_;
  int width_px_;
  int height_px_;
  glm::dvec3 forward_world_;
};

/// A float point just above the plane through `p_world` (unit normal `n_world`), as near as rounding allows: high enough
/// that Embree cannot place the triangle a, b, c of that plane in front of a ray that leaves it. It lies on the way
/// `to_light_world` (unit) where that rises well over the plane, else on the normal.
glm::vec3 shadow_ray_origin(const glm::dvec3& p_world, const glm::dvec3& n_world,
                            const glm::dvec3& to_light_world, const glm::dvec3& a_world,
                            const glm::dvec3& b_world, const glm::dvec3& c_world);

}  // namespace umbrameter
