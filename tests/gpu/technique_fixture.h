// SPDX-License-Identifier: Apache-2.0
#pragma once
// Scenes with closed-form visibility, and one GL renderer for all technique tests of a process.

#include "core/renderer.h"
#include "realtime/manifest/technique.h"
#include "scenes/scene.h"

#include <functional>
#include <string>
#include <vector>

namespace umbrameter::test {

/// Skips the test, with the reason, when there is no GL.
#define UMBRAMETER_REQUIRE_GL() \
  if (const std::string problem = ::umbrameter::test::gl_problem(); !problem.empty()) GTEST_SKIP() << problem

/// Why no renderer can be made here; empty when one can.
std::string gl_problem();

/// Every built-in technique.
std::vector<Technique> techniques();

/// Cheap enough for llvmpipe: small maps, and few where a technique renders many.
ParameterValues quick(const Technique& technique, int64_t map_size = 512, int64_t light_samples = 16);

/// 160 x 90 unless told; seed 1.
Frame render(const Scene& scene, const std::string& technique, const ParameterValues& parameters = {},
             uint64_t seed = 1, int width_px = 160, int height_px = 90);

/// The plane of channel "visibility".
std::vector<float> visibility(const Scene& scene, const std::string& technique,
                              const ParameterValues& parameters = {}, uint64_t seed = 1);

/// A light of `type` 4 above the origin, about `size` across (sun: tangent of the half angle size / 8).
Light light_at_4(LightType type, double size);

/// The light that tests of every technique give it where any will do: rect where it can, else the first it supports.
LightType any_light(const Technique& technique);

/// A floor at y = 0 and, 1.5 above it, a plate over all x < 0, seen from below the plate.
Scene half_plane_scene(const Light& light);
/// Share of a light at height 4 that a floor point sees past the edge x = 0 at height 1.5; sun: overhead.
double half_plane_visibility(const Light& light, const glm::dvec3& p_world);

/// A floor at y = 0 and a plate of 1 x 0.8 one above it, under a rect light of 1.2 x 0.6 at (0.2, 4, 0.1).
Scene plate_scene();
double plate_visibility(const glm::dvec3& p_world);

/// Blockers at two heights, a slope, a sphere: everything a parameter could act on.
Scene busy_scene(const Light& light);

/// `values` with those of `more` put in or in their place.
ParameterValues with(ParameterValues values, const ParameterValues& more);

/// Between two pictures of one size, pixel by pixel.
double largest_difference(const std::vector<float>& a, const std::vector<float>& b);
double mean_difference(const std::vector<float>& a, const std::vector<float>& b);

struct ErrorSummary {
  double rmse = 0.0;
  double worst = 0.0;
  size_t pixels = 0;
};
/// Against `truth(p_world)` on the pixels of the floor y = 0.
ErrorSummary floor_error(const Frame& frame, const std::function<double(const glm::dvec3&)>& truth);

}  // namespace umbrameter::test
