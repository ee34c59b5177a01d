// SPDX-License-Identifier: Apache-2.0
#include "scenes/altered/stress/axes.h"
#include "scenes/altered/stress/obj_text.h"
#include "scenes/altered/stress/stage_text.h"

#include <map>
#include <utility>

namespace umbrameter {
namespace {

using glm::dvec3;

// Where the nominal slab floats.
constexpr dvec3 kLow_world(0.9, 1.15, 0.05), kHigh_world(1.6, 1.25, 0.75);

dvec3 corner(int x, int y, int z) {
  return {x == 0 ? kLow_world.x : kHigh_world.x, y == 0 ? kLow_world.y : kHigh_world.y,
          z == 0 ? kLow_world.z : kHigh_world.z};
}

/// The slab, closed and wound outwards; the last quad is its top.
TriangleSoup slab() {
  TriangleSoup soup;
  soup.add_quad(corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1));
  soup.add_quad(corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), corner(0, 1, 0));
  soup.add_quad(corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1), corner(1, 0, 1));
  soup.add_quad(corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0), corner(1, 0, 0));
  soup.add_quad(corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1));
  soup.add_quad(corner(0, 1, 0), corner(0, 1, 1), corner(1, 1, 1), corner(1, 1, 0));
  return soup;
}

TriangleSoup twice() {
  TriangleSoup soup = slab();
  const auto once = soup.triangles;
  soup.triangles.insert(soup.triangles.end(), once.begin(), once.end());
  return soup;
}

TriangleSoup with_zero_area() {
  TriangleSoup soup = slab();
  soup.triangles.push_back({corner(0, 0, 0), corner(0, 0, 0), corner(1, 1, 1)});
  soup.triangles.push_back({corner(0, 0, 0), dvec3(1.25, 1.15, 0.05), corner(1, 0, 0)});
  return soup;
}

// The top in three strips whose corners meet in the middle of its neighbours' edges.
TriangleSoup with_t_junctions() {
  TriangleSoup soup = slab();
  soup.triangles.resize(soup.triangles.size() - 2);
  const double y = kHigh_world.y, middle_x = 1.23, middle_z = 0.41;
  soup.add_sheet(kLow_world.x, middle_x, kLow_world.z, kHigh_world.z, y);
  soup.add_sheet(middle_x, kHigh_world.x, kLow_world.z, middle_z, y);
  soup.add_sheet(middle_x, kHigh_world.x, middle_z, kHigh_world.z, y);
  return soup;
}

TriangleSoup inverted(size_t every) {
  TriangleSoup soup = slab();
  for (size_t i = 0; i < soup.triangles.size(); i += every)
    std::swap(soup.triangles[i][1], soup.triangles[i][2]);
  return soup;
}

TriangleSoup open() {
  TriangleSoup soup = slab();
  soup.triangles.erase(soup.triangles.begin(), soup.triangles.begin() + 2);  // no bottom
  return soup;
}

TriangleSoup non_manifold() {
  TriangleSoup soup = slab();
  soup.add_quad(corner(0, 1, 0), corner(0, 1, 1), dvec3(0.9, 1.5, 0.75), dvec3(0.9, 1.5, 0.05));
  soup.add_quad(corner(0, 1, 0), corner(1, 1, 0), dvec3(1.6, 1.4, -0.3), dvec3(0.9, 1.4, -0.3));
  return soup;
}

TriangleSoup crossing() {
  TriangleSoup soup = slab();
  soup.add_quad(dvec3(0.9, 1.0, 0.4), dvec3(1.6, 1.0, 0.4), dvec3(1.6, 1.4, 0.4), dvec3(0.9, 1.4, 0.4));
  return soup;
}

StressPoint with_part(const std::string& text) {
  StageScene stage = nominal_stage();
  stage.meshes[2] = {"file = \"part.obj\"\n"};
  StressPoint point = point_of(stage);
  point.files = {{"part.obj", text}};
  return point;
}

/// A slab with one vertex that cannot be.
std::string with_vertex(const std::string& vertex) {
  return obj_text(slab()) + "v " + vertex + "\nf 1 2 37\n";
}

const std::map<std::string, std::string>& refused_parts() {
  static const std::map<std::string, std::string> parts = {
      {"nan vertex", with_vertex("nan 1 0")},
      {"infinite vertex", with_vertex("1 inf 0")},
      {"vertex at 1e30", with_vertex("1 1e30 0")},
      {"unknown vertex", obj_text(slab()) + "f 1 2 99\n"},
      {"zero areas alone", "v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n"},
      {"no faces", "v 0 0 0\n"},
  };
  return parts;
}

StressPoint no_meshes() {
  StageScene stage = nominal_stage();
  stage.meshes.clear();
  return point_of(stage);
}

// The picture shows nothing but a part of it.
StressPoint one_triangle() {
  StageScene stage = nominal_stage();
  TriangleSoup soup;
  soup.triangles.push_back({dvec3(-100, 0, 100), dvec3(200, 0, 100), dvec3(-100, 0, -200)});
  stage.meshes = {{"file = \"part.obj\"\n"}};
  StressPoint point = point_of(stage);
  point.files = {{"part.obj", obj_text(soup)}};
  return point;
}

TriangleSoup defect(const std::string& word) {
  if (word == "duplicates") return twice();
  if (word == "zero areas") return with_zero_area();
  if (word == "T-junctions") return with_t_junctions();
  if (word == "crossing sheets") return crossing();
  if (word == "inside out") return inverted(1);
  if (word == "mixed winding") return inverted(2);
  if (word == "open below") return open();
  if (word == "not manifold") return non_manifold();
  return slab();
}

StressPoint mesh_point(const StressValue& value) {
  const auto refused = refused_parts().find(value.text);
  if (value.text == "one triangle") return one_triangle();
  const bool is_empty = value.text == "no meshes";
  const bool is_refused = refused != refused_parts().end();
  StressPoint point = is_empty     ? no_meshes()
                      : is_refused ? with_part(refused->second)
                                   : with_part(obj_text(defect(value.text)));
  point.must_be_refused = is_refused || is_empty;
  return point;
}

}  // namespace

std::vector<StressAxis> mesh_axes() {
  std::vector<std::string> all = {"clean",           "duplicates",   "zero areas",    "T-junctions",
                                  "crossing sheets", "inside out",   "mixed winding", "open below",
                                  "not manifold",    "one triangle", "no meshes"};
  for (const auto& [word, text] : refused_parts()) all.push_back(word);
  return {{.name = "mesh",
           .unit = "",
           .doc = "The slab with a defect.",
           .values = words(all),
           .needs_parameter = {},
           .point = mesh_point}};
}

}  // namespace umbrameter
