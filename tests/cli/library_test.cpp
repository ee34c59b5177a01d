// SPDX-License-Identifier: Apache-2.0
// Without these a scene of the library could stop loading, stop agreeing between the renderers, or lose a
// technique. The real models are found through UMBRAMETER_ASSETS; without it their tests are skipped.

#include "tests/cli/cli_fixture.h"
#include "tests/support/source_dir.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <fstream>

namespace umbrameter {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const fs::path kLibrary = source_dir() / "scenes/library";
constexpr int kPatience_s = 1500;

std::vector<std::string> scene_names(const fs::path& folder) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

/// A scene of several lights gives one result per light.
size_t light_count(const fs::path& scene_file) {
  std::ifstream file(scene_file);
  size_t count = 0;
  for (std::string line; std::getline(file, line);)
    count += line.starts_with("[[light]]") || line.starts_with("[light]") ? 1 : 0;
  return count;
}

/// Every scene was compared, agrees in at least 99.5 % of its covered pixels, and every technique has its
/// error or is listed as skipped.
void expect_all_measured(const Json& results, size_t view_count) {
  ASSERT_EQ(results["scenes"].size(), view_count);
  for (const Json& scene : results["scenes"]) {
    ASSERT_TRUE(scene["parity"].is_object()) << scene["name"];
    EXPECT_GE(scene["parity"]["agreement"].get<double>(), 0.995) << scene["name"];
    for (const Json& run : scene["techniques"]) {
      ASSERT_TRUE(run["error"].is_object()) << scene["name"] << ", " << run["label"];
      EXPECT_TRUE(run["error"]["rmse"]["value"].is_number()) << scene["name"] << ", " << run["label"];
    }
  }
}

class Library : public CliTest {
 protected:
  void SetUp() override { require_gl(); }

  Json validate(const std::vector<std::string>& given, const std::string& assets = {}) {
    std::vector<std::string> arguments{"validate", "--json"};
    arguments.insert(arguments.end(), given.begin(), given.end());
    if (!assets.empty()) {
      arguments.push_back("--assets");
      arguments.push_back(assets);
    }
    ProcessOptions options;
    options.timeout_s = kPatience_s;
    const ProcessResult result = umbrameter(arguments, options);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.exit_code == 0 ? Json::parse(result.out) : Json::object();
  }
};

TEST_F(Library, EveryBuiltInSceneIsMeasuredWithEveryTechnique) {
  const Json results = validate({"--width", "192", "--height", "108", "--spp", "64", "--frames", "0"});
  size_t view_count = 0;
  for (const std::string& scene : scene_names(kLibrary))
    view_count += light_count(kLibrary / (scene + ".toml"));
  expect_all_measured(results, view_count);
}

class Assets : public Library {
 protected:
  void SetUp() override {
    Library::SetUp();
    const char* folder = std::getenv("UMBRAMETER_ASSETS");
    if (folder == nullptr || *folder == '\0')
      GTEST_SKIP() << "UMBRAMETER_ASSETS does not name the real models";
    assets_ = folder;
  }
  std::string assets_;
};

class AssetScene : public Assets, public testing::WithParamInterface<std::string> {};

TEST_P(AssetScene, BothRenderersAgree) {
  const Json results = validate(
      {"assets/" + GetParam(), "--technique", "hard", "--quality", "quick", "--frames", "1"}, assets_);
  expect_all_measured(results, light_count(kLibrary / "assets" / (GetParam() + ".toml")));
}

INSTANTIATE_TEST_SUITE_P(EveryModel, AssetScene, testing::ValuesIn(scene_names(kLibrary / "assets")),
                         [](const auto& instance) { return instance.param; });

TEST_F(Assets, SponzaBunnyAndDragonAreMeasuredAt960x540) {
  const Json results =
      validate({"assets/crytek_sponza", "assets/bunny", "assets/dragon", "--technique", "hard", "--technique",
                "pcf", "--technique", "pcss", "--technique", "accumulate:light_samples=16", "--width", "960",
                "--height", "540", "--spp", "128", "--frames", "1"},
               assets_);
  expect_all_measured(results, 3);
  for (const Json& scene : results["scenes"]) {
    EXPECT_EQ(scene["techniques"].size(), 4u);
    EXPECT_LT(scene["techniques"][2]["error"]["rmse"]["value"],
              scene["techniques"][0]["error"]["rmse"]["value"])
        << scene["name"] << ": PCSS should be nearer to the truth than a hard shadow";
  }
}

}  // namespace
}  // namespace umbrameter
