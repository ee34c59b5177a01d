// SPDX-License-Identifier: Apache-2.0
// Without these the exact oracle could be asked about another scene than the one under test, or its answers be misread.

#include "reference/exact_request.h"

#include "reference/exact/exact_oracle.h"
#include "scenes/load_scene.h"
#include "tests/support/models.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <fstream>

namespace umbrameter {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

Scene plate() {
  return load_scene(model_search().library / "plate.toml", model_search());
}

std::vector<ExactReceiver> receivers() {
  return {{{0.1, 1e-12, 0.3}, {0, 1, 0}, {0, 1, 0}, {}},
          {{1.0 / 3.0, 1e-12, 0}, {0, 1, 0}, {0, 1, 0}, {2, 3}}};
}

std::string problem(const fs::path& file) {
  try {
    read_exact_request(file);
    return "read";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    return error.what();
  }
}

TEST(ExactRequest, ArrivesAsItLeft) {
  const TemporaryFolder folder;
  const Scene scene = plate();
  write_exact_request(folder.path() / "request", scene, receivers(), 3);
  const ExactRequest request = read_exact_request(folder.path() / "request");
  EXPECT_EQ(request.threads, 3);
  EXPECT_EQ(request.scene.positions_world, scene.positions_world);
  EXPECT_EQ(request.scene.triangles, scene.triangles);
  EXPECT_EQ(request.scene.light().type, scene.light().type);
  EXPECT_EQ(request.scene.light().center_world, scene.light().center_world);
  EXPECT_EQ(request.scene.light().size_world, scene.light().size_world);
  ASSERT_EQ(request.receivers.size(), 2u);
  EXPECT_EQ(request.receivers[1].p_world, receivers()[1].p_world);
  EXPECT_EQ(request.receivers[1].transparent, (std::vector<uint32_t>{2, 3}));
  SilentProgress silent;
  const auto direct = exact_oracle()(scene, receivers(), 1, silent);
  const auto sent = exact_oracle()(request.scene, request.receivers, 1, silent);
  for (size_t i = 0; i < direct.size(); ++i) {
    EXPECT_EQ(direct[i].visibility_low, sent[i].visibility_low) << i;
    EXPECT_EQ(direct[i].irradiance_ratio, sent[i].irradiance_ratio) << i;
  }
  EXPECT_LT(direct[0].visibility(), 1.0);
}

TEST(ExactRequest, TransparentTrianglesHideNothing) {
  const Scene scene = plate();
  std::vector<uint32_t> all(scene.triangles.size());
  for (size_t i = 0; i < all.size(); ++i) all[i] = static_cast<uint32_t>(i);
  const std::vector<ExactReceiver> one{{{0, 1e-12, 0}, {0, 1, 0}, {0, 1, 0}, all}};
  SilentProgress silent;
  EXPECT_DOUBLE_EQ(exact_oracle()(scene, one, 1, silent)[0].visibility(), 1.0);
}

TEST(ExactRequest, WhatIsCutShortOrForeignIsRefused) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "request";
  write_exact_request(file, plate(), receivers(), 0);
  const auto size = fs::file_size(file);
  for (const uintmax_t keep : {size - 1, size / 2, uintmax_t{60}, uintmax_t{4}}) {
    fs::resize_file(file, keep);
    EXPECT_THAT(problem(file), HasSubstr("cut short")) << keep;
  }
  std::ofstream(file) << "something else entirely";
  EXPECT_THAT(problem(file), HasSubstr("no request of this version"));
  EXPECT_THAT(problem(folder.path() / "none"), HasSubstr("cannot be read"));
  Scene broken = plate();
  broken.triangles.edit().front().y = 1u << 20;
  write_exact_request(file, broken, receivers(), 0);
  EXPECT_THAT(problem(file), HasSubstr("corner that is not there"));
}

TEST(ExactRequest, ALineHoldsEveryBitOfAnAnswer) {
  const ExactLight answer{.visibility_low = 0.1,
                          .visibility_high = 1.0 / 3.0,
                          .irradiance_ratio = 2.0 / 7.0,
                          .triangles = 5,
                          .edges = 9};
  const auto [receiver, read] = from_line(to_line(4, answer));
  EXPECT_EQ(receiver, 4u);
  EXPECT_EQ(read.visibility_low, answer.visibility_low);
  EXPECT_EQ(read.visibility_high, answer.visibility_high);
  EXPECT_EQ(read.irradiance_ratio, answer.irradiance_ratio);
  EXPECT_EQ(read.triangles, 5u);
  EXPECT_EQ(read.edges, 9u);
  EXPECT_EQ(from_line(to_line(0, {})).second.irradiance_ratio, std::nullopt);
  for (const std::string line : {"", "1 2 3", "0 0x1p-1 0x1p-1 some 1 2", "0 0x1p-1 0x1p-1 none 1 2 3"})
    EXPECT_THROW(from_line(line), Error) << line;
}

}  // namespace
}  // namespace umbrameter
