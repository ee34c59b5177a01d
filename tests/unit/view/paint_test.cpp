// SPDX-License-Identifier: Apache-2.0
// Without this the window could show errors in the wrong colour or pixels in the wrong place.

#include "view/paint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace umbrameter {
namespace {

/// Two pixels: a surface with visibility `v` under irradiance 2, and background.
Image two_pixels(float v) {
  Image image(2, 1);
  for (const char* name : {"visibility", "unshadowed_irradiance", "primitive_id", "visibility_se"})
    image.add_plane(name);
  image.plane("visibility")[0] = v;
  image.plane("unshadowed_irradiance")[0] = 2.0f;
  image.plane("primitive_id")[1] = -1.0f;
  return image;
}

Rgb8 first_pixel(const Picture& picture) {
  return {picture.rgb[0], picture.rgb[1], picture.rgb[2]};
}

TEST(Paint, FullyLitAtTheWhiteIrradianceIsNearlyWhite) {
  PaintSettings settings;
  settings.white_irradiance = 2.0;
  // .85 + .05 of white, sRGB: 1.055 x .9^(1/2.4) - .055 = .9547, x 255 = 243.4
  EXPECT_EQ(first_pixel(paint(Layer::lit, {two_pixels(1.0f), nullptr, {}, {}}, settings)),
            (Rgb8{243, 243, 243}));
}

TEST(Paint, FullShadowIsDarkButNotBlack) {
  PaintSettings settings;
  settings.white_irradiance = 2.0;
  // .05 of white: 1.055 x .05^(1/2.4) - .055 = .2478, x 255 = 63.2
  EXPECT_EQ(first_pixel(paint(Layer::lit, {two_pixels(0.0f), nullptr, {}, {}}, settings)),
            (Rgb8{63, 63, 63}));
}

TEST(Paint, ErrorAtTheEndsOfItsScaleHasTheReportsColours) {
  const Image truth = two_pixels(0.5f), dark = two_pixels(0.3f), bright = two_pixels(0.7f),
              equal = two_pixels(0.5f);
  PaintSettings settings;
  settings.error_scale = 0.2;
  const auto colour = [&](const Image& image) {
    return first_pixel(paint(Layer::error, {image, &truth, {}, {}}, settings));
  };
  EXPECT_EQ(colour(dark), kTooDarkColour);
  EXPECT_EQ(colour(bright), kTooBrightColour);
  EXPECT_EQ(colour(equal), kNoErrorColour);
}

TEST(Paint, UnscoredPixelsAreGrey) {
  const Image truth = two_pixels(0.5f), test = two_pixels(1.0f);
  const std::vector<uint8_t> scored{0, 0};
  EXPECT_EQ(first_pixel(paint(Layer::error, {test, &truth, scored, {}}, {})), kUnscoredColour);
}

TEST(Paint, FaultsLieOverTheLitPicture) {
  const Image truth = two_pixels(1.0f), test = two_pixels(0.0f);
  const std::vector<FaultClass> acne{FaultClass::acne, FaultClass::unscored},
      none{FaultClass::explained, FaultClass::unscored};
  const Rgb8 wanted = fault_legend()[static_cast<size_t>(FaultClass::acne)].colour;
  EXPECT_EQ(first_pixel(paint(Layer::faults, {test, &truth, {}, acne}, {})), wanted);
  EXPECT_EQ(first_pixel(paint(Layer::faults, {test, &truth, {}, none}, {})),
            first_pixel(paint(Layer::lit, {test, nullptr, {}, {}}, {})));
}

TEST(Paint, MapsColourWhatIsLookedUpInThem) {
  const Image test = two_pixels(1.0f);
  Image second(2, 1), none(2, 1);
  second.add_plane("Y", 1.0f);
  none.add_plane("Y", -1.0f);
  const auto colour = [&](const Image* maps) {
    return first_pixel(paint(Layer::maps, {test, nullptr, {}, {}, maps}, {}));
  };
  const Rgb8 plain = first_pixel(paint(Layer::lit, {test, nullptr, {}, {}}, {}));
  EXPECT_EQ(colour(nullptr), plain);
  EXPECT_EQ(colour(&none), plain);
  // .55 of white, .45 of the second map's colour
  for (size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(colour(&second)[k], 0.55 * plain[k] + 0.45 * map_colour(1)[k], 0.51);
}

TEST(Paint, ResourceRunsFromItsLeastToItsGreatestValue) {
  Image resource(3, 1);
  const std::span<float> values = resource.add_plane("Y");
  values[0] = 2.0f;
  values[1] = 4.0f;
  values[2] = std::numeric_limits<float>::quiet_NaN();
  const ResourcePicture shown = paint_resource(resource);
  EXPECT_EQ(shown.min, 2.0);
  EXPECT_EQ(shown.max, 4.0);
  EXPECT_EQ(shown.picture.rgb, (std::vector<uint8_t>{0, 0, 0, 255, 255, 255, 255, 0, 255}));
}

TEST(Paint, WhiteIsTheIrradianceThatFewPixelsExceed) {
  Image image(100, 1);
  const std::span<float> irradiance = image.add_plane("unshadowed_irradiance");
  for (size_t i = 0; i < 100; ++i) irradiance[i] = static_cast<float>(i + 1);
  EXPECT_DOUBLE_EQ(white_irradiance(image), 98.0);
  EXPECT_DOUBLE_EQ(white_irradiance(two_pixels(0.0f)), 2.0);
}

}  // namespace
}  // namespace umbrameter
