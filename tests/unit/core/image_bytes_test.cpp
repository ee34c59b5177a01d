// SPDX-License-Identifier: Apache-2.0
// Without this a store would keep equal images twice, and parts of a sweep would differ from the whole.

#include "tests/support/temporary_folder.h"

#include "core/files.h"
#include "core/image_io.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace umbrameter {
namespace {

TEST(ImageBytesTest, EqualImagesAreEqualFilesWhenever) {
  const TemporaryFolder folder;
  Image image(4, 3);
  image.add_plane("visibility", 0.25f);
  image.metadata["scene"] = "plate";
  write_exr(folder.path() / "a.exr", image);
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // headers count seconds
  write_exr(folder.path() / "b.exr", image);
  EXPECT_EQ(read_file(folder.path() / "a.exr"), read_file(folder.path() / "b.exr"));
}

}  // namespace
}  // namespace umbrameter
