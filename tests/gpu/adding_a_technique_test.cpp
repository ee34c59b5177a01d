// SPDX-License-Identifier: Apache-2.0
// docs/adding-a-technique.md is followed word for word: were it wrong, the first thing a user tries would
// fail.

#include "core/error.h"
#include "tests/gpu/technique_fixture.h"
#include "tests/support/source_dir.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

namespace umbrameter {
namespace {

using namespace test;
namespace fs = std::filesystem;

/// The document's files: each fenced block after a line "<!-- file: NAME -->".
std::map<std::string, std::string> files_of_document() {
  std::ifstream document(source_dir() / "docs/adding-a-technique.md");
  const std::string mark = "<!-- file: ";
  std::map<std::string, std::string> files;
  for (std::string line; std::getline(document, line);) {
    if (!line.starts_with(mark)) continue;
    std::string& text = files[line.substr(mark.size(), line.find(" -->") - mark.size())];
    std::getline(document, line);  // the opening fence
    while (std::getline(document, line) && line != "```") text += line + "\n";
  }
  return files;
}

/// The walk-through's folder, outside the repository.
class AddingATechnique : public testing::Test {
 protected:
  void SetUp() override {
    UMBRAMETER_REQUIRE_GL();
    for (const auto& [name, text] : files_of_document()) write(name, text);
  }
  void write(const std::string& name, const std::string& text) const {
    fs::create_directories(path());
    std::ofstream(path() / name) << text;
  }
  fs::path path() const { return folder_.path() / "disk-filter"; }
  std::string technique() const { return path().string(); }

 private:
  TemporaryFolder folder_;
};

TEST_F(AddingATechnique, the_document_makes_the_three_files_it_promises) {
  EXPECT_TRUE(fs::exists(path() / "technique.toml"));
  EXPECT_TRUE(fs::exists(path() / "disk_filter.frag"));
  EXPECT_TRUE(fs::exists(path() / "README.md"));
}

TEST_F(AddingATechnique, a_disk_of_no_radius_is_the_hard_shadow) {
  const Scene scene = plate_scene();
  EXPECT_EQ(visibility(scene, technique(), {{"radius_world", 0.0}}), visibility(scene, "hard"));
}

TEST_F(AddingATechnique, a_disk_filter_softens_the_half_plane_by_its_radius) {
  // A disk of radius R at the floor crosses the hard edge: its lit share is that of a disk beyond x / R,
  // which is what a disk light gives whose penumbra is R to either side: radius R (4 - 1.5) / 1.5 under
  // height 4.
  constexpr double kRadius = 0.3;
  Light wide = light_at_4(LightType::disk, 2.0 * kRadius * (4.0 - 1.5) / 1.5);
  const ParameterValues values{
      {"radius_world", kRadius}, {"taps", int64_t{256}}, {"map_size", int64_t{2048}}};
  const Frame frame = render(half_plane_scene(light_at_4(LightType::disk, 1.0)), technique(), values);
  const ErrorSummary error =
      floor_error(frame, [&](const glm::dvec3& p) { return half_plane_visibility(wide, p); });
  EXPECT_LE(error.rmse, 0.01);
}

TEST_F(AddingATechnique, a_misspelt_name_in_the_shader_is_reported_at_its_own_line) {
  std::string shader = files_of_document().at("disk_filter.frag");
  const size_t at = shader.find("return lit /");
  ASSERT_NE(at, std::string::npos);
  const auto line = std::count(shader.begin(), shader.begin() + static_cast<std::ptrdiff_t>(at), '\n') + 1;
  write("disk_filter.frag", shader.replace(at, 12, "return lid /"));
  try {
    visibility(plate_scene(), technique());
    FAIL() << "compiled";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_NE(std::string(error.what()).find("disk_filter.frag:" + std::to_string(line)), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace umbrameter
