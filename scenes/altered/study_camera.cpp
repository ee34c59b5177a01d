// SPDX-License-Identifier: Apache-2.0
#include "scenes/altered/study_camera.h"

#include "scenes/orbit.h"
#include "scenes/read_camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace umbrameter {
namespace {

constexpr double kTurn_deg = 360.0;
constexpr std::array kPlaceKeys = {"eye", "at", "up", "fov_deg", "near"};

double read_angle_deg(const TomlNode& node) {
  const bool is_number = node.type == TomlNode::Type::integer || node.type == TomlNode::Type::real;
  if (!is_number || !(std::abs(node.real) < kTurn_deg))
    fail_input("'orbit_deg' is no angle between -360 and 360 degrees", node.where,
               "give one, or a list such as [-20, 20]");
  return node.real;
}

std::vector<StudyCamera> read_orbit(const std::string& name, const TomlNode& orbit) {
  if (orbit.type != TomlNode::Type::array) return {{name, read_angle_deg(orbit), {}}};
  if (orbit.items.empty()) fail_input("the list of 'orbit_deg' is empty", orbit.where);
  std::vector<StudyCamera> cameras;
  for (const TomlNode& item : orbit.items) {
    const double angle_deg = read_angle_deg(item);
    cameras.push_back({fmt::format("{} {:+g} deg", name, angle_deg), angle_deg, {}});
  }
  return cameras;
}

/// The table without what a scene's camera has not.
Camera read_place(const TomlNode& table) {
  TomlNode place = table;
  std::erase_if(place.entries, [](const TomlEntry& entry) { return entry.name == "name"; });
  return read_camera(place);
}

std::vector<StudyCamera> read_one(const TomlNode& table) {
  TomlReader reader(table, "[[camera]]");
  const std::string name = reader.text("name");
  if (name.empty()) reader.fail("name", "the camera's name is empty");
  const TomlNode* orbit = reader.find("orbit_deg");
  const bool has_place =
      std::ranges::count_if(kPlaceKeys, [&](const char* key) { return reader.has(key); }) > 0;
  if (orbit != nullptr && has_place)
    reader.fail("orbit_deg", "'orbit_deg' turns the scene's own camera, so that there is no other place",
                "give 'orbit_deg' or 'eye' and 'at'");
  reader.finish();
  if (orbit != nullptr) return read_orbit(name, *orbit);
  StudyCamera camera{name, 0.0, {}};
  if (has_place) camera.camera = read_place(table);
  return {camera};
}

}  // namespace

std::string full_name(const std::string& scene, const std::string& camera) {
  return camera.empty() ? scene : fmt::format("{}, {}", scene, camera);
}

std::vector<StudyCamera> read_study_cameras(TomlReader& study) {
  std::vector<StudyCamera> cameras;
  for (const TomlNode* table : study.tables("camera")) {
    for (StudyCamera& camera : read_one(*table)) {
      if (std::ranges::find(cameras, camera.name, &StudyCamera::name) != cameras.end())
        fail_input(fmt::format("two cameras are called '{}'", camera.name), table->where);
      cameras.push_back(std::move(camera));
    }
  }
  return cameras;
}

Camera camera_in(const StudyCamera& chosen, const Camera& own) {
  if (chosen.camera) return *chosen.camera;
  return chosen.orbit_deg == 0.0 ? own : orbit(own, chosen.orbit_deg);
}

}  // namespace umbrameter
