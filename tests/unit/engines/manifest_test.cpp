// SPDX-License-Identifier: Apache-2.0
#include "engines/host/manifest.h"

#include "core/error.h"
#include "engines/host/placeholders.h"
#include "tests/support/engine_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace umbrameter {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class ManifestTest : public testing::Test {
 protected:
  Engine load() { return load_engine(folder_.path(), {folder_.engines(), folder_.work()}); }
  void expect_error(const std::string& manifest, const std::string& words) {
    folder_.write("engine.toml", manifest);
    EXPECT_THAT([&] { load(); }, testing::ThrowsMessage<Error>(HasSubstr(words)));
  }
  EngineFolder folder_;
};

TEST_F(ManifestTest, SaysWhatThereIs) {
  const Engine engine = load();
  EXPECT_EQ(engine.id, "tried");
  EXPECT_EQ(engine.form, EngineForm::adapter);
  EXPECT_EQ(engine.quantity, EngineQuantity::visibility);
  EXPECT_TRUE(engine.supports(LightType::sun));
  EXPECT_FALSE(engine.supports(LightType::disk));
  EXPECT_EQ(engine.lights.at(LightType::rect), "a point");
  ASSERT_EQ(engine.parameters.size(), 2u);
  EXPECT_EQ(engine.parameters[1].name, "shadow.grey");
  EXPECT_EQ(engine.parameters[1].stage, ParameterStage::host);
  EXPECT_EQ(engine.limits.picture_s, 4.0);
  EXPECT_EQ(engine.limits.memory_bytes, uint64_t{300} << 20);
}

TEST_F(ManifestTest, HashSeesEveryFileAndWhatItDependsOn) {
  const std::string before = load().hash;
  folder_.write("page/adapter.js", "1");
  const std::string with_page = load().hash;
  EXPECT_NE(before, with_page);
  folder_.write("../shared.js", "1");
  folder_.write("engine.toml", engine_manifest_with("adapter = [\"x\"]\ndepends = [\"../shared.js\"]\n"));
  const std::string depends = load().hash;
  folder_.write("../shared.js", "2");
  EXPECT_NE(load().hash, depends);
}

TEST_F(ManifestTest, WhatIsMissingIsNamedWithAHint) {
  folder_.write("engine.toml",
                engine_manifest_with("adapter = [\"x\"]\nneeds = [\"{installed}/three/package.json\"]\n"));
  const Engine engine = load();
  ASSERT_EQ(engine.missing.size(), 1u);
  EXPECT_EQ(engine.missing[0], folder_.work() / "three/package.json");
  EXPECT_THAT([&] { require_installed(engine); },
              testing::ThrowsMessage<Error>(HasSubstr("scripts/install_engines.sh")));
}

TEST_F(ManifestTest, HasOneForm) {
  expect_error(engine_manifest_with(""), "not 0");
  expect_error(engine_manifest_with("adapter = [\"x\"]\ncommand = \"x {out}\"\n"), "not 2");
  expect_error(engine_manifest_with("lit = \"a.exr\"\n"), "'lit' and 'unlit' come as a pair");
  expect_error(engine_manifest_with("picture = \"a.exr\"\nlit = \"a.exr\"\nunlit = \"b.exr\"\n"),
               "'picture' stands alone");
  expect_error(engine_manifest_with("adapter = []\n"), "names no program");
}

TEST_F(ManifestTest, PlaceholdersAreChecked) {
  expect_error(engine_manifest_with("command = \"x {out} {shadow.gray}\"\n"), "did you mean 'shadow.grey'?");
  expect_error(engine_manifest_with("command = \"x {out\"\n"), "brace without its partner");
  expect_error(engine_manifest_with("command = \"x {scene}\"\n"), "neither {out} nor {lit} and {unlit}");
  expect_error(engine_manifest_with("command = \"x {lit}\"\n"), "neither {out} nor {lit} and {unlit}");
  expect_error(engine_manifest_with("picture = \"{scene}.exr\"\n"),
               "'{scene}' is neither a parameter nor known here");
}

TEST_F(ManifestTest, NamesWithAMeaningAreNoParameters) {
  expect_error(engine_manifest_with("adapter = [\"x\"]\n") +
                   "[[parameter]]\nname = \"seed\"\ntype = \"boolean\"\ndefault = true\ndoc = \"x\"\n",
               "cannot be called 'seed'");
  expect_error(engine_manifest_with("adapter = [\"x\"]\n") +
                   "[[parameter]]\nname = \"misbehave\"\ntype = \"boolean\"\ndefault = true\ndoc = \"x\"\n",
               "declared twice");
}

TEST_F(ManifestTest, UnknownKeysAndLimitsAreErrors) {
  expect_error(engine_manifest_with("adapter = [\"x\"]\ncolour = 1\n"), "colour");
  expect_error(engine_manifest_with("adapter = [\"x\"]\nmemory_mib = 0\n"), "'memory_mib' is 0, not above 0");
  expect_error(engine_manifest_with("adapter = [\"x\"]\n") + "[lights.round]\n", "round");
}

TEST_F(ManifestTest, FoundByIdAndByFolder) {
  const EnginePlaces places{folder_.engines(), folder_.work()};
  EXPECT_EQ(find_engine_folder("tried", places), folder_.path());
  EXPECT_EQ(find_engine_folder(folder_.path().string(), places), folder_.path());
  EXPECT_TRUE(find_engine_folder("pcf", places).empty());
  EXPECT_TRUE(find_engine_folder("..", places).empty());
  EXPECT_EQ(find_engine("tried", places)->id, "tried");
  EXPECT_FALSE(find_engine("pcf", places));
  EXPECT_FALSE(names_engine("picture.png", places));
  EXPECT_EQ(list_engines(places).size(), 1u);
}

TEST(Command, IsSplitAtBlanksAndQuotesHoldThem) {
  EXPECT_THAT(split_command("a  'b c' d\"e f\"g ''", {}), ElementsAre("a", "b c", "de fg", ""));
  EXPECT_THROW(split_command("a 'b", {}), Error);
  EXPECT_THROW(split_command("  ", {}), Error);
}

}  // namespace
}  // namespace umbrameter
