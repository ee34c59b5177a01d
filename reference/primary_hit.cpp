// SPDX-License-Identifier: Apache-2.0
#include "reference/primary_hit.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace umbrameter {

namespace {

constexpr uint32_t kRays = kBlock * kBlock;

/// What all points of a triangle share.
struct SeenTriangle {
  glm::dvec3 a{0.0}, b{0.0}, c{0.0};
  glm::dvec3 n_world{0.0};        // by its winding
  double needed_per_reach = 0.0;  // how high shadow rays must start, over the distance to the farthest corner
  double needed_always = 0.0;     // and besides
  bool is_flat = true;            // else:
  glm::dvec3 per_weight_b{0.0}, per_weight_c{0.0};  // barycentric weights are dot(p - a, these)
  glm::dvec3 normal_a{0.0}, normal_b{0.0}, normal_c{0.0};
};

/// Embree computes the distance from dot(a - origin, normal) with the normal from a cross product of edges. The product's
/// error grows with the reach of the triangle and with how thin it is; slivers are capped.
double needed_per_reach(const glm::dvec3& ab, const glm::dvec3& ac, double area2) {
  constexpr double kRoundoffs = 8.0;
  constexpr double kThinnest = 64.0;
  const glm::dvec3 bc = ac - ab;
  const double edge2 = std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(bc, bc)});
  return kRoundoffs * 0x1p-24 * std::min(kThinnest, edge2 / area2);
}

using Corners = std::array<glm::dvec3, 3>;

SeenTriangle see_corners(const Corners& corners) {
  SeenTriangle t;
  t.a = corners[0];
  t.b = corners[1];
  t.c = corners[2];
  const glm::dvec3 ab = t.b - t.a, ac = t.c - t.a;
  const glm::dvec3 area2 = glm::cross(ab, ac);
  t.n_world = glm::normalize(area2);
  t.needed_per_reach = needed_per_reach(ab, ac, glm::length(area2));
  return t;
}

void shade_smoothly(SeenTriangle& t, const Corners& normals) {
  const glm::dvec3 ab = t.b - t.a, ac = t.c - t.a;
  const glm::dvec3 area2 = glm::cross(ab, ac);
  t.is_flat = false;
  const double scale = 1.0 / glm::dot(area2, area2);
  t.per_weight_b = glm::cross(ac, area2) * scale;
  t.per_weight_c = glm::cross(area2, ab) * scale;
  t.normal_a = normals[0];
  t.normal_b = normals[1];
  t.normal_c = normals[2];
}

SeenTriangle see_triangle(const Scene& scene, uint32_t triangle) {
  const glm::uvec3 index = scene.triangles[triangle];
  const auto &p = scene.positions_world, &n = scene.normals_world;
  SeenTriangle t = see_corners({p[index.x], p[index.y], p[index.z]});
  if (!n.empty()) shade_smoothly(t, {n[index.x], n[index.y], n[index.z]});
  return t;
}

double size_of(const glm::dmat3& m) {
  return std::sqrt(glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]));
}

/// Embree moves rays into the mesh's space, in floats: their origins are off by roundings of where they and the mesh stand, and
/// the triangle is as thin as it is there.
SeenTriangle see_triangle(const Instance& instance, uint32_t triangle) {
  constexpr double kRoundoffs = 8.0;
  const glm::mat4x3& m = *instance.world_from_mesh;
  const InstancedMesh& mesh = *instance.mesh;
  const glm::uvec3 index = mesh.triangles[triangle];
  SeenTriangle t = see_corners(instance.corners_world(triangle));
  const glm::dmat3 linear(m[0], m[1], m[2]);
  const double stretch = size_of(linear) * size_of(glm::inverse(linear));
  const glm::dvec3 a(mesh.positions[index.x]), ab = glm::dvec3(mesh.positions[index.y]) - a,
                                               ac = glm::dvec3(mesh.positions[index.z]) - a;
  t.needed_per_reach = stretch * needed_per_reach(ab, ac, glm::length(glm::cross(ab, ac)));
  const double farthest = std::max({glm::length(t.a), glm::length(t.b), glm::length(t.c)});
  t.needed_always = kRoundoffs * 0x1p-24 * stretch * (farthest + glm::length(glm::dvec3(m[3])));
  if (!mesh.normals.empty())
    shade_smoothly(t, {instance.n_world(index.x), instance.n_world(index.y), instance.n_world(index.z)});
  return t;
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

glm::dvec3 shading_normal(const SeenTriangle& t, const glm::dvec3& p, const glm::dvec3& n_geometric) {
  if (t.is_flat) return n_geometric;
  const double b = glm::dot(p - t.a, t.per_weight_b), c = glm::dot(p - t.a, t.per_weight_c);
  const glm::dvec3 sum = (1.0 - b - c) * t.normal_a + b * t.normal_b + c * t.normal_c;
  const double length = glm::length(sum);
  if (!(length > 0.0)) return n_geometric;
  const glm::dvec3 n = sum / length;
  return glm::dot(n, n_geometric) < 0.0 ? -n : n;
}

/// Definition at PrimaryHit::receiver.
glm::vec3 shadow_ray_origin(const SeenTriangle& t, const glm::dvec3& p_world, const glm::dvec3& n_world,
                            const glm::dvec3& to_light_world) {
  const glm::dvec3 from_a = p_world - t.a, from_b = p_world - t.b, from_c = p_world - t.c;
  const double reach2 =
      std::max({glm::dot(from_a, from_a), glm::dot(from_b, from_b), glm::dot(from_c, from_c)});
  const double needed = t.needed_per_reach * std::sqrt(reach2) + t.needed_always;

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

/// The rays of a block: where they go in double precision, and as Embree's packet.
struct Rays {
  std::array<glm::dvec3, kRays> d_world;  // unit
  alignas(64) std::array<int32_t, kRays> valid{};
  RTCRayHit16 packet{};
};

void set_ray(Rays& rays, uint32_t i, const glm::dvec3& eye_world, const glm::dvec3& way_world,
             double near_world) {
  const double length = glm::length(way_world);
  rays.d_world[i] = way_world / length;
  RTCRay16& ray = rays.packet.ray;
  rays.valid[i] = -1;
  ray.org_x[i] = static_cast<float>(eye_world.x);
  ray.org_y[i] = static_cast<float>(eye_world.y);
  ray.org_z[i] = static_cast<float>(eye_world.z);
  ray.dir_x[i] = static_cast<float>(rays.d_world[i].x);
  ray.dir_y[i] = static_cast<float>(rays.d_world[i].y);
  ray.dir_z[i] = static_cast<float>(rays.d_world[i].z);
  ray.tnear[i] = static_cast<float>(near_world * length);
  ray.tfar[i] = std::numeric_limits<float>::infinity();
  ray.mask[i] = ~0u;
}

}  // namespace

PrimaryCamera::PrimaryCamera(const Scene& scene, int width_px, int height_px)
    : scene_(scene), instances_(list_instances(scene)), width_px_(width_px), height_px_(height_px) {
  const glm::dvec3 forward_world = glm::normalize(scene.camera.at_world - scene.camera.eye_world);
  const auto way = [&](const glm::dvec2& p_px) {
    const glm::dvec3 d_world = camera_ray_direction_world(scene.camera, p_px, width_px, height_px);
    return d_world / glm::dot(d_world, forward_world);
  };
  corner_world_ = way({0, 0});
  per_x_world_ = (way({width_px, 0}) - corner_world_) / static_cast<double>(width_px);
  per_y_world_ = (way({0, height_px}) - corner_world_) / static_cast<double>(height_px);
}

PrimaryBlock PrimaryCamera::hits(const EmbreeScene& embree, int x0, int y0) const {
  const Camera& camera = scene_.camera;
  Rays rays;
  std::fill_n(rays.packet.hit.geomID, kRays, RTC_INVALID_GEOMETRY_ID);
  std::fill_n(rays.packet.hit.instID[0], kRays, RTC_INVALID_GEOMETRY_ID);
  for (uint32_t i = 0; i < kRays; ++i) {
    const int x = x0 + static_cast<int>(i % kBlock), y = y0 + static_cast<int>(i / kBlock);
    if (x >= width_px_ || y >= height_px_) continue;
    set_ray(rays, i, camera.eye_world, corner_world_ + (x + 0.5) * per_x_world_ + (y + 0.5) * per_y_world_,
            camera.near_world);
  }
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = embree.primary_flags();
  rtcIntersect16(rays.valid.data(), embree.handle(), &context, &rays.packet);

  PrimaryBlock block;
  uint32_t seen = RTC_INVALID_GEOMETRY_ID;  // shown number
  SeenTriangle t;
  for (uint32_t i = 0; i < kRays; ++i) {
    if (rays.packet.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
    const uint32_t primitive = rays.packet.hit.primID[i], instance_id = rays.packet.hit.instID[0][i];
    const Instance* instance =
        instance_id == RTC_INVALID_GEOMETRY_ID ? nullptr : &instances_[instance_id - 1];
    const uint32_t shown = instance == nullptr ? primitive : instance->first_shown + primitive;
    if (shown != seen)
      t = instance == nullptr ? see_triangle(scene_, primitive) : see_triangle(*instance, primitive);
    seen = shown;
    PrimaryHit& hit = block[i].emplace();
    hit.primitive = shown_id(shown);
    Receiver& receiver = hit.receiver;
    receiver.n_geometric_world = glm::dot(t.n_world, rays.d_world[i]) > 0.0 ? -t.n_world : t.n_world;
    receiver.p_world = point_on_plane(camera.eye_world, rays.d_world[i], receiver.n_geometric_world, t.a,
                                      static_cast<double>(rays.packet.ray.tfar[i]));
    receiver.n_shading_world = shading_normal(t, receiver.p_world, receiver.n_geometric_world);
    receiver.ray_origin_world = shadow_ray_origin(t, receiver.p_world, receiver.n_geometric_world,
                                                  to_light_center(scene_.light(), receiver.p_world));
  }
  return block;
}

}  // namespace umbrameter
