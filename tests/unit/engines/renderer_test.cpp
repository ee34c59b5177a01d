// SPDX-License-Identifier: Apache-2.0
// Engines that behave and engines that do not: every misbehaviour is one failed request with the engine's last words.
#include "engines/engines.h"

#include "core/error.h"
#include "scenes/scene.h"
#include "tests/support/engine_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace umbrameter {
namespace {

using testing::HasSubstr;

Scene triangle() {
  Scene scene;
  scene.name = "../triangle";
  scene.lights.push_back({.name = "lamp", .center_world = {0, 2, 0}, .size_world = {1, 1}});
  scene.positions_world = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
  scene.triangles = {{0, 1, 2}};
  scene.parts = {{"all", 0, 1}};
  return scene;
}

class EngineRendererTest : public testing::Test {
 protected:
  Renderer& renderer() {
    if (!renderer_) renderer_ = make_engine_renderer({{folder_.engines(), folder_.work()}, folder_.work()});
    return *renderer_;
  }
  Frame render(const std::string& misbehave = "no", double grey = 0.5) {
    return renderer().render(triangle(),
                             {.width_px = 7,
                              .height_px = 5,
                              .seed = 11,
                              .technique = "tried",
                              .parameters = {{"misbehave", misbehave}, {"shadow.grey", grey}}},
                             progress_);
  }
  PreparedRun prepare(const std::string& misbehave = "no") {
    static const Scene scene = triangle();
    return renderer().prepare(scene,
                              {.width_px = 7,
                               .height_px = 5,
                               .technique = "tried",
                               .parameters = {{"misbehave", misbehave}, {"shadow.grey", 0.5}}},
                              progress_);
  }
  /// The error's kind and words; the next request must work again.
  std::pair<ErrorKind, std::string> failure(const std::string& misbehave) {
    std::pair<ErrorKind, std::string> found{ErrorKind::internal, "no error"};
    try {
      render(misbehave);
    } catch (const Error& error) {
      found = {error.kind(), error.what()};
    }
    EXPECT_EQ(render("no", 0.25).image.plane("visibility")[3], 0.25f) << misbehave;
    return found;
  }
  void expect_failure(const std::string& misbehave, const std::string& words,
                      ErrorKind kind = ErrorKind::environment) {
    const auto [found, text] = failure(misbehave);
    EXPECT_EQ(found, kind) << misbehave;
    EXPECT_THAT(text, HasSubstr("engine 'tried': ")) << misbehave;
    EXPECT_THAT(text, HasSubstr(words)) << misbehave;
  }

  EngineFolder folder_;
  SilentProgress progress_;
  std::unique_ptr<Renderer> renderer_;
};

TEST_F(EngineRendererTest, AnAdapterIsStartedOnceAndAskedOften) {
  const Frame frame = render();
  EXPECT_EQ(frame.image.width, 7);
  EXPECT_EQ(frame.image.height, 5);
  for (const float v : frame.image.plane("visibility")) EXPECT_EQ(v, 0.5f);
  EXPECT_EQ(frame.device, "test engine 1.2, no device");
  EXPECT_TRUE(frame.is_software);
  EXPECT_EQ(frame.memory_bytes, 4096u);
  EXPECT_EQ(frame.warnings, std::vector<std::string>{"seed 11"});
  EXPECT_FALSE(frame.image.has("position.x"));
  EXPECT_EQ(render("no", 0.125).image.plane("visibility")[0], 0.125f);
  size_t working_folders = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_.work())) {
    if (entry.path().filename().string().starts_with("engine-")) ++working_folders;
    EXPECT_FALSE(entry.path().filename().string().starts_with("out-")) << entry.path();
  }
  EXPECT_EQ(working_folders, 1u);
}

TEST_F(EngineRendererTest, RowZeroIsOnTop) {
  const Image image = render("rows").image;
  EXPECT_FLOAT_EQ(image.plane("visibility")[0], 4.0f / 5.0f);  // the file's last row
  EXPECT_FLOAT_EQ(image.plane("visibility")[4 * 7], 0.0f);
}

TEST_F(EngineRendererTest, APairIsARatioAndIsUnknownWithoutLightOrWithMoreThanAll) {
  const Frame frame = render("pair");
  const auto v = frame.image.plane("visibility"), known = frame.image.plane("known");
  int unknown = 0;
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 7; ++x) {
      const int in_file = (4 - y) * 7 + x;
      const auto i = static_cast<size_t>(y * 7 + x);
      EXPECT_EQ(known[i], in_file % 5 == 0 ? 0.0f : 1.0f);
      if (in_file % 5 == 0)
        ++unknown;
      else
        EXPECT_FLOAT_EQ(v[i], 0.5f * static_cast<float>(in_file % 3));
    }
  }
  EXPECT_EQ(unknown, 7);
}

TEST_F(EngineRendererTest, WhatHangsIsEndedInTime) {
  expect_failure("hang", "'python3' took longer than 4 s");
}

TEST_F(EngineRendererTest, WhatEndsSaysHowAndItsLastWords) {
  expect_failure("crash", "'python3' ended with exit code 1; its last words: the driver is gone");
  expect_failure("signal", "was ended by signal 6");
  expect_failure("close", "closed its output; its last words: closing time");
}

TEST_F(EngineRendererTest, WhatTakesTooMuchMemoryIsEnded) {
  expect_failure("memory", "and 300 MiB are allowed");
}

TEST_F(EngineRendererTest, GarbageIsShown) {
  expect_failure("garbage", "the adapter wrote '<html>not JSON</html>', not an answer");
  expect_failure("long_line", "wrote a line of more than 1048576 bytes");
  expect_failure("other_id", "not the answer to request ");
  expect_failure("nothing", "neither a picture of visibility nor the pair");
}

TEST_F(EngineRendererTest, ItsOwnErrorIsPassedOn) {
  expect_failure("error", "this light has no shadow in the engine", ErrorKind::input);
}

TEST_F(EngineRendererTest, FilesMustBeWholeInPlaceAndOfTheSize) {
  expect_failure("escape", "'../scenes/v.pfm', which is no plain name");
  expect_failure("link", "'v.pfm' is no plain file");
  expect_failure("missing", "'v.pfm', which it did not write");
  expect_failure("size", "has 8 x 5 px, and 7 x 5 px were asked for");
  expect_failure("nan", "'v.pfm' is nan at pixel (0, 0)");
  expect_failure("half", "damaged or cut off");
}

TEST_F(EngineRendererTest, MuchChatterBlocksNobody) {
  EXPECT_EQ(render("chatter").image.plane("visibility")[0], 0.5f);
}

TEST_F(EngineRendererTest, WhatDoesNotStartIsTriedThreeTimes) {
  folder_.write("start.txt", "fail");
  for (int i = 0; i < 3; ++i)
    EXPECT_THAT([&] { render(); }, testing::ThrowsMessage<Error>(HasSubstr("no such device")));
  EXPECT_THAT([&] { render(); }, testing::ThrowsMessage<Error>(HasSubstr("did not start 3 times in a row")));
}

TEST_F(EngineRendererTest, AnErrorBeforeReadyIsPassedOn) {
  folder_.write("start.txt", "error");
  EXPECT_THAT([&] { render(); },
              testing::ThrowsMessage<Error>(HasSubstr("engine 'tried': WebGL2 is not there")));
}

TEST_F(EngineRendererTest, AStartThatHangsIsEnded) {
  folder_.write("start.txt", "hang");
  std::string manifest = test_engine_manifest();
  manifest.replace(manifest.find("seconds_to_start = 20"), 21, "seconds_to_start = 1");
  folder_.write("engine.toml", manifest);
  EXPECT_THAT([&] { render(); }, testing::ThrowsMessage<Error>(HasSubstr("took longer than 1 s")));
}

TEST_F(EngineRendererTest, AProgramThatIsNotThereIsNamed) {
  folder_.write("engine.toml", engine_manifest_with("adapter = [\"/no/such/program\"]\n"));
  EXPECT_THAT([&] { render(); },
              testing::ThrowsMessage<Error>(HasSubstr("'/no/such/program' cannot be started: No such file")));
}

TEST_F(EngineRendererTest, ACommandGetsValuesAsArgumentsAndNoShellSeesThem) {
  // The parameter is a choice with everything in it that a shell would act on.
  const std::string copy =
      "command = \"python3 -c \\\"import sys, os; "
      "assert sys.argv[1] == '$(touch {name}); *', sys.argv; "
      "assert os.listdir(sys.argv[3]); "
      "open(sys.argv[2].replace('.exr', '.txt'), 'w')\\\" '$(touch {name}); *' {out} {scene}\"\n";
  folder_.write("engine.toml", engine_manifest_with(copy));
  // It writes no picture: that is what is said, and not that the assertion failed.
  EXPECT_THAT([&] { render(); },
              testing::ThrowsMessage<Error>(HasSubstr("neither a picture of visibility nor")));
}

TEST_F(EngineRendererTest, ACommandThatFailsSaysItsLastWords) {
  folder_.write(
      "engine.toml",
      engine_manifest_with(
          "command = \"python3 -c 'import sys; sys.exit(sys.argv[2])' {out} 'no {shadow.grey} today'\"\n"));
  EXPECT_THAT([&] { render(); }, testing::ThrowsMessage<Error>(
                                     HasSubstr("ended with exit code 1; its last words: no 0.5 today")));
}

TEST_F(EngineRendererTest, FinishedPicturesAreChosenByNameAndParameter) {
  const std::string pixels(7 * 5 * 4, '\0');
  folder_.write("-triangle-no.pfm", "Pf\n7 5\n-1.0\n" + pixels);
  folder_.write("engine.toml", engine_manifest_with("picture = \"{name}-{misbehave}.pfm\"\n"));
  EXPECT_EQ(render().image.plane("visibility")[0], 0.0f);  // "../triangle" became a plain name
  EXPECT_THAT([&] { render("nan"); }, testing::ThrowsMessage<Error>(HasSubstr("there is no picture")));
}

TEST_F(EngineRendererTest, FinishedPicturesLieInTheFolder) {
  folder_.write("engine.toml", engine_manifest_with("picture = \"../{name}.pfm\"\n"));
  EXPECT_THAT([&] { render(); }, testing::ThrowsMessage<Error>(HasSubstr("outside of the engine's folder")));
}

TEST_F(EngineRendererTest, CutOutsAreRefused) {
  Scene scene = triangle();
  scene.cutouts.edit().push_back({});
  EXPECT_THAT(
      [&] {
        renderer().render(scene, {.width_px = 7, .height_px = 5, .technique = "tried", .parameters = {}},
                          progress_);
      },
      testing::ThrowsMessage<Error>(HasSubstr("gets no cut-outs: 1 of 1 triangles have holes")));
}

TEST_F(EngineRendererTest, FramesAreTimedByTheEngineAndAskedForAgain) {
  const PreparedRun run = prepare();
  ASSERT_TRUE(run.time_frame);
  EXPECT_EQ(run.timer, "a clock");
  EXPECT_THAT(run.passes, testing::ElementsAre("frame"));
  for (int i = 0; i < 7; ++i) EXPECT_THAT(run.time_frame(), testing::ElementsAre(2.5)) << i;
}

TEST_F(EngineRendererTest, TimesThatAreNoneAreAnError) {
  EXPECT_THAT([&] { prepare("no_times"); }, testing::ThrowsMessage<Error>(HasSubstr("not times of frames")));
}

TEST_F(EngineRendererTest, APictureOfIrradianceSaysSo) {
  std::string manifest = test_engine_manifest();
  manifest.replace(manifest.find("\"visibility\""), 12, "\"irradiance\"");
  folder_.write("engine.toml", manifest);
  const Frame frame = render();
  EXPECT_EQ(frame.image.metadata.at("quantity"), "irradiance");
  EXPECT_THAT(frame.warnings, testing::Contains(HasSubstr("compared as irradiance ratio S")));
}

TEST_F(EngineRendererTest, LightsThatAreNotSupportedAreRefused) {
  Scene scene = triangle();
  scene.lights[0].type = LightType::disk;
  EXPECT_THAT(
      [&] {
        renderer().render(scene, {.width_px = 7, .height_px = 5, .technique = "tried", .parameters = {}},
                          progress_);
      },
      testing::ThrowsMessage<Error>(HasSubstr("does not support disk lights (it supports rect, sun)")));
}

}  // namespace
}  // namespace umbrameter
