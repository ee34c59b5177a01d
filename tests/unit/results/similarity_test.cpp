// SPDX-License-Identifier: Apache-2.0
// Without these tests FLIP, SSIM and PSNR could be of another picture than the lit one.

#include "metrics/error/lit_similarity.h"

#include "results/json/similarity_json.h"
#include "results/similarity_format.h"
#include "tests/unit/metrics/synthetic.h"

#include "core/error.h"
#include "metrics/flip/flip.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace umbrameter {
namespace {

using testing::box_ramp;
using testing::everywhere;

Image floor(double width) {
  Image image = testing::lit_floor(testing::floor_from_above(96, 48, 0.01),
                                   [width](double x, double) { return box_ramp(x - 0.5, width); });
  image.plane("unshadowed_irradiance")[0] = 2.0f;  // the brightest place
  return image;
}

TEST(Similarity, OfEqualPicturesIsPerfect) {
  const Image image = floor(0.2);
  const Similarity same = measure_similarity(image, image, everywhere(image));
  EXPECT_EQ(same.flip_mean, 0.0);
  EXPECT_EQ(same.hdr_flip_mean, 0.0);
  EXPECT_NEAR(*same.ssim, 1.0, 1e-6);
  EXPECT_TRUE(std::isinf(*same.psnr_db));
  EXPECT_NEAR(same.pixels_per_degree, 67.0206, 1e-4);
}

TEST(Similarity, OfManyTestsIsThatOfEach) {
  const Image truth = floor(0.2);
  std::vector<uint8_t> mask = everywhere(truth);
  mask[5] = 0;
  const SimilarityReference reference(truth, mask);
  for (const double width : {0.3, 0.4}) {
    const Similarity one = measure_similarity(floor(width), truth, mask),
                     of_many = reference.measure(floor(width));
    EXPECT_EQ(of_many.flip_mean, one.flip_mean);
    EXPECT_EQ(of_many.hdr_flip_mean, one.hdr_flip_mean);
    EXPECT_EQ(of_many.ssim, one.ssim);
  }
}

TEST(Similarity, IsOfVisibilityTimesTheTruthsIrradiance) {
  const Image reference = floor(0.2);
  Image test = floor(0.4);
  std::ranges::fill(test.plane("unshadowed_irradiance"), 9.0f);  // must not count
  const std::vector<float> lit = lit_plane(test, reference, everywhere(test));
  EXPECT_FLOAT_EQ(lit[0], test.plane("visibility")[0]);
  EXPECT_FLOAT_EQ(lit[95], 0.5f * test.plane("visibility")[95]);
  const Similarity differs = measure_similarity(test, reference, everywhere(test));
  EXPECT_GT(*differs.flip_mean, 0.01);
  EXPECT_LT(*differs.ssim, 1.0);
  // By hand: the mean squared difference of sRGB values.
  double sum = 0.0;
  const std::vector<float> truth = lit_plane(reference, reference, everywhere(test));
  const auto srgb = [](double v) {
    return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
  };
  for (size_t i = 0; i < lit.size(); ++i) sum += std::pow(srgb(lit[i]) - srgb(truth[i]), 2);
  EXPECT_NEAR(*differs.psnr_db, -10.0 * std::log10(sum / static_cast<double>(lit.size())), 1e-3);
}

TEST(Similarity, WhatIsNotScoredIsBlackInBoth) {
  const Image reference = floor(0.2);
  Image test = reference;
  test.plane("visibility")[50] = 0.0f;
  std::vector<uint8_t> mask = everywhere(test);
  mask[50] = 0;
  EXPECT_EQ(measure_similarity(test, reference, mask).flip_mean, 0.0);
  EXPECT_GT(measure_similarity(test, reference, everywhere(test)).flip_mean, 0.0);
}

TEST(Similarity, ABlackTruthHasNoHdrFlip) {
  Image reference = floor(0.2);
  std::ranges::fill(reference.plane("visibility"), 0.0f);
  const Similarity dark = measure_similarity(reference, reference, everywhere(reference));
  EXPECT_FALSE(dark.hdr_flip_mean);
  EXPECT_TRUE(dark.flip_mean);
}

TEST(Similarity, NotANumberIsNamedByItsPixel) {
  const Image reference = floor(0.2);
  Image test = reference;
  test.plane("visibility")[97] = std::nanf("");
  EXPECT_THAT([&] { measure_similarity(test, reference, everywhere(test)); },
              ::testing::ThrowsMessage<Error>(::testing::HasSubstr("(1, 1)")));
}

TEST(Similarity, SurvivesJsonInfinityIncluded) {
  const Image reference = floor(0.2), test = floor(0.4);
  for (const Image* image : {&reference, &test}) {
    const Similarity similarity = measure_similarity(*image, reference, everywhere(reference));
    const auto json = similarity_json(similarity);
    EXPECT_EQ(similarity_json(read_similarity(nlohmann::json::parse(json.dump()))), json);
    EXPECT_EQ(read_similarity(json)->psnr_db, similarity.psnr_db);
  }
  EXPECT_TRUE(similarity_json(std::nullopt).is_null());
  EXPECT_FALSE(read_similarity(nullptr));
}

}  // namespace
}  // namespace umbrameter
