// SPDX-License-Identifier: Apache-2.0
#include "study/engine_surfaces.h"

#include "core/error.h"

#include <fmt/format.h>

#include <glm/geometric.hpp>

#include <array>
#include <cmath>

namespace umbrameter {
namespace {

constexpr std::array kPosition = {"position.x", "position.y", "position.z"};
constexpr std::array kNormal = {"normal.x", "normal.y", "normal.z"};
constexpr int kMostShift_px = 2;
/// A reading must leave less than this share of the error to be named.
constexpr double kFarBetter = 0.5;

template <size_t N>
bool has_all(const Image& image, const std::array<const char*, N>& names) {
  for (const char* name : names) {
    if (!image.has(name)) return false;
  }
  return true;
}

void copy(const Image& from, const char* channel, Image& to) {
  const std::span<const float> source = from.plane(channel);
  to.planes[channel].assign(source.begin(), source.end());
}

std::string depth_channel(const Image& aovs) {
  for (const char* name : {"depth", "Z", "depth.Z"}) {
    if (aovs.has(name)) return name;
  }
  return {};
}

/// Nothing is hit where depth is not a positive number.
void positions_from_depth(const Image& aovs, const std::string& channel, const Camera& camera, DepthKind kind,
                          Image& test) {
  const std::span<const float> depth = aovs.plane(channel);
  for (const char* name : kPosition) test.add_plane(name);
  const glm::dvec3 forward = glm::normalize(camera.at_world - camera.eye_world);
  for (size_t i = 0; i < depth.size(); ++i) {
    const double z = depth[i];
    const glm::dvec2 p_px = {static_cast<double>(i % static_cast<size_t>(test.width)) + 0.5,
                             static_cast<double>(i / static_cast<size_t>(test.width)) + 0.5};
    const glm::dvec3 d_world = camera_ray_direction_world(camera, p_px, test.width, test.height);
    const double t = kind == DepthKind::ray ? z : z / glm::dot(d_world, forward);
    const glm::dvec3 p_world = camera.eye_world + (std::isfinite(t) ? t : 0.0) * d_world;
    for (int axis = 0; axis < 3; ++axis)
      test.plane(kPosition[static_cast<size_t>(axis)])[i] = static_cast<float>(p_world[axis]);
  }
}

/// -1 where `depth` says that nothing is hit. Other identifiers than the reference's, so that places must agree.
void invent_primitives(const Image& reference, const Image& aovs, const std::string& depth, Image& test) {
  const std::span<const float> theirs = reference.plane("primitive_id");
  const std::span<float> ours = test.add_plane("primitive_id");
  for (size_t i = 0; i < ours.size(); ++i) {
    const bool is_hit = depth.empty() ? theirs[i] >= 0.0f
                                      : std::isfinite(aovs.plane(depth)[i]) && aovs.plane(depth)[i] > 0.0f;
    ours[i] = is_hit ? std::max(theirs[i], 0.0f) + 1.0f : -1.0f;
  }
}

struct Reading {
  bool is_upside_down = false, is_mirrored = false;
  int dx = 0, dy = 0;
};

double mean_square(const Image& test, const Image& reference, const Reading& reading) {
  const std::span<const float> v = test.plane("visibility"), r = reference.plane("visibility");
  const std::span<const float> primitive = reference.plane("primitive_id");
  double sum = 0.0, count = 0.0;
  const int m = kMostShift_px;
  for (int y = m; y < test.height - m; ++y) {
    for (int x = m; x < test.width - m; ++x) {
      const auto i = static_cast<size_t>(y) * static_cast<size_t>(test.width) + static_cast<size_t>(x);
      if (primitive[i] < 0.0f) continue;
      const int sy = (reading.is_upside_down ? test.height - 1 - y : y) + reading.dy;
      const int sx = (reading.is_mirrored ? test.width - 1 - x : x) + reading.dx;
      const double d = static_cast<double>(
          v[static_cast<size_t>(sy) * static_cast<size_t>(test.width) + static_cast<size_t>(sx)] - r[i]);
      sum += d * d;
      count += 1.0;
    }
  }
  return count == 0.0 ? 0.0 : sum / count;
}

std::string name_of_reading(const Reading& reading) {
  if (reading.is_upside_down && reading.is_mirrored) return "turned by 180 degrees";
  if (reading.is_upside_down) return "upside down";
  if (reading.is_mirrored) return "mirrored";
  return fmt::format("{} px to the {} and {} px {}", std::abs(reading.dx), reading.dx > 0 ? "left" : "right",
                     std::abs(reading.dy), reading.dy > 0 ? "up" : "down");
}

std::vector<Reading> all_readings() {
  std::vector<Reading> all = {{true, false, 0, 0}, {false, true, 0, 0}, {true, true, 0, 0}};
  for (int dy = -kMostShift_px; dy <= kMostShift_px; ++dy) {
    for (int dx = -kMostShift_px; dx <= kMostShift_px; ++dx) {
      if (dx != 0 || dy != 0) all.push_back({false, false, dx, dy});
    }
  }
  return all;
}

}  // namespace

std::vector<std::string> add_surfaces(const Image& aovs, const Camera* camera, DepthKind depth_kind,
                                      const Image& reference, Image& test) {
  std::vector<std::string> unknown;
  require_same_size(test, reference, "score");
  if (!aovs.planes.empty()) require_same_size(aovs, reference, "surface channels");
  const std::string depth = depth_channel(aovs);
  if (has_all(aovs, kPosition)) {
    for (const char* name : kPosition) copy(aovs, name, test);
  } else if (!depth.empty()) {
    if (camera == nullptr)
      fail_input("a depth channel needs the camera to say where points are", {}, "give --scene");
    positions_from_depth(aovs, depth, *camera, depth_kind, test);
  } else {
    for (const char* name : kPosition) copy(reference, name, test);
    unknown.push_back(
        "no position or depth: not known whether the picture shows the same places (camera, pixel "
        "centres, geometry)");
  }
  const bool has_place = unknown.empty();
  if (has_all(aovs, kNormal)) {
    for (const char* name : kNormal) copy(aovs, name, test);
  } else {
    for (const char* name : kNormal) copy(reference, name, test);
    unknown.push_back("no normal: not known whether surfaces face the same way");
  }
  if (aovs.has("primitive_id")) {
    copy(aovs, "primitive_id", test);
  } else if (has_place) {
    invent_primitives(reference, aovs, has_all(aovs, kPosition) ? "" : depth, test);
    unknown.push_back("no primitive_id: surfaces are told apart by place and normal alone");
  } else {
    copy(reference, "primitive_id", test);
    unknown.push_back("no primitive_id: not known where the picture shows nothing");
  }
  if (aovs.has("unshadowed_irradiance")) {
    copy(aovs, "unshadowed_irradiance", test);
  } else {
    copy(reference, "unshadowed_irradiance", test);
    unknown.push_back("no unshadowed_irradiance: not known whether the light is the same");
  }
  return unknown;
}

std::optional<std::string> better_alignment(const Image& test, const Image& reference) {
  const double as_it_stands = mean_square(test, reference, {});
  double best = kFarBetter * as_it_stands;
  std::optional<std::string> name;
  for (const Reading& reading : all_readings()) {
    const double error = mean_square(test, reference, reading);
    if (error >= best) continue;
    best = error;
    name = name_of_reading(reading);
  }
  return name;
}

}  // namespace umbrameter
