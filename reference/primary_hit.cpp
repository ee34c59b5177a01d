#include "reference/primary_hit.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace umbrameter {

namespace {

struct Corners {
  glm::dvec3 a, b, c;
};

Corners corners_of(const Scene& scene, uint32_t triangle) {
  const glm::uvec3 index = scene.triangles[triangle];
  return {scene.positions_world[index.x], scene.positions_world[index.y], scene.positions_world[index.z]};
}

/// Embree found the triangle; its plane gives the point to double precision. Edge-on, Embree's distance is
/// better.
glm::dvec3 point_on_plane(const glm::dvec3& eye, const glm::dvec3& d, const glm::dvec3& n,
                          const glm::dvec3& a, double embree_distance) {
  constexpr double kEdgeOn = 1e-9;
  const double slope = glm::dot(n, d);
  if (std::abs(slope) > kEdgeOn) return eye + d * (glm::dot(n, a - eye) / slope);
  const glm::dvec3 p = eye + d * embree_distance;
  return p - n * glm::dot(n, p - a);
}

glm::dvec3 shading_normal(const Scene& scene, uint32_t triangle, const Corners& t, const glm::dvec3& p,
                          const glm::dvec3& n_geometric) {
  if (scene.normals_world.empty()) return n_geometric;
  const glm::dvec3 area2 = glm::cross(t.b - t.a, t.c - t.a);
  const double scale = 1.0 / glm::dot(area2, area2);
  const double weight_b = glm::dot(glm::cross(p - t.a, t.c - t.a), area2) * scale;
  const double weight_c = glm::dot(glm::cross(t.b - t.a, p - t.a), area2) * scale;
  const glm::uvec3 index = scene.triangles[triangle];
  const glm::dvec3 sum = (1.0 - weight_b - weight_c) * glm::dvec3(scene.normals_world[index.x]) +
                         weight_b * glm::dvec3(scene.normals_world[index.y]) +
                         weight_c * glm::dvec3(scene.normals_world[index.z]);
  const double length = glm::length(sum);
  if (!(length > 0.0)) return n_geometric;
  const glm::dvec3 n = sum / length;
  return glm::dot(n, n_geometric) < 0.0 ? -n : n;
}

/// Unit; zero at the light's very centre.
glm::dvec3 to_center_of(const Light& light, const glm::dvec3& p_world) {
  if (light.type == LightType::sun) return -light.direction_world;
  const glm::dvec3 way = light.center_world - p_world;
  const double length = glm::length(way);
  return length > 0.0 ? way / length : glm::dvec3(0.0);
}

}  // namespace

glm::vec3 shadow_ray_origin(const glm::dvec3& p_world, const glm::dvec3& n_world,
                            const glm::dvec3& to_light_world, const glm::dvec3& a_world,
                            const glm::dvec3& b_world, const glm::dvec3& c_world) {
  // Embree computes the distance from dot(a - origin, normal) with the normal from a cross product of edges.
  // The product's error grows with the reach of the triangle and with how thin it is; slivers are capped.
  constexpr double kRoundoffs = 8.0;
  constexpr double kThinnest = 64.0;
  const glm::dvec3 ab = b_world - a_world;
  const glm::dvec3 ac = c_world - a_world;
  const glm::dvec3 bc = c_world - b_world;
  const double edge2 = std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(bc, bc)});
  const double thinness = std::min(kThinnest, edge2 / glm::length(glm::cross(ab, ac)));
  const double reach = std::max(
      {glm::distance(a_world, p_world), glm::distance(b_world, p_world), glm::distance(c_world, p_world)});
  const double needed = kRoundoffs * 0x1p-24 * reach * thinness;

  // Towards the light the point stays on its ray: raised along the normal it would see round the blocker's edge. Where the
  // light stands low the way there is long.
  constexpr double kLeastCosine = 0.2;
  const double cosine = glm::dot(n_world, to_light_world);
  const glm::dvec3 up = cosine > kLeastCosine ? to_light_world / cosine : n_world;

  // Rounding to float moves the point too: raise it until it is verifiably high enough.
  double raise = needed;
  glm::vec3 origin(p_world + raise * up);
  for (;;) {
    const double height = glm::dot(n_world, glm::dvec3(origin) - p_world);
    if (height >= needed) return origin;
    raise = 2.0 * raise + (needed - height);
    origin = glm::vec3(p_world + raise * up);
  }
}

PrimaryCamera::PrimaryCamera(const Scene& scene, int width_px, int height_px)
    : scene_(scene),
      width_px_(width_px),
      height_px_(height_px),
      forward_world_(glm::normalize(scene.camera.at_world - scene.camera.eye_world)) {}

std::optional<PrimaryHit> PrimaryCamera::hit(const EmbreeScene& embree, int x, int y) const {
  const Camera& camera = scene_.camera;
  const glm::dvec3 d_world =
      camera_ray_direction_world(camera, glm::dvec2(x + 0.5, y + 0.5), width_px_, height_px_);
  RTCRayHit query{};
  query.ray.org_x = static_cast<float>(camera.eye_world.x);
  query.ray.org_y = static_cast<float>(camera.eye_world.y);
  query.ray.org_z = static_cast<float>(camera.eye_world.z);
  query.ray.dir_x = static_cast<float>(d_world.x);
  query.ray.dir_y = static_cast<float>(d_world.y);
  query.ray.dir_z = static_cast<float>(d_world.z);
  query.ray.tnear = static_cast<float>(camera.near_world / glm::dot(d_world, forward_world_));
  query.ray.tfar = std::numeric_limits<float>::infinity();
  query.ray.mask = ~0u;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(embree.handle(), &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;

  PrimaryHit hit;
  hit.primitive = query.hit.primID;
  const Corners t = corners_of(scene_, hit.primitive);
  Receiver& receiver = hit.receiver;
  receiver.n_geometric_world = triangle_normal_world(scene_, hit.primitive);
  if (glm::dot(receiver.n_geometric_world, d_world) > 0.0) receiver.n_geometric_world *= -1.0;
  receiver.p_world = point_on_plane(camera.eye_world, d_world, receiver.n_geometric_world, t.a,
                                    static_cast<double>(query.ray.tfar));
  receiver.n_shading_world =
      shading_normal(scene_, hit.primitive, t, receiver.p_world, receiver.n_geometric_world);
  receiver.ray_origin_world =
      shadow_ray_origin(receiver.p_world, receiver.n_geometric_world,
                        to_center_of(scene_.light(), receiver.p_world), t.a, t.b, t.c);
  return hit;
}

}  // namespace umbrameter
