// SPDX-License-Identifier: Apache-2.0
// Without this: some damaged scene file could crash the program, hang it, or be taken for our own bug.
#include "core/files.h"
#include "core/image_io.h"
#include "scene_text.h"
#include "scenes/obj/load_obj.h"
#include "tests/support/source_dir.h"
#include "tests/support/temporary_folder.h"

#include <cmath>
#include <fstream>
#include <random>

namespace umbrameter {
namespace {

const std::string kScene = R"(title = "all"
[camera]
eye = [0, 2, 5]
at = [0, 0, 0]
up = [0, 1, 0]
fov_deg = 40
near = 0.01
[[mesh]]
name = "floor"
shape = "plane"
size = [4, 4]
translate = [1, -2, 3.5]
rotate_deg = 30
axis = [1, 1, 0]
[[mesh]]
shape = "sphere"
radius = 1
segments = 8
smooth = true
scale = [1, 2, 3]
[[mesh]]
shape = "comb"
count = 3
period = 1.0
bar = 0.5
length = 2
up = "z"
[[light]]
name = "a"
type = "rect"
center = [0, 4, 0]
direction = [0, -1, 0]
size = [1, 1]
tangent = [1, 0, 0]
[[light]]
name = "b"
type = "sun"
direction = [0, -1, 0.5]
angular_diameter_deg = 1
)";

const std::string kObj =
    "o a\ng b c\nusemtl d\nv 0 0 0\nv 1 0 0.5e1\nv 0 1 0\nv -1 -1 2\nvn 0 0 1\nvt 0 0\n"
    "f 1 2 3\nf 1/1 2/1 3/1 4/1\nf 1//1 2//1 -1//-1\nf 1/1/1 2/1/1 3/1/1\ns off\nl 1 2\n";

/// Puts another number in the place of the first one after `at`: the mutation that gets past the parser.
void replace_number(std::string& text, size_t at, std::mt19937& random) {
  static const std::vector<std::string> kNumbers = {"0",   "-1",   "1e-9", "1e9",   "3",
                                                    "0.5", "-2.5", "180",  "1e300", "nan"};
  const size_t begin = text.find_first_of("0123456789", at);
  if (begin == std::string::npos) return;
  const size_t end = std::min(text.find_first_not_of("0123456789.", begin), text.size());
  text.replace(begin, end - begin, kNumbers[random() % kNumbers.size()]);
}

/// Changes, inserts, removes, doubles or moves one or two pieces of `text`.
std::string mutated(std::string text, std::mt19937& random) {
  static const std::vector<std::string> kPieces = {
      "nan", "inf", "-", "0", "1e300", "99999", "[",  "]",    "\"", "=",    "\n", "1e-9", "-1", "[[",
      "{",   "#",   ".", "/", "f ",    "v ",    "\r", "\xff", " ",  "true", ", ", "1e9",  "1"};
  const auto below = [&](size_t n) { return std::uniform_int_distribution<size_t>(0, n - 1)(random); };
  for (size_t change = below(2) + 1; change > 0; --change) {
    const size_t at = below(text.size() + 1);
    const size_t length = std::min(below(12), text.size() - at);
    switch (below(8)) {
      case 0:
        text.erase(at, length);
        break;
      case 1:
        text.insert(at, kPieces[below(kPieces.size())]);
        break;
      case 2:
        text.replace(at, length, kPieces[below(kPieces.size())]);
        break;
      case 3:
        text.insert(below(text.size() + 1), text.substr(at, length));
        break;
      case 4:
        if (at < text.size()) text[at] = static_cast<char>(below(256));
        break;
      default:
        replace_number(text, at, random);
    }
  }
  return text;
}

struct Outcome {
  int accepted = 0;
  int rejected = 0;
};

/// Runs `action`, which must return or throw Error{input}.
void count(Outcome& outcome, const std::string& text, const std::function<void()>& action) {
  try {
    action();
    ++outcome.accepted;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input) << error.what() << "\n" << text;
    ++outcome.rejected;
  } catch (const std::exception& error) {
    ADD_FAILURE() << "not our error: " << error.what() << "\n" << text;
  }
}

TEST(SceneFuzz, MutatedScenesLoadOrAreInputErrors) {
  std::mt19937 random(20240601);
  Outcome outcome;
  for (int i = 0; i < 6000 && !testing::Test::HasFailure(); ++i) {
    const std::string text = mutated(kScene, random);
    count(outcome, text, [&] {
      const Scene scene = parse_scene(text, "x.toml", {});
      EXPECT_FALSE(scene.triangles.empty());
      EXPECT_FALSE(scene.lights.empty());
      for (const glm::vec3& p : scene.positions_world) ASSERT_TRUE(std::isfinite(p.x + p.y + p.z)) << text;
      for (const glm::vec3& n : scene.normals_world) ASSERT_TRUE(std::isfinite(n.x + n.y + n.z)) << text;
    });
  }
  EXPECT_GT(outcome.accepted, 300) << "the mutations must reach past the parser";
  EXPECT_GT(outcome.rejected, 300);
}

TEST(SceneFuzz, MutatedObjFilesLoadOrAreInputErrors) {
  TemporaryFolder folder;
  std::mt19937 random(20240602);
  Outcome outcome;
  for (int i = 0; i < 4000 && !testing::Test::HasFailure(); ++i) {
    const std::string text = mutated(kObj, random);
    const std::filesystem::path file = folder.path() / fmt::format("{}.obj", i);
    std::ofstream(file, std::ios::binary) << text;  // thousands of safe writes would take long
    count(outcome, text, [&] {
      std::vector<std::string> warnings;
      const MeshData mesh = load_obj(file, {}, warnings);
      for (const glm::uvec3& t : mesh.triangles) {
        for (int corner = 0; corner < 3; ++corner) ASSERT_LT(t[corner], mesh.positions.size()) << text;
      }
    });
    std::filesystem::remove(file);
  }
  EXPECT_GT(outcome.accepted, 300);
  EXPECT_GT(outcome.rejected, 300);
}

/// The fuzz target's own example, with the files that it names; `name` ends as it does.
void expect_scenes_or_input_errors(const std::string& name, unsigned seed) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "mesh.obj")
      << "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n";
  write_png(folder.path() / "mask.png", 1, 2, std::vector<uint8_t>{255, 255, 255, 0, 0, 0});
  const std::string own = read_file(source_dir() / "fuzz/corpus" / name);
  const std::filesystem::path file = folder.path() / std::filesystem::path(name).filename();
  std::mt19937 random(seed);
  Outcome outcome;
  for (int i = 0; i < 1500 && !testing::Test::HasFailure(); ++i) {
    const std::string text = mutated(own, random);
    std::ofstream(file, std::ios::binary) << text;
    count(outcome, text, [&] {
      const Scene scene = load_scene(file, {});
      EXPECT_FALSE(scene.lights.empty());
      for (const glm::vec3& p : scene.positions_world) ASSERT_TRUE(std::isfinite(p.x + p.y + p.z)) << text;
    });
  }
  EXPECT_GT(outcome.accepted, 100) << "the mutations must reach past the parser";
  EXPECT_GT(outcome.rejected, 100);
}

TEST(SceneFuzz, MutatedMitsubaScenesLoadOrAreInputErrors) {
  expect_scenes_or_input_errors("mitsuba/room.xml", 20240603);
}

TEST(SceneFuzz, MutatedPbrtScenesLoadOrAreInputErrors) {
  expect_scenes_or_input_errors("pbrt/room.pbrt", 20240604);
}

}  // namespace
}  // namespace umbrameter
