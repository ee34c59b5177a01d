// SPDX-License-Identifier: Apache-2.0
// Without these a verb could trace what is stored, open a device for nothing, or take what another device made.

#include "lab/verb_cache.h"
#include "core/error.h"
#include "lab/lazy_realtime.h"
#include "tests/support/lab/fakes.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace umbrameter {
namespace {

constexpr PictureQuality kPicture{
    .width_px = kFakeWidth_px, .height_px = kFakeHeight_px, .samples_per_pixel = 16};

class VerbCacheTest : public testing::Test {
 protected:
  /// As a process of its own would; where it is stored if `is_stored`.
  ReusedTruths render_truth(bool reuse = true, bool is_stored = true) {
    const auto open = [this](const PictureQuality&) {
      ++opened_;
      return std::make_unique<FakeRenderer>(fake_reference());
    };
    const auto makers = [](const Renderer&) { return Makers{"tracer", "device", "shaders"}; };
    const std::filesystem::path folder = is_stored ? folder_.path() : std::filesystem::path();
    VerbCache cache({open, "tracer", makers, [](const std::string&) { return std::string("hash"); }},
                    {folder, std::make_shared<const std::filesystem::path>(folder), reuse});
    EXPECT_EQ(cache.store() != nullptr, is_stored);
    cache.reference(kPicture).render(scene_, request_of(kPicture), progress_);
    return cache.take_reused();
  }

  /// Identity of the device called `found`.
  std::string open_device(const std::string& found, bool is_drawn) {
    LazyStore store(folder_.path());
    const auto open = [this] {
      ++opened_;
      return std::make_unique<FakeRenderer>(fake_realtime());
    };
    LazyRealtime realtime(store, {"", open, [&](const Renderer&) { return found; }});
    if (is_drawn) realtime.renderer().render(scene_, request_of(kPicture), progress_);
    realtime.keep_identity();
    return realtime.identity();
  }

  TemporaryFolder folder_;
  SilentProgress progress_;
  Scene scene_ = fake_scene("plate").scene;
  int opened_ = 0;
};

TEST_F(VerbCacheTest, OpensTheTracerOnceForTheSameTruth) {
  EXPECT_EQ(render_truth().count, 0u);
  EXPECT_EQ(render_truth().count, 1u);
  EXPECT_EQ(opened_, 1);
}

TEST_F(VerbCacheTest, FindsNothingWithoutReuse) {
  render_truth();
  EXPECT_EQ(render_truth(false).count, 0u);
  EXPECT_EQ(opened_, 2);
}

TEST_F(VerbCacheTest, RemembersNothingWithoutAFolder) {
  render_truth(true, false);
  EXPECT_EQ(render_truth(true, false).count, 0u);
  EXPECT_EQ(opened_, 2);
}

TEST_F(VerbCacheTest, KnowsADeviceWithoutOpeningIt) {
  EXPECT_EQ(open_device("one", false), "one");
  EXPECT_EQ(opened_, 1);
  EXPECT_EQ(open_device("one", false), "one");
  EXPECT_EQ(opened_, 1);
}

TEST_F(VerbCacheTest, RefusesAnotherDeviceThanWasRemembered) {
  open_device("one", false);
  try {
    open_device("two", true);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::environment);
    EXPECT_NE(std::string(error.what()).find("is 'two' now, and was 'one'"), std::string::npos);
  }
  EXPECT_EQ(open_device("two", true), "two");
}

}  // namespace
}  // namespace umbrameter
