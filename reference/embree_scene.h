// SPDX-License-Identifier: Apache-2.0
#pragma once
// Embree's device and acceleration structure as one owned thing. Not here: what the rays mean.

#include "scenes/scene.h"

#include <embree3/rtcore.h>

#include <atomic>
#include <cstdint>
#include <list>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace umbrameter {

template <auto Release>
struct EmbreeRelease {
  template <class Handle>
  void operator()(Handle* handle) const {
    Release(handle);
  }
};
using EmbreeDeviceHandle = std::unique_ptr<std::remove_pointer_t<RTCDevice>, EmbreeRelease<rtcReleaseDevice>>;
using EmbreeSceneHandle = std::unique_ptr<std::remove_pointer_t<RTCScene>, EmbreeRelease<rtcReleaseScene>>;

/// What Embree's filter needs to know of triangles with holes.
struct HoleGeometry {
  uint32_t first_cutout = 0;
  SharedList<Cutout> cutouts;
  SharedList<AlphaMask> masks;
};

/// One merged, robustly traversed triangle geometry, whose primID is the scene's triangle index, and one scene for each mesh
/// that stands in several places, whose primID is the mesh's; instID is 1 + the index in list_instances().
/// Rays pass through holes. Owns copies of what it needs, so the Scene may go away.
class EmbreeScene {
 public:
  /// Error{environment} when Embree cannot start.
  EmbreeScene();

  /// Makes `scene` the one that rays meet; does nothing, and says false, when its triangles are those it holds
  /// already. Builds with the threads of the caller's TBB arena. Error{environment} when memory runs out, Error{internal} for
  /// any other Embree error.
  bool load(const Scene& scene);

  RTCDevice device() const { return device_.get(); }
  RTCScene handle() const { return scene_.get(); }
  /// Lanes of the widest shadow-ray packet the device runs natively: 16, 8 or 4.
  int packet_width() const { return packet_width_; }
  /// How packets of rays from one origin are traced fastest.
  RTCIntersectContextFlags packet_flags() const { return packet_flags_; }
  /// And packets of the camera's rays.
  RTCIntersectContextFlags primary_flags() const { return primary_flags_; }
  uint64_t memory_bytes() const { return static_cast<uint64_t>(memory_bytes_.load()); }
  std::string version() const;

 private:
  void throw_on_error(const char* doing) const;
  EmbreeSceneHandle new_scene() const;
  void add_instances(const Scene& scene);

  std::atomic<int64_t> memory_bytes_{0};
  EmbreeDeviceHandle device_;  // before scene_: released after it
  EmbreeSceneHandle scene_;
  std::vector<EmbreeSceneHandle> meshes_;  // of instances
  std::string loaded_hash_;
  std::list<HoleGeometry> holes_;  // what the filter looks up: stays where it is
  int packet_width_ = 4;
  RTCIntersectContextFlags packet_flags_ = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  RTCIntersectContextFlags primary_flags_ = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
};

}  // namespace umbrameter
