// SPDX-License-Identifier: Apache-2.0
// The stated error bars of real scenes, held against exact arithmetic: where no closed form can look, an interval could be
// too small, or stopping early could pull the picture to one side, unnoticed. More points: docs/truth.md.

#include "reference/exact/exact_oracle.h"
#include "reference/exact_check.h"
#include "tests/statistical/agreement.h"
#include "tests/support/models.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <iostream>

namespace umbrameter {
namespace {

struct Certified {
  std::string scene;
  size_t points = 0;
};

/// A picture whose sampling stops by itself, at points chosen by a picture of other samples.
ExactComparison check(const Certified& what, uint64_t seed) {
  const Scene scene = load_scene(model_search().library / (what.scene + ".toml"), model_search());
  RenderRequest request;
  request.width_px = 192;
  request.height_px = 108;
  request.seed = seed;
  SilentProgress progress;
  const Frame frame = make_reference_renderer({1 << 12, 0.01})->render(scene, request, progress);
  request.seed = ~seed;
  const Frame pilot = make_reference_renderer({64, {}})->render(scene, request, progress);
  const std::vector<size_t> pixels = draw_check_pixels(pilot.image, what.points, seed);
  return compare_with_exact(check_pixels(scene, frame.image, pixels, exact_oracle(), 0, progress));
}

/// Each scene with samples of its own, so that they can be joined.
ExactAgreement expect_certified(const std::vector<Certified>& scenes, uint64_t first_seed) {
  ExactAgreement all;
  for (const Certified& what : scenes) {
    const ExactComparison c = check(what, first_seed++);
    const ExactAgreement& p = c.penumbra;
    const double z = p.mean_error / p.mean_error_noise;
    std::cout << fmt::format(
        "{:22} {:4} points: {:.1f} % covered, mean z {:+.2f}, RMS error {:.2f} of stated\n", what.scene,
        p.points, 100.0 * p.coverage(), z, p.rms_error / p.rms_se);
    EXPECT_LT(std::abs(z), 3.0) << what.scene;
    // Rays that left too high above thin steps once erred by ten standard errors in one point of a hundred.
    EXPECT_LT(p.rms_error, 1.25 * p.rms_se) << what.scene;
    EXPECT_EQ(c.others_wrong, 0u) << what.scene;
    all.points += p.points;
    all.covered += p.covered;
  }
  std::cout << fmt::format("all: {} points, {:.1f} % covered\n", all.points, 100.0 * all.coverage());
  return all;
}

TEST(Certified, intervals_hold_the_exact_answer_in_the_library) {
  const ExactAgreement all = expect_certified({{"comb", 360},
                                               {"wire", 360},
                                               {"fence", 360},
                                               {"colonnade", 360},
                                               {"stacked_plates", 360},
                                               {"contact_hardening", 360},
                                               {"half_plane_disk", 360},
                                               {"sphere_terminator", 360}},
                                              100);
  EXPECT_GT(all.points, 2000u);
  EXPECT_NEAR(all.coverage(), 0.95, 0.02);
}

TEST(Certified, intervals_hold_the_exact_answer_in_real_scenes) {
  if (!has_models()) GTEST_SKIP() << no_models();
  // A point among hairs costs seconds.
  const ExactAgreement all = expect_certified({{"assets/bunny", 240},
                                               {"assets/dragon", 120},
                                               {"assets/crytek_sponza", 240},
                                               {"assets/desk_fan", 240},
                                               {"assets/hair", 12}},
                                              200);
  EXPECT_GT(all.points, 600u);
  EXPECT_NEAR(all.coverage(), 0.95, 0.02);
}

}  // namespace
}  // namespace umbrameter
