// SPDX-License-Identifier: Apache-2.0
// Without these tests bad input could crash, hang, pass silently, leave half a file, or end in a message that
// helps nobody.

#include "tests/cli/cli_fixture.h"

#include <gmock/gmock.h>

namespace umbrameter {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class BadInput : public CliTest {
 protected:
  /// `reference` on `scene` fails with `part` and leaves nothing but the scene's own files.
  void expect_rejected(const std::string& scene, const std::string& part) const {
    const std::vector<std::string> before = files();
    expect_bad_input(umbrameter({"reference", scene, "-o", "made/ref.exr", "--width", "16", "--height", "9",
                                 "--spp", "8"}),
                     part);
    EXPECT_EQ(files(), before);
  }

  void expect_mesh_rejected(const std::string& obj, const std::string& part) const {
    write("mesh.obj", obj);
    write_scene("scene.toml", "[[mesh]]\nfile = \"mesh.obj\"\n");
    expect_rejected("scene.toml", part);
  }
};

TEST_F(BadInput, UsageErrorsNameTheArgument) {
  expect_bad_input(umbrameter({}), "subcommand is required");
  expect_bad_input(umbrameter({"validat"}), "unknown command 'validat' (did you mean 'validate'?)");
  expect_bad_input(umbrameter({"validate", "--qualty", "quick"}), "--qualty");
  expect_bad_input(umbrameter({"validate", "--width", "many"}), "--width");
  expect_bad_input(umbrameter({"render", "plate"}), "--technique is required");
  expect_bad_input(umbrameter({"validate", "--quality", "quik"}),
                   "unknown quality 'quik' (did you mean 'quick'?)");
}

TEST_F(BadInput, ResolutionAndSampleCountsHaveLimits) {
  expect_bad_input(umbrameter({"reference", "plate", "--width", "0"}), "--width is 0, not in 1 to 16384");
  expect_bad_input(umbrameter({"reference", "plate", "--height", "-4"}), "--height is -4");
  expect_bad_input(umbrameter({"reference", "plate", "--width", "999999"}), "--width is 999999");
  expect_bad_input(umbrameter({"validate", "plate", "--width", "16384", "--height", "16384"}),
                   "268435456 pixels, more than");
  expect_bad_input(umbrameter({"reference", "plate", "--spp", "0"}), "--spp is 0");
  expect_bad_input(umbrameter({"reference", "plate", "--target-se", "0"}),
                   "--target-se is 0, not between 0 and 1");
  expect_bad_input(umbrameter({"reference", "plate", "--target-se", "nan"}), "--target-se is nan");
}

TEST_F(BadInput, UnknownNamesGetTheNearestOne) {
  expect_rejected("plaet", "did you mean 'plate'?");
  expect_bad_input(umbrameter({"render", "plate", "--technique", "pcs"}), "did you mean 'pcss'?");
  expect_bad_input(umbrameter({"techniques", "show", "acumulate"}), "did you mean 'accumulate'?");
  expect_bad_input(umbrameter({"render", "plate", "--technique", "pcf:map_sise=512"}),
                   "did you mean 'map_size'?");
  expect_bad_input(umbrameter({"render", "plate", "--technique", "hard:preset=hihg"}),
                   "did you mean 'high'?");
}

TEST_F(BadInput, ParametersMustBeInRangeAndGivenOnce) {
  expect_bad_input(umbrameter({"render", "plate", "--technique", "hard:map_size=0"}), "map_size");
  expect_bad_input(umbrameter({"render", "plate", "--technique", "hard", "--set", "map_size"}), "map_size");
  expect_bad_input(
      umbrameter({"render", "plate", "--technique", "hard:map_size=512", "--set", "map_size=512"}),
      "parameter 'map_size' of 'hard' is given twice");
  expect_bad_input(umbrameter({"validate", "plate", "--technique", "hard", "--technique", "hard"}),
                   "technique 'hard' is given twice");
}

TEST_F(BadInput, MissingFiles) {
  expect_rejected("no/such.toml", "no/such.toml");
  expect_bad_input(umbrameter({"score", "none.exr", "--reference", "ref.exr"}), "none.exr");
  expect_bad_input(umbrameter({"report", "nowhere"}), "nowhere/results.json");
  expect_bad_input(umbrameter({"scene", "list", "--assets", "nowhere"}),
                   "the assets folder 'nowhere' is not there");
  write_scene("scene.toml", "[[mesh]]\nfile = \"missing.obj\"\n");
  expect_rejected("scene.toml", "scene.toml:18:8: ");
}

TEST_F(BadInput, SceneFilesAreCheckedKeyByKey) {
  write_scene("scene.toml", "scael = 2\n");
  expect_rejected("scene.toml",
                  "scene.toml:17:9: [[mesh]] has an unknown key 'scael' (did you mean 'scale'?)");
  write_scene("scene.toml", "scale = \"big\"\n");
  expect_rejected("scene.toml", "scene.toml:17:9: ");
  write_scene("scene.toml", "scale = nan\n");
  expect_rejected("scene.toml", "not a finite number");
  write("scene.toml", "title = \"unfinished");
  expect_rejected("scene.toml", "scene.toml:1:");
}

TEST_F(BadInput, LightsAndCamerasMustMakeSense) {
  const std::string light =
      "[[light]]\nname = \"two\"\ntype = \"rect\"\ncenter = [0, 3, 0]\ndirection = [0, -1, 0]\n";
  write_scene("scene.toml", light + "size = [0, 1]\n");
  expect_rejected("scene.toml", "scene.toml:22:");
  write_scene("scene.toml", light + "size = [inf, 1]\n");
  expect_rejected("scene.toml", "scene.toml:22:");
  write("scene.toml", "[camera]\neye = [1, 1, 1]\nat = [1, 1, 1]\n");
  expect_rejected("scene.toml", "scene.toml:");
}

TEST_F(BadInput, ALightInsideGeometryIsAllowedAndWarned) {
  write_scene("scene.toml", "[[mesh]]\nshape = \"box\"\nsize = [3, 3, 3]\ntranslate = [0, 2.5, 0]\n");
  const ProcessResult result = umbrameter({"scene", "check", "scene.toml"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("scene: warning: "));
}

TEST_F(BadInput, MeshesAreCheckedLineByLine) {
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 0 1\n";
  expect_mesh_rejected(corners + "f 1 2 4\n", "mesh.obj:4:");
  expect_mesh_rejected(corners + "v nan 0 0\nf 1 2 3\n", "mesh.obj:4:");
  expect_mesh_rejected(corners + "v inf 0 0\nf 1 2 3\n", "mesh.obj:4:");
  expect_mesh_rejected(corners, "mesh.obj");
  expect_mesh_rejected("", "mesh.obj");
  expect_mesh_rejected("v 0 0 0\nv 1 0 0\nv 0 0", "mesh.obj:3:");
}

TEST_F(BadInput, TruncatedZstdIsFound) {
  write("mesh.obj.zst", std::string_view("\x28\xb5\x2f\xfd\x04\x00\x11", 7));
  write_scene("scene.toml", "[[mesh]]\nfile = \"mesh.obj.zst\"\n");
  expect_rejected("scene.toml", "mesh.obj.zst: the zstd data ");
}

TEST_F(BadInput, TruncatedImagesAreFound) {
  ASSERT_EQ(umbrameter({"reference", "plate", "--width", "64", "--height", "36", "--spp", "8"}).exit_code, 0);
  const auto whole = folder() / "reference.exr";
  std::filesystem::copy_file(whole, folder() / "half.exr");
  std::filesystem::resize_file(folder() / "half.exr", std::filesystem::file_size(whole) / 2);
  expect_bad_input(umbrameter({"score", "half.exr", "--reference", "reference.exr"}), "half.exr");
  expect_bad_input(umbrameter({"score", "reference.exr", "--reference", "half.exr"}), "half.exr");
  write("text.exr", "not an image");
  expect_bad_input(umbrameter({"score", "text.exr", "--reference", "reference.exr"}), "text.exr");
}

TEST_F(BadInput, UnwritableOutputIsFoundBeforeRendering) {
  write("file", "");
  // The reference at full quality would take minutes.
  const ProcessOptions soon{.timeout_s = 20};
  expect_bad_input(umbrameter({"reference", "plate", "--quality", "full", "-o", "file/ref.exr"}, soon),
                   "file");
  expect_bad_input(umbrameter({"reference", "plate", "--quality", "full", "-o", "ref.png"}, soon),
                   "the output 'ref.png' does not end in '.exr'");
  expect_bad_input(umbrameter({"reference", "plate", "--quality", "full", "-o", "/proc/ref.exr"}, soon),
                   "/proc");
  expect_bad_input(umbrameter({"validate", "plate", "--quality", "full", "--out", "file"}, soon),
                   "the output 'file' is not a folder");
  EXPECT_THAT(files(), ElementsAre("file"));
}

TEST_F(BadInput, ValidateDoesNotReplaceAnImagesFolderThatIsNotItsOwn) {
  std::filesystem::create_directories(folder() / "out/images");
  write("out/images/holiday.png", "mine");
  expect_bad_input(umbrameter({"validate", "plate"}), "is not of an earlier validation");
  EXPECT_TRUE(std::filesystem::exists(folder() / "out/images/holiday.png"));
}

TEST_F(BadInput, ResultsOfAnotherMakeAreRejected) {
  std::filesystem::create_directory(folder() / "old");
  write("old/results.json", "{\"schema\": 99}");
  expect_bad_input(umbrameter({"report", "old"}), "results of schema 99");
  EXPECT_FALSE(std::filesystem::exists(folder() / "old/report.html"));
}

}  // namespace
}  // namespace umbrameter
