// SPDX-License-Identifier: Apache-2.0
// Without these a Mitsuba or pbrt scene could be read and not work with the verbs: drawn differently by the renderers, or lost
// on its way through `scene import`.

#include "tests/cli/cli_fixture.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

const std::string kMitsuba = R"(<scene version="3.0.0">
  <sensor type="perspective"><float name="fov" value="45"/>
    <transform name="to_world"><lookat origin="2, 3, 5" target="0, 0.5, 0" up="0, 1, 0"/></transform></sensor>
  <shape type="rectangle"><transform name="to_world"><scale value="4"/><rotate x="1" angle="-90"/></transform></shape>
  <shape type="sphere"><transform name="to_world"><scale x="0.5" y="0.8" z="0.5"/><translate y="0.8"/></transform></shape>
  <shape type="rectangle" id="panel"><transform name="to_world"><rotate x="1" angle="90"/><translate x="1" y="4"/></transform>
    <emitter type="area"/></shape>
</scene>)";

const std::string kPbrt = R"(LookAt 2 3 5  0 0.5 0  0 1 0
Camera "perspective" "float fov" 35
Film "rgb" "integer xresolution" 96 "integer yresolution" 54
WorldBegin
Shape "bilinearmesh" "point3 P" [ -4 0 4  4 0 4  -4 0 -4  4 0 -4 ]
AttributeBegin
  Translate 0 0.8 0
  ConcatTransform [ 0.5 0 0 0  0.2 0.8 0 0  0 0 0.5 0  0 0 0 1 ]
  Shape "sphere"
AttributeEnd
AttributeBegin
  AreaLightSource "diffuse"
  Translate 1 4 0
  Rotate 90 1 0 0
  Shape "disk" "float radius" 0.8
AttributeEnd
)";

class ForeignVerbs : public CliTest {
 protected:
  Json validated(const std::string& scene) const {
    const ProcessResult result = umbrameter({"validate", scene, "--technique", "hard", "--width", "96",
                                             "--height", "54", "--spp", "64", "--frames", "0", "--json"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.exit_code == 0 ? Json::parse(result.out)["scenes"][0] : Json();
  }
};

class GlForeignVerbs : public ForeignVerbs {
 protected:
  void SetUp() override { require_gl(); }
};

TEST_F(GlForeignVerbs, BothRenderersSeeTheSameSurfaces) {
  write("m.xml", kMitsuba);
  write("p.pbrt", kPbrt);
  for (const char* scene : {"m.xml", "p.pbrt"}) {
    const Json result = validated(scene);
    ASSERT_FALSE(result.is_null());
    EXPECT_GE(result["parity"]["agreement"].get<double>(), 0.995) << scene;
    EXPECT_FALSE(result["techniques"][0]["error"].is_null()) << scene;
  }
}

TEST_F(ForeignVerbs, ImportedScenesAreTheSame) {
  write("m.xml", kMitsuba);
  const ProcessResult made = umbrameter({"scene", "import", "m.xml", "-o", "own/m.toml"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_THAT(made.err, HasSubstr("m.xml: 1 sphere is made of triangles"));
  const Json direct = Json::parse(umbrameter({"scene", "check", "m.xml", "--json"}).out)["scenes"][0];
  const Json edited = Json::parse(umbrameter({"scene", "check", "own/m.toml", "--json"}).out)["scenes"][0];
  EXPECT_EQ(direct["hash"], edited["hash"]);
  EXPECT_EQ(direct["lights"][0]["name"], "panel");
}

TEST_F(ForeignVerbs, BadFilesLeaveNothingBehind) {
  write("x.xml", "<scene version=\"3.0.0\"><shape type=\"obj\"/></scene>");
  write("x.pbrt", "WorldBegin Shape");
  expect_bad_input(umbrameter({"scene", "import", "x.xml", "-o", "x.toml"}), "x.xml:1: file '' is not there");
  expect_bad_input(umbrameter({"scene", "import", "x.pbrt", "-o", "x.toml"}),
                   "x.pbrt:1: a name in quotes is missing");
  expect_bad_input(umbrameter({"validate", "x.pbrt"}), "x.pbrt:1: a name in quotes is missing");
  EXPECT_THAT(files(), testing::ElementsAre("x.pbrt", "x.xml"));
}

}  // namespace
}  // namespace umbrameter
