// SPDX-License-Identifier: Apache-2.0
// Without these, tuning a faint light could seem to be worth as much as tuning the one that lights the room.
#include "study/tune/lit_sum.h"

#include <gtest/gtest.h>

#include <cmath>

namespace umbrameter {
namespace {

constexpr int kSide_px = 128;  // 16 tiles, so that a difference can be told
constexpr size_t kPixels = size_t{kSide_px} * kSide_px;

Image plain(const std::vector<std::pair<const char*, float>>& planes) {
  Image image(kSide_px, kSide_px);
  for (const auto& [name, value] : planes) image.add_plane(name, value);
  return image;
}

Image truth(float irradiance, float ratio) {
  return plain({{"unshadowed_irradiance", irradiance},
                {"irradiance_ratio", ratio},
                {"irradiance_half_a", ratio},
                {"irradiance_half_b", ratio},
                {"irradiance_ratio_se", 0.0f}});
}

struct Parts {
  Image bright_truth = truth(3.0f, 0.5f), faint_truth = truth(1.0f, 1.0f);
  Image bright_before = plain({{"visibility", 0.9f}}), faint_before = plain({{"visibility", 0.8f}});
  Image bright_after = plain({{"visibility", 0.5f}}), faint_after = plain({{"visibility", 0.4f}});
  std::vector<uint8_t> bright_mask = std::vector<uint8_t>(kPixels, 1);
  std::vector<uint8_t> faint_mask = bright_mask;

  std::optional<LitSum> measure() const {
    const std::vector<LitPart> parts = {{&bright_truth, bright_mask, &bright_before, &bright_after},
                                        {&faint_truth, faint_mask, &faint_before, &faint_after}};
    return measure_lit_sum(parts);
  }
};

TEST(LitSum, WeighsLightsByTheirIrradiance) {
  const auto sum = Parts().measure();
  ASSERT_TRUE(sum);
  EXPECT_EQ(sum->pixels, kPixels);
  EXPECT_NEAR(sum->before.value, std::abs(3 * (0.9 - 0.5) + 1 * (0.8 - 1.0)) / 4.0, 1e-6);
  EXPECT_NEAR(sum->after.value, 0.6 / 4.0, 1e-6) << "the faint light became worse, the sum better";
  EXPECT_EQ(sum->outcome, Comparison::better);
}

TEST(LitSum, LeavesOutPixelsThatALightHasNoNumberFor) {
  Parts parts;
  for (size_t i = 0; i < 16; ++i) parts.faint_mask[i] = 0;
  EXPECT_EQ(parts.measure()->pixels, kPixels - 16);
  // Where the light does not reach, it needs none.
  for (size_t i = 0; i < 8; ++i) parts.faint_truth.plane("unshadowed_irradiance")[i] = 0.0f;
  EXPECT_EQ(parts.measure()->pixels, kPixels - 8);
  parts.bright_mask.assign(parts.bright_mask.size(), 0);
  EXPECT_FALSE(parts.measure());
}

}  // namespace
}  // namespace umbrameter
