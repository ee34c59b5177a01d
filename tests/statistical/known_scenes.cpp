// SPDX-License-Identifier: Apache-2.0
#include "tests/statistical/known_scenes.h"

#include <algorithm>

namespace umbrameter {

namespace {

const glm::dvec3 kLightCenter{0, kLightHeight, 0};

template <class AddOccluder>
KnownScene known(const std::string& name, const Light& light, double width, const AddOccluder& add,
                 std::function<double(const glm::dvec3&)> visibility) {
  Scene scene = floor_under(light, width);
  add(scene);
  finish_scene(scene);
  return {name, std::move(scene), std::move(visibility)};
}

/// `count` bars of `width` along z, one every `pitch`: slits between them, or a single wire.
void add_bars(Scene& scene, int count, double pitch, double width) {
  for (int i = 0; i < count; ++i) {
    add_floor(scene, {width, 10}, kOccluderHeight, {(i - 0.5 * (count - 1)) * pitch, 0});
  }
}

/// What the bars leave of a square light of width 1.
double bars(const glm::dvec3& p, int count, double pitch, double width) {
  const auto on_light = [&](double edge) {
    return std::clamp((edge - p.x * (1.0 - kFraction)) / kFraction, -0.5, 0.5);
  };
  double open = 1.0;
  for (int i = 0; i < count; ++i) {
    const double middle = (i - 0.5 * (count - 1)) * pitch;
    open -= on_light(middle + 0.5 * width) - on_light(middle - 0.5 * width);
  }
  return open;
}

/// A sheet with a square hole over the origin: pin-hole.
void add_pinhole(Scene& scene, double half) {
  add_floor(scene, {10 - half, 20}, kOccluderHeight, {-0.5 * (10 + half), 0});
  add_floor(scene, {10 - half, 20}, kOccluderHeight, {0.5 * (10 + half), 0});
  add_floor(scene, {2 * half, 10 - half}, kOccluderHeight, {0, -0.5 * (10 + half)});
  add_floor(scene, {2 * half, 10 - half}, kOccluderHeight, {0, 0.5 * (10 + half)});
}

}  // namespace

std::vector<KnownScene> known_scenes() {
  const Light square = rect_light_above(kLightCenter, {1, 1});
  const Light disk = disk_light_above(kLightCenter, 0.5);
  const auto half_plane = [](Scene& s) { add_half_plane(s); };
  std::vector<KnownScene> all;
  all.push_back(known("half-plane, square", square, 0.4, half_plane,
                      [](const glm::dvec3& p) { return half_plane_square(p.x, 1.0); }));
  all.push_back(known("half-plane, disk", disk, 0.4, half_plane,
                      [](const glm::dvec3& p) { return half_plane_disk(p.x, 0.5); }));
  all.push_back(known("half-plane, sphere", sphere_light(kLightCenter, 0.5), 0.4, half_plane,
                      [](const glm::dvec3& p) { return half_plane_sphere(p, 0.5); }));
  all.push_back(known("half-plane, sun", sun_light({0, 1, 0}, 0.1), 0.3, half_plane,
                      [](const glm::dvec3& p) { return half_plane_sun(p.x, 0.1); }));
  all.push_back(known(
      "plate", rect_light_above(kLightCenter, {1.0, 0.6}), 0.7,
      [](Scene& s) {
        add_floor(s, {0.2, 0.3}, kOccluderHeight);
      },
      [](const glm::dvec3& p) {
        return plate_rect(p, {0.1, 0.15}, {1.0, 0.6});
      }));
  all.push_back(known(
      "coaxial disks", disk, 0.6,
      [](Scene& s) {
        add_disk(s, {0, kOccluderHeight, 0}, 0.12, 720);
      },
      [](const glm::dvec3& p) { return coaxial_disks(p, 0.12, 0.5); }));
  all.push_back(known(
      "wire", square, 0.4,
      [](Scene& s) {
        add_floor(s, {0.002, 10}, kOccluderHeight);
      },
      [](const glm::dvec3& p) { return bars(p, 1, 1.0, 0.002); }));
  all.push_back(known(
      "comb", square, 0.5, [](Scene& s) { add_bars(s, 24, 0.0125, 0.006); },
      [](const glm::dvec3& p) { return bars(p, 24, 0.0125, 0.006); }));
  all.push_back(known(
      "pin-hole", square, 0.3, [](Scene& s) { add_pinhole(s, 0.01); },
      [](const glm::dvec3& p) {
        return 1.0 - plate_rect(p, {0.01, 0.01}, {1, 1});
      }));
  return all;
}

}  // namespace umbrameter
