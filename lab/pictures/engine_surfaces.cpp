// SPDX-License-Identifier: Apache-2.0
#include "lab/pictures/engine_surfaces.h"

#include "core/error.h"
#include "lab/pictures/surface_readings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace umbrameter {
namespace {

constexpr std::array kPosition = {"position.x", "position.y", "position.z"};
constexpr std::array kNormal = {"normal.x", "normal.y", "normal.z"};
/// A place this far from the origin is a mark for "nothing": renderers write 1e10, 1e30 or infinity.
constexpr double kNowhere = 1e9;
/// Farther than the truth's farthest surface by this share: the far plane, 65504, 1e10, or a sky.
constexpr double kBeyond = 1.01;

template <size_t N>
bool has_all(const Image& image, const std::array<const char*, N>& names) {
  return std::ranges::all_of(names, [&](const char* name) { return image.has(name); });
}

void copy(const Image& from, const char* channel, Image& to) {
  const std::span<const float> source = from.plane(channel);
  to.planes[channel].assign(source.begin(), source.end());
}

glm::dvec3 vector_at(const Image& image, const std::array<const char*, 3>& names, size_t i) {
  return {image.plane(names[0])[i], image.plane(names[1])[i], image.plane(names[2])[i]};
}

bool is_somewhere(const glm::dvec3& p) {
  return std::abs(p.x) < kNowhere && std::abs(p.y) < kNowhere && std::abs(p.z) < kNowhere;
}

/// What the engine says of every pixel, in our space.
struct Given {
  std::vector<glm::dvec3> p_world, n_world;  // empty: not given
  std::vector<uint8_t> is_hit;               // empty: not given
};

std::vector<glm::dvec3> vectors(const Image& image, const std::array<const char*, 3>& names,
                                const SurfaceSpace& space, double unit) {
  std::array<std::span<const float>, 3> planes;
  for (size_t k = 0; k < 3; ++k) planes[k] = image.plane(names[static_cast<size_t>(space.axis[k])]);
  std::vector<glm::dvec3> out(image.pixel_count());
  for (size_t i = 0; i < out.size(); ++i) {
    for (size_t k = 0; k < 3; ++k)
      out[i][static_cast<int>(k)] = unit * space.sign[k] * static_cast<double>(planes[k][i]);
  }
  return out;
}

double farthest_depth(const Image& reference, const Camera& camera, DepthKind kind) {
  double farthest = 0.0;
  const auto primitive = reference.plane("primitive_id");
  for (size_t i = 0; i < primitive.size(); ++i) {
    if (primitive[i] >= 0.0f)
      farthest = std::max(farthest, depth_of(vector_at(reference, kPosition, i), camera, kind));
  }
  return farthest;
}

Given read_given(const EngineSurfaces& surfaces, const SurfaceReading& reading, const Image& reference) {
  const Image& image = surfaces.channels;
  Given given;
  if (has_all(image, kNormal)) given.n_world = vectors(image, kNormal, reading.space, 1.0);
  if (has_all(image, kPosition)) {
    given.p_world = vectors(image, kPosition, reading.space, reading.space.unit);
  } else if (image.has("depth")) {
    if (reading.camera == nullptr)
      fail_input("a depth channel needs the camera to say where points are", {}, "give --scene");
    given.p_world = positions_from_depth(image, *reading.camera, reading.depth, reading.space.unit);
  }
  if (!image.has("depth") || reading.camera == nullptr) return given;
  const double limit = kBeyond * farthest_depth(reference, *reading.camera, reading.depth);
  const auto depth = image.plane("depth");
  given.is_hit.resize(depth.size());
  for (size_t i = 0; i < depth.size(); ++i) {
    const double z = reading.space.unit * static_cast<double>(depth[i]);
    given.is_hit[i] = z > 0.0 && z <= limit ? 1 : 0;
  }
  return given;
}

bool hits(const Given& given, const Image& reference, size_t i) {
  if (!given.p_world.empty() && !is_somewhere(given.p_world[i])) return false;
  if (!given.is_hit.empty()) return given.is_hit[i] != 0;
  return reference.plane("primitive_id")[i] >= 0.0f;
}

void write(const glm::dvec3& value, const std::array<const char*, 3>& names, size_t i, Image& test) {
  for (int axis = 0; axis < 3; ++axis)
    test.plane(names[static_cast<size_t>(axis)])[i] = static_cast<float>(value[axis]);
}

/// Unit, towards the camera; a vector of no length stays.
glm::dvec3 facing(const glm::dvec3& n_world, const glm::dvec3& away_world, size_t& turned) {
  const double length = glm::length(n_world);
  if (!(length > 0.0) || !std::isfinite(length)) return glm::dvec3(0.0);
  if (glm::dot(n_world, away_world) <= 0.0) return n_world / length;
  ++turned;
  return -n_world / length;
}

/// Where nothing is given, test has the reference's already.
void take(const EngineSurfaces& surfaces, const SurfaceReading& reading, const Given& given,
          const Image& reference, Image& test, std::vector<std::string>& notes) {
  const Image& image = surfaces.channels;
  const bool has_ids = image.has("primitive_id");
  const bool invents_ids = !has_ids && (!given.p_world.empty() || !given.n_world.empty());
  const auto theirs = reference.plane("primitive_id");
  size_t turned = 0;
  for (size_t i = 0; i < test.pixel_count(); ++i) {
    if (!surfaces.has_data.empty() && surfaces.has_data[i] == 0) continue;
    const bool is_hit = hits(given, reference, i);
    // Other identifiers than the reference's, so that places and normals must agree.
    if (invents_ids) test.plane("primitive_id")[i] = is_hit ? std::max(theirs[i], 0.0f) + 1.0f : -1.0f;
    if (has_ids) test.plane("primitive_id")[i] = image.plane("primitive_id")[i];
    if (image.has("unshadowed_irradiance"))
      test.plane("unshadowed_irradiance")[i] = image.plane("unshadowed_irradiance")[i];
    if (!is_hit && !has_ids) continue;
    if (!given.p_world.empty() && is_somewhere(given.p_world[i])) write(given.p_world[i], kPosition, i, test);
    if (given.n_world.empty()) continue;
    const glm::dvec3 eye_world = reading.camera != nullptr ? reading.camera->eye_world : glm::dvec3(0.0);
    const glm::dvec3 away = reading.camera != nullptr ? vector_at(reference, kPosition, i) - eye_world
                                                      : -vector_at(reference, kNormal, i);
    write(facing(given.n_world[i], away, turned), kNormal, i, test);
  }
  if (turned > 0)
    notes.push_back(fmt::format("{} {} away from the camera and {} turned round", turned,
                                turned == 1 ? "normal faces" : "normals face", turned == 1 ? "was" : "were"));
}

void note_unknown(const EngineSurfaces& surfaces, const Given& given, std::vector<std::string>& notes) {
  const Image& image = surfaces.channels;
  if (given.p_world.empty())
    notes.push_back(
        "no position or depth: not known whether the picture shows the same places (camera, pixel "
        "centres, geometry)");
  if (given.n_world.empty()) notes.push_back("no normal: not known whether surfaces face the same way");
  if (!image.has("primitive_id") && !given.p_world.empty())
    notes.push_back("no primitive_id: surfaces are told apart by place and normal alone");
  if (!image.has("primitive_id") && given.p_world.empty())
    notes.push_back("no primitive_id: not known where the picture shows nothing");
  if (!image.has("unshadowed_irradiance"))
    notes.push_back("no unshadowed_irradiance: not known whether the light is the same");
}

}  // namespace

void borrow_surfaces(const Image& reference, Image& test) {
  require_same_size(test, reference, "score");
  for (const char* name : kPosition) copy(reference, name, test);
  for (const char* name : kNormal) copy(reference, name, test);
  copy(reference, "primitive_id", test);
  copy(reference, "unshadowed_irradiance", test);
}

std::vector<std::string> add_surfaces(const EngineSurfaces& surfaces, const SurfaceReading& reading,
                                      const Image& reference, Image& test) {
  require_same_size(test, reference, "score");
  if (!surfaces.understood()) {
    if (surfaces.not_understood.empty()) return {};
    return {fmt::format(
        "no surface channel was understood, there are only {}: parity is not checked; names like position.x, "
        "Depth.Z or N.X are known, and position=FILE, normal=FILE, depth=FILE say what a file holds",
        fmt::join(surfaces.not_understood, ", "))};
  }
  require_same_size(surfaces.channels, reference, "surface channels");
  borrow_surfaces(reference, test);
  std::vector<std::string> notes = better_readings(surfaces, reading, reference);
  const Given given = read_given(surfaces, reading, reference);
  take(surfaces, reading, given, reference, test, notes);
  note_unknown(surfaces, given, notes);
  return notes;
}

}  // namespace umbrameter
