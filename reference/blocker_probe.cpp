#include "reference/blocker_probe.h"

#include "reference/reference.h"

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

}  // namespace

BlockerStatistics probe_blockers(const EmbreeScene& embree, const glm::vec3& origin_world,
                                 const LightPatch& patch, const SampleSets& sets, uint32_t seed) {
  ShadowRayBatch batch(origin_world);
  const uint32_t probes = std::min(kProbes, sets.points());
  make_shadow_rays(patch, sets.stream(seed, kReplicates), 0, probes, batch);
  CollectingContext context;
  rtcInitIntersectContext(&context.embree);
  context.embree.filter = collect_crossing;

  BlockerStatistics sum;
  double nearest = std::numeric_limits<double>::infinity();
  int blocked = 0;
  for (uint32_t i = 0; i < probes; ++i) {
    if (batch.is_facing[i] == 0) continue;
    RTCRay ray = ray_of_lane(batch.rays, i);
    context.crossings.clear();
    rtcOccluded1(embree.handle(), &context.embree, &ray);
    merge_crossings(context.crossings);
    if (context.crossings.empty()) continue;
    const double length = std::hypot(ray.dir_x, ray.dir_y, ray.dir_z);
    const double distance = static_cast<double>(context.crossings.front().fraction) * length;
    nearest = std::min(nearest, distance);
    sum.distance_mean_world += distance;
    sum.layers_mean += static_cast<double>(count_layers(context.crossings));
    ++blocked;
  }
  if (blocked == 0) return {};
  return {sum.distance_mean_world / blocked, nearest, sum.layers_mean / blocked};
}

}  // namespace umbrameter
