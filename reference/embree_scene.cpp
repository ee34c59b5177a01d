// SPDX-License-Identifier: Apache-2.0
#include "reference/embree_scene.h"

#include "core/error.h"
#include "core/hash.h"
#include "scenes/instances.h"
#include "scenes/scene_hash.h"

#include <cstring>

namespace umbrameter {

namespace {

std::string hash_of_triangles(const Scene& scene) {
  Hasher hasher;
  hasher.values(std::span(scene.positions_world))
      .values(std::span(scene.triangles))
      .number(static_cast<double>(scene.positions_world.size()));
  hash_cutouts(hasher, scene);
  hash_instances(hasher, scene);
  return hasher.hex();
}

/// Refuses hits in holes, of any kind of ray and packet.
void refuse_holes(const RTCFilterFunctionNArguments* arguments) {
  const auto& holes = *static_cast<const HoleGeometry*>(arguments->geometryUserPtr);
  RTCHitN* hit = arguments->hit;
  const uint32_t n = arguments->N;
  for (uint32_t i = 0; i < n; ++i) {
    const uint32_t primitive = RTCHitN_primID(hit, n, i);
    if (arguments->valid[i] != -1 || primitive < holes.first_cutout) continue;
    const Cutout& cutout = holes.cutouts[primitive - holes.first_cutout];
    const glm::vec2 uv = uv_at(cutout, RTCHitN_u(hit, n, i), RTCHitN_v(hit, n, i));
    if (is_hole(holes.masks[cutout.mask], uv)) arguments->valid[i] = 0;
  }
}

bool count_memory(void* total, ssize_t bytes, bool) {
  static_cast<std::atomic<int64_t>*>(total)->fetch_add(bytes, std::memory_order_relaxed);
  return true;
}

template <class T>
void copy_buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, const SharedList<T>& items) {
  void* to = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(T), items.size());
  if (to != nullptr && !items.empty()) std::memcpy(to, items.data(), items.size() * sizeof(T));
}

/// Id 0 of `scene`.
void attach_triangles(RTCDevice device, RTCScene scene, const SharedList<glm::vec3>& positions,
                      const SharedList<glm::uvec3>& triangles, HoleGeometry holes,
                      std::list<HoleGeometry>& kept) {
  if (triangles.empty()) return;
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  copy_buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, positions);
  copy_buffer(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, triangles);
  if (!holes.cutouts.empty()) {
    rtcSetGeometryUserData(geometry, &kept.emplace_back(std::move(holes)));
    rtcSetGeometryIntersectFilterFunction(geometry, refuse_holes);
    rtcSetGeometryOccludedFilterFunction(geometry, refuse_holes);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, 0);
  rtcReleaseGeometry(geometry);
}

int widest_packet(RTCDevice device) {
  if (rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED) != 0) return 16;
  if (rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED) != 0) return 8;
  return 4;
}

}  // namespace

EmbreeScene::EmbreeScene() {
  // No thread limit here: Embree would impose it on every user of TBB in the process.
  device_.reset(rtcNewDevice(nullptr));
  if (!device_) {
    fail_environment(fmt::format("Embree could not start a device (error {})",
                                 static_cast<int>(rtcGetDeviceError(nullptr))),
                     "it needs an x86-64 processor with SSE2");
  }
  rtcSetDeviceMemoryMonitorFunction(device_.get(), count_memory, &memory_bytes_);
  packet_width_ = widest_packet(device_.get());
}

bool EmbreeScene::load(const Scene& scene) {
  const std::string hash = hash_of_triangles(scene);
  if (scene_ && hash == loaded_hash_) return false;
  scene_ = new_scene();
  meshes_.clear();
  holes_.clear();
  // Following a packet's frustum saves a third to a half of the time on bunny and Sponza; in a tree of a few leaves it
  // costs a third. With instances Embree 3.13.5 does not come back from it.
  constexpr size_t kFewTriangles = 256;
  const bool has_instances = !scene.instanced.empty();
  packet_flags_ = has_instances || scene.triangles.size() < kFewTriangles
                      ? RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT
                      : RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  primary_flags_ =
      has_instances ? RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT : RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  loaded_hash_.clear();
  attach_triangles(device_.get(), scene_.get(), scene.positions_world, scene.triangles,
                   {scene.first_cutout(), scene.cutouts, scene.masks}, holes_);
  add_instances(scene);
  rtcJoinCommitScene(scene_.get());
  throw_on_error("building the acceleration structure");
  loaded_hash_ = hash;
  return true;
}

EmbreeSceneHandle EmbreeScene::new_scene() const {
  EmbreeSceneHandle scene(rtcNewScene(device_.get()));
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
  rtcSetSceneBuildQuality(scene.get(), RTC_BUILD_QUALITY_HIGH);
  return scene;
}

void EmbreeScene::add_instances(const Scene& scene) {
  unsigned int id = 0;
  for (const auto& mesh : scene.instanced) {
    meshes_.push_back(new_scene());
    RTCScene own = meshes_.back().get();
    attach_triangles(device_.get(), own, mesh->positions, mesh->triangles,
                     {mesh->first_cutout(), mesh->cutouts, mesh->masks}, holes_);
    rtcJoinCommitScene(own);
    for (const glm::mat4x3& place : mesh->world_from_mesh) {
      RTCGeometry instance = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_INSTANCE);
      rtcSetGeometryInstancedScene(instance, own);
      rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, &place);
      rtcCommitGeometry(instance);
      rtcAttachGeometryByID(scene_.get(), instance, ++id);
      rtcReleaseGeometry(instance);
    }
  }
}

std::string EmbreeScene::version() const {
  const auto number = rtcGetDeviceProperty(device_.get(), RTC_DEVICE_PROPERTY_VERSION);
  return fmt::format("{}.{}.{}", number / 10000, number / 100 % 100, number % 100);
}

void EmbreeScene::throw_on_error(const char* doing) const {
  const RTCError error = rtcGetDeviceError(device_.get());
  if (error == RTC_ERROR_NONE) return;
  if (error == RTC_ERROR_OUT_OF_MEMORY) fail_environment(fmt::format("out of memory while {}", doing));
  throw Error(ErrorKind::internal, fmt::format("Embree error {} while {}", static_cast<int>(error), doing));
}

}  // namespace umbrameter
