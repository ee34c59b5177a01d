// SPDX-License-Identifier: Apache-2.0
// Without these: a damaged file could be read as zeros, or a failed write could leave half a file.
#include "core/error.h"
#include "core/files.h"
#include "core/image_io.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace umbrameter {
namespace {

Image ramp(int width, int height) {
  Image image(width, height);
  std::span<float> v = image.add_plane("visibility");
  for (size_t i = 0; i < v.size(); ++i) v[i] = std::sin(static_cast<float>(i));
  image.add_plane("primitive_id", 16777215.0f);
  image.metadata["scene_hash"] = "abc";
  return image;
}

TEST(ImageIo, ExrKeepsEveryBitAndTheMetadata) {
  const TemporaryFolder folder;
  const Image image = ramp(17, 9);
  write_exr(folder.path() / "a.exr", image);
  const Image back = read_image(folder.path() / "a.exr");
  EXPECT_EQ(back.planes, image.planes);
  EXPECT_EQ(back.metadata, image.metadata);
}

TEST(ImageIo, TruncatedExrIsAnErrorThatNamesTheFile) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "a.exr";
  write_exr(path, ramp(64, 64));
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
  try {
    read_image(path);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_THAT(error.what(), testing::HasSubstr("a.exr"));
  }
}

TEST(ImageIo, FailedWriteLeavesNothingBehind) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_exr(folder.path() / "missing" / "a.exr", ramp(4, 4)), Error);
  EXPECT_THROW(write_file_atomically(folder.path() / "missing" / "a.txt", "x"), Error);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(ImageIo, PngRoundTrips) {
  const std::vector<uint8_t> rgb = {255, 0, 0, 0, 255, 0, 0, 0, 255, 10, 20, 30};
  const TemporaryFolder folder;
  write_png(folder.path() / "a.png", 2, 2, rgb);
  const Image back = read_image(folder.path() / "a.png");
  EXPECT_FLOAT_EQ(back.plane("R")[0], 1.0f);
  EXPECT_NEAR(back.plane("B")[3], 30.0f / 255.0f, 1e-6f);
  const Image from_bytes = read_image(encode_png(2, 2, rgb), "b.png");
  EXPECT_EQ(from_bytes.planes, back.planes);
}

TEST(Image, MissingChannelsAndNansAreNamed) {
  Image image = ramp(3, 2);
  EXPECT_THROW(image.plane("visibilty"), Error);
  image.plane("visibility")[4] = NAN;
  try {
    require_finite(image, "visibility");
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("'visibility' is nan at pixel (1, 1)"));
  }
}

}  // namespace
}  // namespace umbrameter
