// SPDX-License-Identifier: Apache-2.0
// Without these, foliage could be a leaf in the truth and a solid card in a technique, or the other way round.

#include "core/progress.h"
#include "reference/reference.h"
#include "tests/gpu/technique_fixture.h"
#include "tests/support/cutout_card.h"
#include "tests/support/procedural_scene.h"

#include <gtest/gtest.h>

#include <numeric>

namespace umbrameter {
namespace {

using namespace test;

const AlphaMask kLeaves = pattern_mask({"#.#.", "....", ".##.", "#..."});

/// The floor of half_plane_scene() from its camera, with a card over everything.
Scene under_card(const Light& light, const AlphaMask& mask) {
  Scene scene;
  scene.lights = {light};
  scene.camera = half_plane_scene(light).camera;
  add_floor(scene, {12, 12});
  add_cutout_card(scene, mask, {12, 12}, 1.5, 0.8);
  finish_scene(scene);
  return scene;
}

double mean(std::span<const float> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

TEST(cutouts, both_renderers_see_the_same_triangles_through_the_holes) {
  UMBRAMETER_REQUIRE_GL();
  Scene scene;
  scene.lights.push_back(light_at_4(LightType::rect, 0.5));
  add_floor(scene, {8, 8});
  add_box(scene, {-0.4, 0, -0.4}, {0.4, 0.6, 0.4});
  add_cutout_card(scene, kLeaves, {3, 3}, 1.2, 0.37);
  scene.camera = {.eye_world = {1.9, 2.3, 2.7}, .at_world = {0, 0.7, 0}};
  finish_scene(scene);
  const int width_px = 480, height_px = 270;
  const Frame drawn = render(scene, "hard", {}, 1, width_px, height_px);
  SilentProgress progress;
  const Frame traced =
      make_reference_renderer({16, {}, 0})
          ->render(
              scene,
              {.width_px = width_px, .height_px = height_px, .seed = 1, .technique = {}, .parameters = {}},
              progress);
  const auto a = drawn.image.plane("primitive_id"), b = traced.image.plane("primitive_id");
  size_t equal = 0, card = 0, through = 0;
  const auto first_cutout = static_cast<float>(scene.first_cutout());
  for (size_t i = 0; i < a.size(); ++i) {
    equal += a[i] == b[i] ? 1 : 0;
    card += b[i] >= first_cutout ? 1 : 0;
    through += b[i] >= 0.0f && b[i] < first_cutout ? 1 : 0;
  }
  EXPECT_GT(card, a.size() / 20) << "the card is in the picture";
  EXPECT_GT(through, a.size() / 20);
  EXPECT_GE(static_cast<double>(equal) / static_cast<double>(a.size()), 0.999);
}

TEST(every_technique, lets_light_through_holes) {
  UMBRAMETER_REQUIRE_GL();
  const double share = hole_share(kLeaves);
  for (const Technique& technique : techniques()) {
    if (technique.views.empty()) continue;  // draws nothing from the light: the camera does not see the card
    const Light light =
        light_at_4(technique.supports(LightType::rect) ? LightType::rect : technique.lights.front(), 0.5);
    const double holes =
        mean(render(under_card(light, kLeaves), technique.id, quick(technique)).image.plane("visibility"));
    const double solid = mean(render(under_card(light, pattern_mask({"#"})), technique.id, quick(technique))
                                  .image.plane("visibility"));
    const double none = mean(render(under_card(light, pattern_mask({"."})), technique.id, quick(technique))
                                 .image.plane("visibility"));
    RecordProperty(technique.id, fmt::format("{:.3f} solid {:.3f} none {:.3f}", holes, solid, none));
    EXPECT_NEAR(holes, share, 0.1) << technique.id;
    EXPECT_LT(solid, 0.05) << technique.id;
    EXPECT_GT(none, 0.99) << technique.id;
  }
}

}  // namespace
}  // namespace umbrameter
