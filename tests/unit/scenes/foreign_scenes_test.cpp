// SPDX-License-Identifier: Apache-2.0
// Without these one scene could be another one in each renderer's language: mirrored, askew, or lit from elsewhere.
#include "foreign_folder.h"

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

namespace umbrameter {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string kToml = R"(
[camera]
eye = [3, 4, 5]
at = [0, 0.5, 0]
fov_deg = 40
[[mesh]]
shape = "plane"
size = [4, 4]
[[mesh]]
shape = "box"
size = [1, 2, 0.5]
translate = [1, 0, 0]
[[mesh]]
file = "tent.ply"
scale = [2, 1, 0.5]
rotate_deg = 90
translate = [-1, 0, 0.25]
[[light]]
name = "panel"
type = "rect"
center = [0, 4, 0]
direction = [0, -1, 0]
tangent = [1, 0, 0]
size = [1, 0.5]
[[light]]
name = "plate"
type = "disk"
center = [2, 3, 0]
direction = [0, -1, 0]
radius = 0.25
[[light]]
name = "ball"
type = "sphere"
center = [-2, 2, 1]
radius = 0.25
[[light]]
name = "sky"
type = "sun"
direction = [0.3, -1, 0]
angular_diameter_deg = 0.53
)";

const std::string kMitsuba = R"(<scene version="3.0.0">
  <default name="height" value="4"/>
  <sensor type="perspective">
    <float name="fov" value="40"/><string name="fov_axis" value="y"/>
    <transform name="to_world"><lookat origin="3, 4, 5" target="0, 0.5, 0" up="0, 1, 0"/></transform>
    <film type="hdrfilm"><integer name="width" value="320"/><integer name="height" value="180"/></film>
  </sensor>
  <shape type="rectangle" id="floor">
    <transform name="to_world"><scale value="2"/><rotate x="1" angle="-90"/></transform>
    <bsdf type="diffuse"/>
  </shape>
  <shape type="cube">
    <transform name="to_world"><scale x="0.5" y="1" z="0.25"/><translate x="1" y="1"/></transform>
  </shape>
  <shape type="ply">
    <string name="filename" value="tent.ply"/>
    <transform name="to_world">
      <scale x="2" z="0.5"/><rotate y="1" angle="90"/><translate x="-1" z="0.25"/>
    </transform>
  </shape>
  <shape type="rectangle" id="panel">
    <transform name="toWorld"><scale x="0.5" y="0.25"/><rotate x="1" angle="90"/><translate y="$height"/></transform>
    <emitter type="area"><rgb name="radiance" value="10"/></emitter>
  </shape>
  <shape type="disk" id="plate">
    <transform name="to_world"><scale value="0.25"/><rotate x="1" angle="90"/><translate x="2" y="3"/></transform>
    <emitter type="area"/>
  </shape>
  <shape type="sphere" id="ball">
    <point name="center" value="-2 2 1"/><float name="radius" value="0.25"/>
    <emitter type="area"/>
  </shape>
  <emitter type="directional" id="sky"><vector name="direction" x="0.3" y="-1"/></emitter>
  <emitter type="constant"/>
</scene>
)";

/// `camera`: what stands before LookAt.
std::string pbrt_scene(const std::string& camera) {
  return camera + R"(
LookAt 3 4 5  0 0.5 0  0 1 0
Camera "perspective" "float fov" [ 40 ]
Film "rgb" "integer xresolution" 320 "integer yresolution" 180
WorldBegin
AttributeBegin  # the floor
  Rotate -90 1 0 0
  Scale 2 2 1
  Shape "bilinearmesh" "point3 P" [ -1 -1 0  1 -1 0  -1 1 0  1 1 0 ]
AttributeEnd
AttributeBegin
  Translate 1 0 0
  Shape "trianglemesh" "integer indices" [ 0 4 6 0 6 2  1 3 7 1 7 5  0 1 5 0 5 4  2 6 7 2 7 3  0 2 3 0 3 1  4 5 7 4 7 6 ]
    "point3 P" [ -0.5 0 -0.25  0.5 0 -0.25  -0.5 2 -0.25  0.5 2 -0.25  -0.5 0 0.25  0.5 0 0.25  -0.5 2 0.25  0.5 2 0.25 ]
AttributeEnd
TransformBegin
  Translate -1 0 0.25
  Rotate 90 0 1 0
  Scale 2 1 0.5
  Shape "plymesh" "string filename" "tent.ply"
TransformEnd
AttributeBegin
  NamedMaterial "panel"
  AreaLightSource "diffuse" "rgb L" [ 10 10 10 ]
  Translate 0 4 0
  Rotate 90 1 0 0
  Scale 0.5 0.25 1
  Shape "trianglemesh" "integer indices" [ 0 1 2 0 2 3 ] "point3 P" [ -1 -1 0  1 -1 0  1 1 0  -1 1 0 ]
AttributeEnd
AttributeBegin
  NamedMaterial "plate"
  AreaLightSource "diffuse"
  Translate 2 3 0
  Rotate 90 1 0 0
  Shape "disk" "float radius" 0.25
AttributeEnd
AttributeBegin
  NamedMaterial "ball"
  AreaLightSource "diffuse"
  Translate -2 2 1
  Shape "sphere" "float radius" [ 0.25 ]
AttributeEnd
LightSource "distant" "point3 to" [ 0.3 -1 0 ] "point3 from" [ 0 0 0 ]
LightSource "infinite"
)";
}

class ForeignScenes : public ForeignTest {
 protected:
  void SetUp() override { write_tent(); }
};

void expect_same_lights(const Scene& a, const Scene& b) {
  ASSERT_EQ(a.lights.size(), b.lights.size());
  for (size_t i = 0; i < a.lights.size(); ++i) {
    const Light &x = a.lights[i], &y = b.lights[i];
    EXPECT_EQ(x.type, y.type);
    EXPECT_LT(glm::distance(x.center_world, y.center_world), 1e-12) << x.name;
    EXPECT_LT(glm::distance(x.size_world, y.size_world), 1e-12) << x.name;
    EXPECT_NEAR(x.radius_world, y.radius_world, 1e-12) << x.name;
    EXPECT_NEAR(x.half_angle_rad, y.half_angle_rad, 1e-15) << x.name;
    if (x.type == LightType::sphere) continue;
    EXPECT_LT(glm::distance(x.direction_world, y.direction_world), 1e-12) << x.name;
    if (x.type != LightType::rect) continue;
    EXPECT_NEAR(std::abs(glm::dot(x.tangent_world, y.tangent_world)), 1.0, 1e-12) << x.name;
  }
}

void expect_same_view(const Scene& a, const Scene& b) {
  const glm::dmat4 x = clip_from_world(a.camera, 320, 180), y = clip_from_world(b.camera, 320, 180);
  for (const glm::dvec3& p : {glm::dvec3(0), {1, 2, 0.25}, {-2, 0, 2}}) {
    const glm::dvec4 in_a = x * glm::dvec4(p, 1.0), in_b = y * glm::dvec4(p, 1.0);
    EXPECT_LT(glm::distance(glm::dvec2(in_a) / in_a.w, glm::dvec2(in_b) / in_b.w), 1e-12);
  }
}

TEST_F(ForeignScenes, OneSceneInThreeLanguagesIsTheSame) {
  const Scene own = load("own.toml", kToml);
  ASSERT_EQ(own.triangles.size(), 2u + 12u + 4u);
  const Scene mitsuba = load("x.xml", kMitsuba), pbrt = load("x.pbrt", pbrt_scene("Scale -1 1 1"));
  for (const Scene* other : {&mitsuba, &pbrt}) {
    EXPECT_EQ(sorted_triangles(own), sorted_triangles(*other));
    expect_same_view(own, *other);
    expect_same_lights(own, *other);
    EXPECT_THAT(other->warnings,
                testing::Contains(HasSubstr("has no angular diameter in degrees; 0.53 is taken")));
  }
  EXPECT_THAT(mitsuba.warnings,
              testing::Contains(HasSubstr("x.xml: 1 emitter of type 'constant' is left out")));
  EXPECT_THAT(mitsuba.warnings,
              testing::Contains(HasSubstr("1 mesh without normals is shaded flat, not smoothed")));
  EXPECT_THAT(pbrt.warnings, testing::Contains(HasSubstr("x.pbrt: 1 light of type 'infinite' is left out")));
  EXPECT_EQ(mitsuba.lights[0].name, "panel");
  EXPECT_EQ(pbrt.lights[3].name, "distant");
}

TEST_F(ForeignScenes, PbrtsWorldIsLeftHanded) {
  const Scene right = load("right.pbrt", pbrt_scene("Scale -1 1 1"));
  const Scene left = load("left.pbrt", pbrt_scene(""));
  std::vector<Corners> mirrored = sorted_triangles(right);
  for (Corners& corners : mirrored) {
    for (auto& p : corners) p[0] = -p[0] + 0.0f;
    std::swap(corners[1], corners[2]);  // outside stays outside
    std::ranges::rotate(corners, std::ranges::min_element(corners));
  }
  std::ranges::sort(mirrored);
  EXPECT_EQ(sorted_triangles(left), mirrored);
  EXPECT_LT(glm::distance(left.lights[1].center_world, glm::dvec3(-2, 3, 0)), 1e-12);
  EXPECT_LT(glm::distance(left.lights[0].direction_world, glm::dvec3(0, -1, 0)), 1e-12);
}

TEST_F(ForeignScenes, CamerasLookAsTheirRenderersDo) {
  // Mitsuba: along +z, x to the left. `fov` is of the axis that is asked for; 200 x 100 px.
  const auto mitsuba = [&](const std::string& fov) {
    return load("c.xml",
                "<scene version=\"3.0.0\"><sensor type=\"perspective\">" + fov +
                    "<transform name=\"to_world\"><translate z=\"-5\"/></transform>"
                    "<film type=\"hdrfilm\"><integer name=\"width\" value=\"200\"/>"
                    "<integer name=\"height\" value=\"100\"/></film></sensor><shape type=\"cube\"/></scene>");
  };
  const auto fov = [](const std::string& axis) {
    return "<float name=\"fov\" value=\"90\"/><string name=\"fov_axis\" value=\"" + axis + "\"/>";
  };
  const auto x_of = [&](const Scene& scene) { return place_in_picture(scene, {-1, 0, 0}, 200, 100).x; };
  EXPECT_NEAR(x_of(mitsuba("<float name=\"fov\" value=\"90\"/>")), 0.2, 1e-12);
  EXPECT_NEAR(x_of(mitsuba(fov("x"))), 0.2, 1e-12);
  EXPECT_NEAR(x_of(mitsuba(fov("larger"))), 0.2, 1e-12);
  EXPECT_NEAR(x_of(mitsuba(fov("y"))), 0.1, 1e-12);
  EXPECT_NEAR(x_of(mitsuba(fov("smaller"))), 0.1, 1e-12);
  EXPECT_NEAR(x_of(mitsuba(fov("diagonal"))), 0.2 * std::sqrt(5.0) / 2.0, 1e-12);
  const double tangent_50mm = 0.5 * std::hypot(36.0, 24.0) / 50.0;
  EXPECT_NEAR(x_of(mitsuba("<string name=\"focal_length\" value=\"50mm\"/>")),
              0.2 / tangent_50mm * std::sqrt(5.0) / 2.0, 1e-12);
  EXPECT_NEAR(place_in_picture(mitsuba(fov("y")), {0, 1, 0}, 200, 100).y, 0.2, 1e-12) << "y up";

  // pbrt: along +z, x to the right, in a left-handed world: its x is our -x. `fov` is of the shorter axis.
  const auto pbrt = [&](const std::string& more, const std::string& film) {
    return load("c.pbrt",
                "LookAt 0 0 -5  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" 90 " + more +
                    "\nFilm \"rgb\" " + film +
                    "\nWorldBegin\nShape \"sphere\"\nLightSource \"point\" \"point3 from\" [ 1 0 0 ]");
  };
  const std::string wide = "\"integer xresolution\" 200 \"integer yresolution\" 100";
  const Scene scene = pbrt("", wide);
  EXPECT_EQ(scene.lights.front().center_world, glm::dvec3(-1, 0, 0));
  EXPECT_NEAR(place_in_picture(scene, {-1, 0, 0}, 200, 100).x, 0.1, 1e-12);
  const Scene tall = pbrt("", "\"integer xresolution\" 100 \"integer yresolution\" 200");
  EXPECT_NEAR(place_in_picture(tall, {-1, 0, 0}, 100, 200).x, 0.2, 1e-12);
  const Scene window = pbrt("\"float screenwindow\" [ -1 1 -0.5 0.5 ]", wide);
  EXPECT_NEAR(place_in_picture(window, {-1, 0, 0}, 200, 100).x, 0.2, 1e-12);
}

TEST_F(ForeignScenes, ImportsAreSceneFilesThatReferToThem) {
  write("x.xml", kMitsuba);
  const ImportedScene imported = import_file(folder_.path() / "x.xml");
  EXPECT_THAT(imported.toml, HasSubstr("# camera of sensor 'perspective' (320 x 180 px)\n[camera]\n"));
  EXPECT_THAT(imported.toml, HasSubstr("[[mesh]]\nname = \"x\"\nfile = \"x.xml\"\n"));
  const Scene edited = load("edited.toml", imported.toml), own = load("own.toml", kToml);
  EXPECT_EQ(sorted_triangles(edited), sorted_triangles(own));
  expect_same_lights(edited, own);
  const MeshData floor = mesh("x.xml", kMitsuba, {.include = {"floor"}, .exclude = {}});
  EXPECT_EQ(floor.triangles.size(), 2u);
  std::vector<std::string> parts;
  for (const MeshPart& part : mesh("x.xml", kMitsuba).parts) parts.push_back(part.name);
  EXPECT_THAT(parts, ElementsAre("floor", "cube", "tent"));
}

}  // namespace
}  // namespace umbrameter
