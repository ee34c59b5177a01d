// A 95 % interval that holds the truth in 80 % of the pixels is a lie, and one that holds it in 99.9 % wastes rays.

#include "reference/interval.h"
#include "tests/statistical/agreement.h"
#include "tests/statistical/oracle_scenes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace umbrameter {
namespace {

struct KnownScene {
  std::string name;
  Scene scene;
  std::function<double(const glm::dvec3&)> visibility;
};

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

struct Coverage {
  size_t points = 0;
  size_t covered = 0;
  double error_sum = 0.0;
  double variance_sum = 0.0;
  double share() const { return static_cast<double>(covered) / static_cast<double>(points); }
  double mean_z() const { return error_sum / std::sqrt(variance_sum); }
};

/// Over the pixels whose truth is strictly between 0 and 1; those proven would only flatter.
Coverage coverage_of(const KnownScene& known, const ReferencePicture& picture) {
  const Frame frame = render_reference(known.scene, picture);
  const auto v = frame.image.plane("visibility");
  const auto se = frame.image.plane("visibility_se");
  Coverage coverage;
  for (size_t i = 0; i < v.size(); ++i) {
    const double truth = known.visibility(position_of(frame, i));
    if (truth <= 0.0 || truth >= 1.0) continue;
    const VisibilityInterval interval = interval_95(v[i], se[i]);
    ++coverage.points;
    if (interval.low <= truth && truth <= interval.high) ++coverage.covered;
    coverage.error_sum += v[i] - truth;
    coverage.variance_sum += std::pow(static_cast<double>(se[i]), 2);
  }
  return coverage;
}

void expect_certified(const ReferencePicture& picture) {
  size_t points = 0, covered = 0;
  for (const KnownScene& known : known_scenes()) {
    const Coverage c = coverage_of(known, picture);
    std::cout << fmt::format("{:20} {:5} points, {:.1f} % covered, mean z {:.2f}\n", known.name, c.points,
                             100.0 * c.share(), c.mean_z());
    EXPECT_GT(c.points, 200u) << known.name;
    EXPECT_LT(std::abs(c.mean_z()), 4.0) << known.name;
    points += c.points;
    covered += c.covered;
  }
  const double share = static_cast<double>(covered) / static_cast<double>(points);
  std::cout << fmt::format("{:20} {:5} points, {:.1f} % covered\n", "all", points, 100.0 * share);
  EXPECT_GT(share, 0.93);
  EXPECT_LT(share, 0.97);
}

TEST(Coverage, of_the_interval_is_95_percent_at_a_fixed_sample_count) {
  expect_certified({.side_px = 48, .samples_per_pixel = 512, .seed = 11});
}

TEST(Coverage, of_the_interval_is_95_percent_where_sampling_stops_by_itself) {
  expect_certified({.side_px = 48, .samples_per_pixel = 1 << 14, .seed = 12, .target_se = 0.004});
}

}  // namespace
}  // namespace umbrameter
