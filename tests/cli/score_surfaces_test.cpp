// SPDX-License-Identifier: Apache-2.0
// Without these, the truth could be compared with itself under the name of another renderer's surfaces, and far planes,
// other axes and units could void a score without a hint.

#include "tests/cli/cli_fixture.h"

#include "core/image_io.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <functional>
#include <limits>
#include <sstream>

namespace umbrameter {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class ScoreSurfaces : public CliTest {
 protected:
  void SetUp() override {
    write_scene("plate.toml");
    for (const std::string seed : {"1", "2"}) {
      const ProcessResult result = umbrameter({"reference", "plate.toml", "--width", "96", "--height", "64",
                                               "--spp", "32", "--seed", seed, "-o", seed + ".exr"});
      ASSERT_EQ(result.exit_code, 0) << result.err;
    }
    truth_ = read_image(folder() / "1.exr");
    const Image other = read_image(folder() / "2.exr");
    Image picture(other.width, other.height);
    picture.planes["visibility"] = other.planes.at("visibility");
    write_exr(folder() / "v.exr", picture);
    for (size_t i = 0; i < truth_.pixel_count(); ++i) {
      const bool is_hit = truth_.plane("primitive_id")[i] >= 0.0f;
      (is_hit ? hits_ : misses_) += 1;
    }
    ASSERT_GT(hits_, 1000u);
    ASSERT_GT(misses_, 100u);  // else far planes could not be seen
  }

  /// Copies of the truth's channels under other names, each value through `change`.
  void write_layers(
      const std::string& file, const std::vector<std::pair<std::string, std::string>>& names,
      const std::function<float(float)>& change = [](float v) { return v; }) const {
    Image image(truth_.width, truth_.height);
    for (const auto& [to, from] : names) {
      for (const float v : truth_.plane(from)) image.planes[to].push_back(change(v));
    }
    write_exr(folder() / file, image);
  }

  /// Distance along each pixel's ray; `nothing` where nothing is hit.
  void write_depth(const std::string& file, float nothing, float unit = 1.0f) const {
    std::istringstream text(truth_.metadata.at("eye_world"));
    double x = 0.0, y = 0.0, z = 0.0;
    text >> x >> y >> z;
    Image image(truth_.width, truth_.height);
    const auto depth = image.add_plane("ViewLayer.Depth.Z");
    for (size_t i = 0; i < depth.size(); ++i) {
      const auto at = [&](const char* name) { return static_cast<double>(truth_.plane(name)[i]); };
      const double d = std::hypot(at("position.x") - x, at("position.y") - y, at("position.z") - z);
      depth[i] = truth_.plane("primitive_id")[i] < 0.0f ? nothing : unit * static_cast<float>(d);
    }
    write_exr(folder() / file, image);
  }

  ProcessResult score(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {"score",     "v.exr", "--reference", "1.exr",
                                          "--metrics", "error", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return umbrameter(arguments);
  }

  void expect_parity(const std::vector<std::string>& more) const {
    const ProcessResult result = score(more);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    ASSERT_FALSE(result.out.empty());
    const Json json = Json::parse(result.out);
    ASSERT_FALSE(json["parity"].is_null()) << result.err;
    EXPECT_TRUE(json["parity"]["passes"]);
    EXPECT_EQ(json["parity"]["covered"], hits_);
    EXPECT_EQ(json["error"]["scored_pixels"], json["scorable_pixels"]);
  }

  Image truth_;
  size_t hits_ = 0, misses_ = 0;
};

TEST_F(ScoreSurfaces, FarDepthsAreBackground) {
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float nothing : {0.0f, -1.0f, 1e10f, 1e30f, 65504.0f, infinity, 100.0f}) {
    write_depth("depth.exr", nothing);
    SCOPED_TRACE(nothing);
    expect_parity({"--surfaces", "depth.exr", "--depth", "ray", "--scene", "plate.toml"});
  }
}

TEST_F(ScoreSurfaces, DepthInAnotherUnitOrMeasureIsNamed) {
  write_depth("cm.exr", 1e10f, 100.0f);
  const ProcessResult result = score({"--surfaces", "cm.exr", "--depth", "ray", "--scene", "plate.toml"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("in centimetres: give --depth ray --unit 0.01"));
  expect_parity({"--surfaces", "cm.exr", "--depth", "ray", "--unit", "0.01", "--scene", "plate.toml"});
  write_depth("ray.exr", 1e10f);
  const ProcessResult axis = score({"--surfaces", "ray.exr", "--scene", "plate.toml"});
  EXPECT_EQ(axis.exit_code, 1);
  EXPECT_THAT(axis.err, HasSubstr("give --depth ray"));
}

TEST_F(ScoreSurfaces, NamesOfOtherRenderersAreRead) {
  write_layers("blender.exr", {{"ViewLayer.Position.X", "position.x"},
                               {"ViewLayer.Position.Y", "position.y"},
                               {"ViewLayer.Position.Z", "position.z"},
                               {"ViewLayer.Normal.X", "normal.x"},
                               {"ViewLayer.Normal.Y", "normal.y"},
                               {"ViewLayer.Normal.Z", "normal.z"}});
  expect_parity({"--surfaces", "blender.exr"});
  write_layers("posW.0.exr", {{"R", "position.x"}, {"G", "position.y"}, {"B", "position.z"}});
  expect_parity({"--surfaces", "posW.0.exr"});
  write_layers("other.exr", {{"R", "position.x"}, {"G", "position.y"}, {"B", "position.z"}});
  expect_parity({"--surfaces", "position=other.exr"});
}

TEST_F(ScoreSurfaces, WhatNobodyUnderstandsIsNotChecked) {
  write_layers("odd.exr", {{"foo.x", "position.x"}, {"foo.y", "position.y"}, {"foo.z", "position.z"}});
  const ProcessResult result = score({"--surfaces", "odd.exr"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(Json::parse(result.out)["parity"].is_null());
  EXPECT_THAT(result.err, HasSubstr("there are only foo.x, foo.y, foo.z: parity is not checked"));
}

TEST_F(ScoreSurfaces, NormalsAloneAreComparedWithTheTruths) {
  write_layers("n.exr", {{"N.x", "normal.x"}, {"N.y", "normal.y"}, {"N.z", "normal.z"}});
  expect_parity({"--surfaces", "n.exr"});
  write_layers("turned.exr", {{"N.x", "normal.y"}, {"N.y", "normal.z"}, {"N.z", "normal.x"}});
  EXPECT_EQ(score({"--surfaces", "turned.exr"}).exit_code, 1);
}

TEST_F(ScoreSurfaces, OtherAxesAndUnitsAreNamedAndCanBeChosen) {
  // z up and centimetres: theirs is (x, -z, y) * 100.
  Image image(truth_.width, truth_.height);
  const auto px = truth_.plane("position.x"), py = truth_.plane("position.y"),
             pz = truth_.plane("position.z");
  for (const char* name : {"P.X", "P.Y", "P.Z"}) image.add_plane(name);
  for (size_t i = 0; i < truth_.pixel_count(); ++i) {
    image.plane("P.X")[i] = 100.0f * px[i];
    image.plane("P.Y")[i] = -100.0f * pz[i];
    image.plane("P.Z")[i] = 100.0f * py[i];
  }
  write_exr(folder() / "z_up.exr", image);
  const ProcessResult result = score({"--surfaces", "z_up.exr"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("read as z up, in centimetres: give --axes=x,z,-y --unit 0.01"));
  expect_parity({"--surfaces", "z_up.exr", "--axes=x,z,-y", "--unit", "0.01"});
  const ProcessResult bad = score({"--surfaces", "z_up.exr", "--axes=x,x,y"});
  EXPECT_EQ(bad.exit_code, 2);
  EXPECT_THAT(bad.err, HasSubstr("are not three axes"));
}

TEST_F(ScoreSurfaces, APassThatWasNeverRenderedGetsAHint) {
  write_layers("zero.exr",
               {{"Position.X", "position.x"}, {"Position.Y", "position.y"}, {"Position.Z", "position.z"}},
               [](float) { return 0.0f; });
  const ProcessResult result = score({"--surfaces", "zero.exr"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("position is (0, 0, 0) in every pixel"));
}

TEST_F(ScoreSurfaces, ThePicturesOwnFileIsLookedAt) {
  Image both = read_image(folder() / "v.exr");
  for (const char* axis : {"x", "y", "z"}) {
    const std::string channel = std::string("position.") + axis;
    both.planes[channel] = truth_.planes.at(channel);
  }
  write_exr(folder() / "both.exr", both);
  const ProcessResult result =
      umbrameter({"score", "both.exr", "--reference", "1.exr", "--metrics", "error", "--json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_FALSE(Json::parse(result.out)["parity"].is_null());
}

}  // namespace
}  // namespace umbrameter
