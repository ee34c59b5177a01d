// SPDX-License-Identifier: Apache-2.0
// Compute passes and storage buffers: what a manifest may say of them, and what becomes of slips.

#include "tests/unit/realtime/whole_manifest.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace umbrameter {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string kBuffer =
    "[[resource]]\nname = \"counts\"\nkind = \"buffer\"\nelement = \"uvec2\"\ncount = \"2 * taps\"\n\n";
const std::string kImage = "[[resource]]\nname = \"stored\"\nformat = \"r32f\"\nwidth = 4\nheight = 4\n\n";
const std::string kPass =
    "[[pass]]\nid = \"count\"\nkind = \"compute\"\ncompute = \"count.comp\"\ngroups = [\"ceil(screen.width / "
    "16)\", 1]\nreads = [\"gbuffer.position\"]\nwrites = [\"counts\"]\nclear = [4294967295, 0]\n\n";

/// whole_manifest() with a buffer that `pass` fills and the last pass reads.
std::string counting(const std::string& pass = kPass, const std::string& resources = kBuffer) {
  const std::string with_pass =
      replaced(whole_manifest(), "[[pass]]\nid = \"map\"", resources + pass + "[[pass]]\nid = \"map\"");
  return replaced(with_pass, "\"gbuffer.position\", \"shadow_map\"",
                  "\"gbuffer.position\", \"shadow_map\", \"counts\"");
}

std::string error_in(const std::string& manifest) {
  TechniqueFolder folder;
  folder.write("count.comp", "layout(local_size_x = 16) in; void main() { atomicAdd(counts[0].x, 1u); }");
  return error_of(folder, manifest);
}

std::string error_with(std::string_view from, std::string_view to) {
  return error_in(replaced(counting(), from, to));
}

TEST(ManifestCompute, SaysWhatRunsAndWhatIsShared) {
  TechniqueFolder folder;
  folder.write("count.comp", "layout(local_size_x = 16) in; void main() {}");
  const Technique technique = load(folder, counting());
  ASSERT_EQ(technique.buffers.size(), 1u);
  EXPECT_EQ(technique.buffers[0].element->glsl, "uvec2");
  EXPECT_EQ(technique.buffers[0].element->bytes(), 8u);
  EXPECT_EQ(technique.buffers[0].count.evaluate({{"taps", 3.0}}), 6.0);
  EXPECT_EQ(technique.resources.size(), 1u);
  const PassDeclaration& pass = technique.passes.front();
  EXPECT_EQ(pass.kind, PassKind::compute);
  ASSERT_EQ(pass.groups.size(), 2u);
  EXPECT_EQ(pass.groups[0].evaluate({{"screen.width", 17.0}}), 2.0);
  EXPECT_FALSE(pass.overwrites);
}

TEST(ManifestCompute, ClearsToWhatComponentsHold) {
  for (const std::string value : {"-1", "0.5", "4294967296"}) {
    EXPECT_THAT(error_with("clear = [4294967295, 0]", "clear = [" + value + "]"),
                AllOf(HasSubstr("technique.toml:"), HasSubstr("clears 'counts' to " + value),
                      HasSubstr("whole numbers from 0 to 4294967295")));
  }
  EXPECT_THAT(error_with("clear = [4294967295, 0]", "clear = [1, 2, 3]"),
              HasSubstr("clears with 3 numbers what has 2"));
  EXPECT_THAT(error_with("clear = [4294967295, 0]", "clear = [1]\noverwrites = true"),
              HasSubstr("clears what its shader overwrites"));
  const std::string integers = replaced(counting(), "element = \"uvec2\"", "element = \"ivec2\"");
  EXPECT_EQ(error_in(replaced(integers, "clear = [4294967295, 0]", "clear = [-2147483648, 7]")), "no error");
  EXPECT_THAT(error_in(integers), HasSubstr("to 4294967295, which its integers cannot hold"));
}

TEST(ManifestCompute, BuffersHaveElementsOfAKindAndACount) {
  EXPECT_THAT(
      error_with("element = \"uvec2\"", "element = \"uvec3\""),
      AllOf(HasSubstr("technique.toml:"), HasSubstr("unknown element type 'uvec3'"), HasSubstr("uvec2")));
  EXPECT_THAT(error_with("count = \"2 * taps\"\n", ""), HasSubstr("'count'"));
  EXPECT_THAT(error_with("count = \"2 * taps\"\n", "count = 4\nwidth = 4\n"),
              HasSubstr("unknown key 'width'"));
  EXPECT_THAT(error_with("kind = \"buffer\"", "kind = \"bufer\""), HasSubstr("buffer"));
}

TEST(ManifestCompute, BuffersAreReadAfterTheyAreWritten) {
  EXPECT_THAT(error_in(counting("", kBuffer)), HasSubstr("reads 'counts', which no earlier pass writes"));
  EXPECT_THAT(error_in(replaced(counting(), "\"shadow_map\", \"counts\"", "\"shadow_map\"")),
              HasSubstr("buffer 'counts' is never read"));
  EXPECT_THAT(error_with("reads = [\"gbuffer.position\"]\nwrites = [\"counts\"]",
                         "reads = [\"counts\"]\nwrites = [\"counts\"]"),
              HasSubstr("reads and writes 'counts' (leave it out of 'reads'"));
}

TEST(ManifestCompute, PassesWriteSomethingAndSayWhatTheyFind) {
  EXPECT_THAT(error_with("writes = [\"counts\"]\nclear = [4294967295, 0]", "writes = []"),
              AllOf(HasSubstr("technique.toml:"), HasSubstr("pass 'count' writes nothing")));
  EXPECT_THAT(
      error_with("clear = [4294967295, 0]\n", ""),
      AllOf(HasSubstr("stores into 'counts' before anything is in it"), HasSubstr("overwrites = true")));
  EXPECT_EQ(error_with("clear = [4294967295, 0]\n", "overwrites = true\n"), "no error");
  EXPECT_THAT(error_with("groups = [\"ceil(screen.width / 16)\", 1]", "groups = []"),
              HasSubstr("'groups' has 0 entries (work groups along x, y and z"));
  EXPECT_THAT(error_with("groups = [\"ceil(screen.width / 16)\", 1]", "groups = [1, 1, 1, 1]"),
              HasSubstr("'groups' has 4 entries"));
  EXPECT_THAT(error_with("compute = \"count.comp\"", "compute = \"cuont.comp\""),
              HasSubstr("shader file 'cuont.comp' is missing"));
  EXPECT_THAT(error_with("writes = [\"counts\"]", "writes = [\"counts\"]\nwrite_layer = 1"),
              HasSubstr("unknown key 'write_layer'"));
  EXPECT_THAT(error_with("writes = [\"counts\"]", "writes = [\"counts\"]\nfragment = \"resolve.frag\""),
              HasSubstr("unknown key 'fragment'"));
}

TEST(ManifestCompute, ImagesHaveFormatsThatStoresKnow) {
  const std::string storing = replaced(kPass, "writes = [\"counts\"]", "writes = [\"counts\", \"stored\"]");
  const auto error_of_image = [&](const std::string& image) {
    const std::string manifest = counting(storing, kBuffer + image);
    return error_in(
        replaced(manifest, "\"shadow_map\", \"counts\"", "\"shadow_map\", \"counts\", \"stored\""));
  };
  EXPECT_EQ(error_of_image(kImage), "no error");
  EXPECT_THAT(error_of_image(replaced(kImage, "r32f", "depth32f")),
              AllOf(HasSubstr("stores into 'stored' of the format depth32f"), HasSubstr("take r32f")));
  EXPECT_THAT(error_of_image(replaced(kImage, "width = 4", "samples = 4\nwidth = 4")),
              HasSubstr("stores into 'stored', which is multisampled"));
}

TEST(ManifestCompute, OtherPassesOnlyReadBuffers) {
  EXPECT_THAT(
      error_in(replaced(counting(), "writes = [\"visibility\"]", "writes = [\"visibility\", \"counts\"]")),
      HasSubstr("reads and writes 'counts'"));
  EXPECT_THAT(
      error_in(replaced(counting(), "writes = [\"shadow_map\"]", "writes = [\"shadow_map\", \"counts\"]")),
      AllOf(HasSubstr("pass 'map' writes 'counts', which is a buffer"), HasSubstr("compute")));
}

TEST(ManifestCompute, ABufferHasItsNamesForItself) {
  EXPECT_THAT(error_in(counting(kPass, kBuffer + replaced(kImage, "\"stored\"", "\"counts\""))),
              HasSubstr("uses the name 'counts', which"));
}

}  // namespace
}  // namespace umbrameter
