// SPDX-License-Identifier: Apache-2.0
// Without these tests a score could be of other pixels than it says, or of pictures that show something else.

#include "lab/score.h"

#include "tests/support/lab/fakes.h"

#include "core/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace umbrameter {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(ScoreImage, ScoresAnImageWithoutSurfacesAndSaysThatParityWasNotChecked) {
  Image test(kFakeWidth_px, kFakeHeight_px);
  test.add_plane("visibility", 0.75f);
  const Score score = score_image(test, reference_image(), {0, 10, 0});
  EXPECT_FALSE(score.has_surfaces);
  ASSERT_TRUE(score.error);
  EXPECT_EQ(score.error->scored_pixels, 39u * kFakeHeight_px);  // the background column is not scored
  EXPECT_NEAR(*score.error->bias, 0.25, 1e-6);
}

TEST(ScoreImage, ScoresOnlyWhatIsKnownOfThePictureAndCountsWhatTheTruthCanScore) {
  Image test = technique_image(0.0f);
  std::vector<uint8_t> known(test.pixel_count(), 0);
  for (size_t i = 0; i < known.size(); ++i) known[i] = i % kFakeWidth_px < 20 ? 1 : 0;
  ScoreSettings settings;
  settings.known = known;
  const Score score = score_image(test, reference_image(), {0, 10, 0}, settings);
  ASSERT_TRUE(score.error);
  EXPECT_EQ(score.error->scored_pixels, 19u * kFakeHeight_px);
  EXPECT_EQ(score.scorable_pixels, 39u * kFakeHeight_px);
}

TEST(ScoreImage, SaysNothingOfNoPixel) {
  const Image test = technique_image(0.0f);
  const std::vector<uint8_t> known(test.pixel_count(), 0);
  ScoreSettings settings;
  settings.known = known;
  const Score score = score_image(test, reference_image(), {0, 10, 0}, settings);
  ASSERT_TRUE(score.error);
  EXPECT_EQ(score.error->scored_pixels, 0u);
  EXPECT_FALSE(score.similarity || score.diagnosis || score.lit_rmse || score.judgement.significance);
  EXPECT_TRUE(score.measured.empty());
}

TEST(ScoreImage, GivesNoNumberWhenParityFails) {
  Image test = technique_image(0.0f);
  for (float& primitive : test.plane("primitive_id")) primitive = -1.0f;
  const Score score = score_image(test, reference_image(), {0, 10, 0});
  EXPECT_TRUE(score.has_surfaces);
  EXPECT_FALSE(score.error);
}

TEST(ScoreImage, RejectsAnotherSize) {
  Image test(8, 8);
  test.add_plane("visibility", 1.0f);
  EXPECT_THROW(score_image(test, reference_image(), {0, 10, 0}), Error);
}

TEST(EyeOf, ReadsWhatTheHeaderSaysAndRejectsAnythingElse) {
  Image reference(1, 1);
  EXPECT_THAT([&] { eye_of(reference, "ref.exr"); },
              ThrowsMessage<Error>(HasSubstr("ref.exr: the reference has no")));
  reference.metadata["eye_world"] = "1 two 3";
  EXPECT_THAT([&] { eye_of(reference, "ref.exr"); },
              ThrowsMessage<Error>(HasSubstr("'1 two 3', not three numbers")));
  reference.metadata["eye_world"] = "1 -2.5 1e3";
  EXPECT_EQ(eye_of(reference, "ref.exr"), glm::dvec3(1.0, -2.5, 1000.0));
}

}  // namespace
}  // namespace umbrameter
