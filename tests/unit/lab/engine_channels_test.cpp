// SPDX-License-Identifier: Apache-2.0
// Without these, a depth could be scored as visibility, and another renderer's picture or surfaces be overlooked.

#include "lab/pictures/engine_channels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace umbrameter {
namespace {

using testing::ElementsAre;

/// The one layer of `kind`; nothing when there are several or none.
std::optional<Layer> sole(const std::vector<std::string>& names, LayerKind kind) {
  std::optional<Layer> found;
  for (const Layer& layer : find_layers(names)) {
    if (layer.kind != kind) continue;
    if (found) return std::nullopt;
    found = layer;
  }
  return found;
}

TEST(EngineChannels, KnowBlendersLayers) {
  const std::vector<std::string> names = {
      "ViewLayer.Combined.R", "ViewLayer.Combined.G", "ViewLayer.Combined.B", "ViewLayer.Combined.A",
      "ViewLayer.Depth.Z",    "ViewLayer.Position.X", "ViewLayer.Position.Y", "ViewLayer.Position.Z",
      "ViewLayer.Normal.X",   "ViewLayer.Normal.Y",   "ViewLayer.Normal.Z"};
  EXPECT_THAT(sole(names, LayerKind::color).value().channels,
              ElementsAre("ViewLayer.Combined.R", "ViewLayer.Combined.G", "ViewLayer.Combined.B"));
  EXPECT_THAT(sole(names, LayerKind::position).value().channels,
              ElementsAre("ViewLayer.Position.X", "ViewLayer.Position.Y", "ViewLayer.Position.Z"));
  EXPECT_THAT(sole(names, LayerKind::normal).value().channels,
              ElementsAre("ViewLayer.Normal.X", "ViewLayer.Normal.Y", "ViewLayer.Normal.Z"));
  EXPECT_THAT(sole(names, LayerKind::depth).value().channels, ElementsAre("ViewLayer.Depth.Z"));
}

TEST(EngineChannels, KnowOtherRenderersNames) {
  const auto expect = [](const std::vector<std::string>& names, LayerKind kind) {
    EXPECT_TRUE(sole(names, kind)) << names.front();
  };
  expect({"pos.X", "pos.Y", "pos.Z"}, LayerKind::position);                  // Mitsuba
  expect({"dd.T"}, LayerKind::depth);                                        // Mitsuba
  expect({"sh_normal.X", "sh_normal.Y", "sh_normal.Z"}, LayerKind::normal);  // Mitsuba
  expect({"zdepth.red"}, LayerKind::depth);                                  // V-Ray
  expect({"normals.X", "normals.Y", "normals.Z"}, LayerKind::normal);        // V-Ray
  expect({"VRayNormals.R", "VRayNormals.G", "VRayNormals.B"}, LayerKind::normal);
  expect({"World Position.red", "World Position.green", "World Position.blue"}, LayerKind::position);
  expect({"P.X", "P.Y", "P.Z"}, LayerKind::position);  // Arnold, pbrt
  expect({"N.x", "N.y", "N.z"}, LayerKind::normal);
  expect({"Z"}, LayerKind::depth);
  expect({"R", "G", "B", "A"}, LayerKind::color);
  expect({"FinalImageMovieRenderQueue_WorldDepth.R"}, LayerKind::depth);  // Unreal
  expect({"posW.R", "posW.G", "posW.B", "posW.A"}, LayerKind::position);  // Falcor
  expect({"visibility"}, LayerKind::visibility);
  expect({"primitive_id"}, LayerKind::primitive_id);
  expect({"Y"}, LayerKind::grey);
}

TEST(EngineChannels, AlphaIsNoPicture) {
  EXPECT_TRUE(find_layers(std::vector<std::string>{"A"}).empty());
  EXPECT_EQ(find_layers(std::vector<std::string>{"Y", "A"}).size(), 1u);
}

TEST(EngineChannels, ANameChoosesAChannelOrALayer) {
  const std::vector<std::string> names = {"Z", "View.Combined.B", "View.Combined.G", "View.Combined.R"};
  EXPECT_THAT(layer_called("Z", names).value().channels, ElementsAre("Z"));
  EXPECT_THAT(layer_called("combined", names).value().channels,
              ElementsAre("View.Combined.R", "View.Combined.G", "View.Combined.B"));
  EXPECT_THAT(layer_called("View.Combined.G", names).value().channels, ElementsAre("View.Combined.G"));
  EXPECT_FALSE(layer_called("shadow", names));
}

TEST(EngineChannels, FramesOfCapturesSayWhatTheyHold) {
  EXPECT_EQ(kind_of_file_name("out/Mogwai.GBufferRaster.posW.0.exr"), LayerKind::position);
  EXPECT_EQ(kind_of_file_name("Mogwai.GBufferRaster.normW.12.exr"), LayerKind::normal);
  EXPECT_EQ(kind_of_file_name("scene_depth.exr"), LayerKind::depth);
  EXPECT_FALSE(kind_of_file_name("beauty.exr"));
  EXPECT_FALSE(kind_of_file_name("a.n.exr"));
}

}  // namespace
}  // namespace umbrameter
