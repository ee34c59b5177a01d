// SPDX-License-Identifier: Apache-2.0
#include "realtime/executor/receivers.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace umbrameter {
namespace {

/// Read access to the receivers of a G-buffer image.
struct Receivers {
  std::span<const float> x, y, z, id, irradiance;

  explicit Receivers(const Image& image)
      : x(image.plane("position.x")),
        y(image.plane("position.y")),
        z(image.plane("position.z")),
        id(image.plane("primitive_id")),
        irradiance(image.plane("unshadowed_irradiance")) {}
  bool is_receiver(size_t pixel) const { return id[pixel] >= 0.0f && irradiance[pixel] > 0.0f; }
  glm::vec3 p_world(size_t pixel) const { return {x[pixel], y[pixel], z[pixel]}; }
};

/// Of those receivers that `takes` accepts.
template <class Predicate>
std::vector<ReceiverTile> tiles_of_receivers(const Image& gbuffer, const Predicate& takes) {
  const Receivers receivers(gbuffer);
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const auto tiles_of = [](int px) {
    return static_cast<size_t>((px + kReceiverTilePx - 1) / kReceiverTilePx);
  };
  const size_t columns = tiles_of(gbuffer.width);
  std::vector<ReceiverTile> tiles(columns * tiles_of(gbuffer.height),
                                  ReceiverTile{glm::vec3(kInfinity), glm::vec3(-kInfinity)});
  const auto width = static_cast<size_t>(gbuffer.width);
  for (size_t pixel = 0; pixel < gbuffer.pixel_count(); ++pixel) {
    if (!receivers.is_receiver(pixel) || !takes(receivers.p_world(pixel))) continue;
    ReceiverTile& tile = tiles[pixel / width / kReceiverTilePx * columns + pixel % width / kReceiverTilePx];
    tile.min_world = glm::min(tile.min_world, receivers.p_world(pixel));
    tile.max_world = glm::max(tile.max_world, receivers.p_world(pixel));
  }
  std::erase_if(tiles, [](const ReceiverTile& tile) { return tile.min_world.x > tile.max_world.x; });
  return tiles;
}

}  // namespace

std::vector<ReceiverTile> receiver_tiles(const Image& gbuffer) {
  return tiles_of_receivers(gbuffer, [](const glm::vec3&) { return true; });
}

std::vector<ReceiverTile> receiver_tiles(const Image& gbuffer, const Camera& camera,
                                         const CameraSlice& slice) {
  const glm::dvec4 axis = camera_axis(camera);
  return tiles_of_receivers(gbuffer, [&](const glm::vec3& p_world) {
    const double along_axis = glm::dot(axis, glm::dvec4(p_world, 1.0));
    return along_axis >= slice.near_world && along_axis <= slice.far_world;
  });
}

DistanceRange receiver_range(const Image& gbuffer, const Camera& camera) {
  const Receivers receivers(gbuffer);
  const glm::dvec4 axis = camera_axis(camera);
  DistanceRange range{std::numeric_limits<double>::infinity(), 0.0};
  for (size_t pixel = 0; pixel < gbuffer.pixel_count(); ++pixel) {
    if (!receivers.is_receiver(pixel)) continue;
    const double along_axis = glm::dot(axis, glm::dvec4(receivers.p_world(pixel), 1.0));
    range = {std::min(range.near_world, along_axis), std::max(range.far_world, along_axis)};
  }
  if (range.near_world > range.far_world) return {camera.near_world, 2.0 * camera.near_world};
  return {std::max(range.near_world, camera.near_world), std::max(range.far_world, camera.near_world)};
}

double share_outside(const Image& gbuffer, std::span<const LightView> views) {
  const Receivers receivers(gbuffer);
  size_t count = 0;
  size_t outside = 0;
  for (size_t pixel = 0; pixel < gbuffer.pixel_count(); ++pixel) {
    if (!receivers.is_receiver(pixel)) continue;
    ++count;
    const glm::dvec3 p_world(receivers.p_world(pixel));
    if (std::ranges::none_of(views, [&](const LightView& view) { return covers(view, p_world); })) ++outside;
  }
  return count == 0 ? 0.0 : static_cast<double>(outside) / static_cast<double>(count);
}

glm::dvec4 receiver_plane(const Image& gbuffer) {
  constexpr double kNormalStep = 1e-3;
  constexpr double kOffsetShare = 1e-4;  // of the receivers' largest coordinate
  const Receivers receivers(gbuffer);
  const auto nx = gbuffer.plane("normal.x");
  const auto ny = gbuffer.plane("normal.y");
  const auto nz = gbuffer.plane("normal.z");
  double scale = 0.0;
  for (size_t pixel = 0; pixel < gbuffer.pixel_count(); ++pixel) {
    if (!receivers.is_receiver(pixel)) continue;
    for (const float value : {receivers.x[pixel], receivers.y[pixel], receivers.z[pixel]})
      scale = std::max(scale, std::abs(static_cast<double>(value)));
  }
  struct Votes {
    size_t count = 0;
    glm::dvec4 sum{0.0};
  };
  std::map<std::array<int64_t, 4>, Votes> planes;
  Votes* last = nullptr;  // neighbours mostly show one triangle: most pixels need no search
  float last_id = -1.0f;
  for (size_t pixel = 0; pixel < gbuffer.pixel_count(); ++pixel) {
    if (!receivers.is_receiver(pixel)) continue;
    const glm::dvec3 n(nx[pixel], ny[pixel], nz[pixel]);
    const double offset = -glm::dot(n, glm::dvec3(receivers.p_world(pixel)));
    const auto cell = [](double value, double step) {
      return static_cast<int64_t>(std::llround(value / step));
    };
    if (last == nullptr || receivers.id[pixel] != last_id) {
      last = &planes[{cell(n.x, kNormalStep), cell(n.y, kNormalStep), cell(n.z, kNormalStep),
                      cell(offset, kOffsetShare * std::max(scale, 1e-30))}];
      last_id = receivers.id[pixel];
    }
    last->count += 1;
    last->sum += glm::dvec4(n, offset);
  }
  if (planes.empty()) return {0, 1, 0, 0};
  const auto most =
      std::ranges::max_element(planes, {}, [](const auto& entry) { return entry.second.count; });
  const glm::dvec4 mean = most->second.sum / static_cast<double>(most->second.count);
  return mean / glm::length(glm::dvec3(mean));
}

}  // namespace umbrameter
