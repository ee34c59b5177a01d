// SPDX-License-Identifier: Apache-2.0
// Without these a picture could be drawn twice, or one be taken for another: of another moment, scene, technique or device.

#include "lab/stored_frames.h"
#include "lab/stored_truth.h"
#include "scenes/motion.h"
#include "scenes/scene_hash.h"
#include "tests/support/lab/fakes.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace umbrameter {
namespace {

class StoredFramesTest : public testing::Test {
 protected:
  StoredFramesTest() : scene_(fake_scene("plate").scene) {
    request_.width_px = kFakeWidth_px;
    request_.height_px = kFakeHeight_px;
    request_.technique = "pcf";
    request_.parameters["taps"] = int64_t{16};
    request_.parameters["bias"] = 0.5;
  }

  /// As a process of its own would.
  Frame render(FrameUse use = {}, const std::string& device = "device 1", const std::string& hash = "hash") {
    LazyStore store(folder_.path());
    StoredFrames frames(
        renderer_, store, {"tracer", device, "shaders"},
        [&](const std::string& technique) { return technique + hash; }, use, folder_.path());
    return frames.render(scene_, request_, progress_);
  }

  size_t drawn() const { return renderer_.requests.size(); }

  TemporaryFolder folder_;
  SilentProgress progress_;
  FakeRenderer renderer_{[](const RenderRequest& request) {
    Frame frame = frame_of(technique_image(0.1f));
    frame.image.metadata["engine_parity"] = "all";
    frame.parameters = request.parameters;
    frame.device = "llvmpipe";
    frame.is_software = true;
    frame.memory_bytes = 123;
    frame.wall_time_s = 0.25;
    frame.warnings = {"a warning"};
    frame.left_out = {"blur"};
    return frame;
  }};
  Scene scene_;
  RenderRequest request_;
};

TEST_F(StoredFramesTest, AFrameIsDrawnOnceAndComesBackAsItWas) {
  const Frame first = render(), second = render();
  EXPECT_EQ(drawn(), 1u);
  EXPECT_EQ(second.image.planes, first.image.planes);
  EXPECT_EQ(second.image.metadata, first.image.metadata);
  EXPECT_EQ(second.image.width, first.image.width);
  EXPECT_EQ(second.parameters, first.parameters);
  EXPECT_EQ(second.device, first.device);
  EXPECT_EQ(second.is_software, first.is_software);
  EXPECT_EQ(second.memory_bytes, first.memory_bytes);
  EXPECT_EQ(second.wall_time_s, first.wall_time_s);
  EXPECT_EQ(second.warnings, first.warnings);
  EXPECT_EQ(second.left_out, first.left_out);
}

TEST_F(StoredFramesTest, WhateverChangesThePictureDrawsAnother) {
  const std::vector<std::function<void()>> changes = {
      [&] { request_.seed = 2; },
      [&] { request_.width_px = 41; },
      [&] { request_.technique = "hard"; },
      [&] { request_.parameters["bias"] = 0.25; },
      [&] { scene_.camera.eye_world.x += 1.0; },
      [&] { scene_.lights.at(0).center_world.x += 1.0; },
      [&] { scene_.motion.frames_before = 3; },
      [&] { scene_.motion.frames_before = 4; },
      [&] { scene_.motion = standard_motion("pan", scene_); }};
  render();
  size_t wanted = 1;
  for (const auto& change : changes) {
    change();
    render();
    EXPECT_EQ(drawn(), ++wanted);
  }
  render({}, "device 2");
  EXPECT_EQ(drawn(), ++wanted);
  render({}, "device 2", "other files");
  EXPECT_EQ(drawn(), ++wanted);
  render({}, "device 2", "other files");
  EXPECT_EQ(drawn(), wanted);
}

TEST_F(StoredFramesTest, SearchesKeepSurfacesAlone) {
  render({.keep_runs = false});
  render({.keep_runs = false});
  EXPECT_EQ(drawn(), 2u);
  request_.technique.clear();
  render({.keep_runs = false});
  render({.keep_runs = false});
  EXPECT_EQ(drawn(), 3u);
}

TEST_F(StoredFramesTest, SurfacesFoundAgainByOneRendererAreWhole) {
  request_.technique.clear();
  const Frame drawn_frame = render();
  LazyStore store(folder_.path());
  StoredFrames frames(
      renderer_, store, {"tracer", "device 1", "shaders"}, [](const std::string&) { return std::string(); },
      {}, folder_.path());
  for (int i = 0; i < 2; ++i) {
    const Image image = frames.render(scene_, request_, progress_).image;
    EXPECT_EQ(image.width, drawn_frame.image.width);
    EXPECT_EQ(image.height, drawn_frame.image.height);
    EXPECT_EQ(image.planes, drawn_frame.image.planes);
    EXPECT_EQ(image.metadata, drawn_frame.image.metadata);
  }
  EXPECT_EQ(drawn(), 1u);
}

TEST_F(StoredFramesTest, AFrameKeptAsOneImageIsFoundTwiceTheSame) {
  const Frame frame = render();
  {
    LazyStore store(folder_.path());
    const std::string key = frame_key(hash_scene(scene_), scene_.active_light, request_, "pcfhash",
                                      {"tracer", "device 1", "shaders"});
    const std::string object = keep_image(store.store(), frame.image, folder_.path());
    keep_frame(store.store(), key, frame, std::vector{object});
  }
  LazyStore store(folder_.path());
  StoredFrames frames(
      renderer_, store, {"tracer", "device 1", "shaders"},
      [](const std::string& technique) { return technique + "hash"; }, {}, folder_.path());
  for (int i = 0; i < 2; ++i) {
    const Image image = frames.render(scene_, request_, progress_).image;
    EXPECT_EQ(image.width, frame.image.width);
    EXPECT_EQ(image.planes, frame.image.planes);
  }
  EXPECT_EQ(drawn(), 1u);
}

TEST_F(StoredFramesTest, WithoutReuseItIsDrawnAndReplaced) {
  render();
  render({.find = false});
  EXPECT_EQ(drawn(), 2u);
}

TEST_F(StoredFramesTest, APictureWithATruthsBlockersIsNotKept) {
  const Image truth = reference_image();
  request_.blocker_truth = &truth;
  render();
  render();
  EXPECT_EQ(drawn(), 2u);
}

TEST_F(StoredFramesTest, ADamagedFileIsDrawnAnew) {
  render();
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.path() / "objects"))
    if (entry.is_regular_file()) std::filesystem::resize_file(entry.path(), 10);
  const Frame again = render();
  EXPECT_EQ(drawn(), 2u);
  EXPECT_EQ(again.image.planes, frame_of(technique_image(0.1f)).image.planes);
}

}  // namespace
}  // namespace umbrameter
