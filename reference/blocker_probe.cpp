// SPDX-License-Identifier: Apache-2.0
#include "reference/blocker_probe.h"

#include "reference/reference.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace umbrameter {

namespace {

/// A surface on the way to the light.
struct Crossing {
  float fraction = 0.0f;  // of the way
  int facing = 0;         // +1 its winding's normal points along the ray, -1 against it
};

/// Embree hands the context to the filter, which finds its list behind it.
struct CollectingContext {
  RTCIntersectContext embree;  // first: Embree's pointer is ours
  std::vector<Crossing> crossings;
};

/// Notes the hit and refuses it, so that the ray goes on.
void collect_crossing(const RTCFilterFunctionNArguments* arguments) {
  if (arguments->valid[0] == 0) return;
  auto* context = reinterpret_cast<CollectingContext*>(arguments->context);
  RTCRayN* ray = arguments->ray;
  RTCHitN* hit = arguments->hit;
  const uint32_t n = arguments->N;
  const float along = RTCRayN_dir_x(ray, n, 0) * RTCHitN_Ng_x(hit, n, 0) +
                      RTCRayN_dir_y(ray, n, 0) * RTCHitN_Ng_y(hit, n, 0) +
                      RTCRayN_dir_z(ray, n, 0) * RTCHitN_Ng_z(hit, n, 0);
  context->crossings.push_back({RTCRayN_tfar(ray, n, 0), along < 0.0f ? -1 : 1});
  arguments->valid[0] = 0;
}

RTCRay ray_of_lane(const RTCRay16& rays, uint32_t lane) {
  RTCRay ray{};
  ray.org_x = rays.org_x[lane];
  ray.org_y = rays.org_y[lane];
  ray.org_z = rays.org_z[lane];
  ray.dir_x = rays.dir_x[lane];
  ray.dir_y = rays.dir_y[lane];
  ray.dir_z = rays.dir_z[lane];
  ray.tfar = rays.tfar[lane];
  ray.mask = rays.mask[lane];
  return ray;
}

/// Sorts crossings, nearest first, and merges those that are one: an edge belongs to two triangles, and the
/// tree may hold a triangle in several leaves.
void merge_crossings(std::vector<Crossing>& crossings) {
  constexpr float kSame = 1e-6f;
  std::ranges::sort(crossings, {}, [](const Crossing& c) { return std::pair(c.fraction, c.facing); });
  const auto is_same = [](const Crossing& nearer, const Crossing& farther) {
    return farther.fraction - nearer.fraction <= kSame * farther.fraction;
  };
  crossings.erase(std::unique(crossings.begin(), crossings.end(), is_same), crossings.end());
}

/// A solid has as many surfaces wound towards the light as away from it, whichever way it is wound; a sheet
/// has one.
int64_t count_layers(std::span<const Crossing> crossings) {
  const int64_t towards = std::ranges::count(crossings, 1, &Crossing::facing);
  return std::max(towards, static_cast<int64_t>(crossings.size()) - towards);
}

/// How wide the light is, over its distance when it is the sun.
double width_of(const Light& light) {
  switch (light.type) {
    case LightType::rect:
      return std::sqrt(light.size_world.x * light.size_world.y);
    case LightType::disk:
    case LightType::sphere:
      return 2.0 * light.radius_world;
    case LightType::sun:
      break;
  }
  return 2.0 * std::tan(light.half_angle_rad);
}

/// By similar triangles: the light's width, seen through a point at `fraction` of the way.
double penumbra_width(const Light& light, double fraction, double length) {
  const double spread = light.type == LightType::sun ? fraction * length : fraction / (1.0 - fraction);
  return width_of(light) * spread;
}

/// What one blocked probe met first.
struct Blocker {
  double distance_world = 0.0;
  double height_world = 0.0;  // over the receiver's plane
  double penumbra_width_world = 0.0;
  int64_t layers = 0;
  glm::dvec3 offset_world{0.0};  // from the receiver
};

BlockerStatistics statistics_of(std::vector<Blocker>& blockers) {
  if (blockers.empty()) return {};
  std::ranges::sort(blockers, {}, &Blocker::distance_world);
  const auto n = static_cast<double>(blockers.size());
  BlockerStatistics sum;
  sum.distance_min_world = blockers.front().distance_world;
  sum.distance_p10_world = blockers[static_cast<size_t>(std::ceil(0.1 * n)) - 1].distance_world;
  sum.contact_distance_world = std::numeric_limits<double>::infinity();
  for (const Blocker& blocker : blockers) {
    sum.distance_mean_world += blocker.distance_world / n;
    sum.layers_mean += static_cast<double>(blocker.layers) / n;
    sum.penumbra_width_world += blocker.penumbra_width_world / n;
    sum.offset_mean_world += blocker.offset_world / n;
    sum.contact_distance_world = std::min(sum.contact_distance_world, blocker.height_world);
  }
  return sum;
}

}  // namespace

BlockerStatistics probe_blockers(const ProbeJob& job, const SampleSets& sets, uint32_t seed) {
  ShadowRayBatch batch(job.origin_world);
  const uint32_t probes = std::min(kProbes, sets.points());
  make_shadow_rays(job.patch, sets.stream(seed, kReplicates), 0, probes, batch);
  CollectingContext context;
  rtcInitIntersectContext(&context.embree);
  context.embree.filter = collect_crossing;

  std::vector<Blocker> blockers;
  blockers.reserve(probes);
  for (uint32_t i = 0; i < probes; ++i) {
    if (batch.is_facing[i] == 0) continue;
    RTCRay ray = ray_of_lane(batch.rays, i);
    context.crossings.clear();
    rtcOccluded1(job.embree.handle(), &context.embree, &ray);
    merge_crossings(context.crossings);
    if (context.crossings.empty()) continue;
    const auto fraction = static_cast<double>(context.crossings.front().fraction);
    const glm::dvec3 way{ray.dir_x, ray.dir_y, ray.dir_z};
    const double length = glm::length(way);
    blockers.push_back({fraction * length, fraction * glm::dot(way, glm::dvec3(job.n_geometric_world)),
                        penumbra_width(job.light, fraction, length), count_layers(context.crossings),
                        fraction * way});
  }
  return statistics_of(blockers);
}

}  // namespace umbrameter
