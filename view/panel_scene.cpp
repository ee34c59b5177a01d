// SPDX-License-Identifier: Apache-2.0
// What is shown of the scene: layers, light, camera; saving; help.

#include "view/light_edit.h"
#include "view/panels.h"

#include <imgui.h>

#include <glm/trigonometric.hpp>

#include <array>

namespace umbrameter {
namespace {

constexpr float kWidth = 220.0f;

bool slider(const char* name, double& value, double least, double most, const char* format,
            bool is_log = false) {
  const ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp | (is_log ? ImGuiSliderFlags_Logarithmic : 0);
  ImGui::SetNextItemWidth(kWidth);
  return ImGui::SliderScalar(name, ImGuiDataType_Double, &value, &least, &most, format, flags);
}

bool drag3(const char* name, glm::dvec3& value, double step) {
  ImGui::SetNextItemWidth(kWidth);
  return ImGui::DragScalarN(name, ImGuiDataType_Double, &value.x, 3, static_cast<float>(step), nullptr,
                            nullptr, "%.3f");
}

template <class Choice>
void choice_buttons(Choice& chosen, size_t count) {
  for (size_t i = 0; i < count; ++i) {
    const std::string title(title_of(static_cast<Choice>(i)));
    const float width = ImGui::CalcTextSize(title.c_str()).x + 40.0f;
    if (i > 0 && ImGui::GetItemRectMax().x + width < ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x)
      ImGui::SameLine();
    if (ImGui::RadioButton(title.c_str(), chosen == static_cast<Choice>(i))) chosen = static_cast<Choice>(i);
  }
}

void size_controls(Light& light, double diagonal_world, bool& has_changed) {
  const double least = 1e-4 * diagonal_world, most = diagonal_world;
  switch (light.type) {
    case LightType::rect:
      has_changed |= slider("width", light.size_world.x, least, most, "%.4g world", true);
      has_changed |= slider("height", light.size_world.y, least, most, "%.4g world", true);
      break;
    case LightType::disk:
    case LightType::sphere:
      has_changed |= slider("radius", light.radius_world, least, most, "%.4g world", true);
      break;
    case LightType::sun: {
      double diameter_deg = 2.0 * glm::degrees(light.half_angle_rad);
      if (!slider("diameter", diameter_deg, 0.01, 90.0, "%.3g deg", true)) break;
      light.half_angle_rad = glm::radians(diameter_deg) / 2.0;
      has_changed = true;
      break;
    }
  }
}

}  // namespace

std::string_view title_of(Section section) {
  constexpr std::array<std::string_view, kSections> kNames{
      "Measured", "Technique", "View", "Light", "Camera", "Cursor", "Faults", "Passes", "Save"};
  return kNames.at(static_cast<size_t>(section));
}

const char* heading_of(Section section) {
  constexpr std::array<const char*, kSections> kHeadings{"Measured in this view",
                                                         "Technique (Page Up, Page Down)",
                                                         "View (1 to 5; L V X F N C T)",
                                                         "Light (Space: follows the camera)",
                                                         "Camera (W A S D Q E, mouse)",
                                                         "Under the cursor",
                                                         "Faults (F)",
                                                         "Frame graph and textures (5)",
                                                         "Save"};
  return kHeadings.at(static_cast<size_t>(section));
}

std::optional<std::string> scene_menu(const ViewSetup& setup, const std::string& opening) {
  std::optional<std::string> wanted;
  ImGui::SetNextItemWidth(-1);
  const std::string shown = "Scene: " + (opening.empty() ? setup.scene_name : opening + ", being read");
  if (!ImGui::BeginCombo("##scene", shown.c_str(), ImGuiComboFlags_HeightLarge)) return wanted;
  for (const SceneChoice& choice : setup.scenes) {
    ImGui::BeginDisabled(!choice.missing.empty());
    if (ImGui::Selectable(choice.name.c_str(), choice.name == setup.scene_name)) wanted = choice.name;
    ImGui::EndDisabled();
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
      ImGui::SetTooltip("%s%s", choice.title.c_str(),
                        choice.missing.empty() ? "" : ("\nneeds " + choice.missing).c_str());
  }
  ImGui::EndCombo();
  return wanted;
}

void view_panel(ViewState& state, const Session& session) {
  if (!ImGui::CollapsingHeader(heading_of(Section::view), ImGuiTreeNodeFlags_DefaultOpen)) return;
  ImGui::PushID("layout");
  choice_buttons(state.layout, kLayouts);
  ImGui::PopID();
  ImGui::Separator();
  choice_buttons(state.layer, kLayers);
  ImGui::Checkbox("Edges of triangles", &state.paint.has_edges);
  slider("exposure", state.paint.exposure_stops, -4.0, 4.0, "%+.1f stops");
  slider("error scale", state.paint.error_scale, 0.01, 1.0, "+-%.2f", true);
  if (needs_truth(state.layer) && session.truth(state) == nullptr) ImGui::TextDisabled("waits for the truth");
}

void light_panel(ViewState& state) {
  if (!ImGui::CollapsingHeader(heading_of(Section::light))) return;
  ImGui::SetNextItemWidth(kWidth);
  if (ImGui::BeginCombo("light", state.shown_light().name.c_str())) {
    for (size_t i = 0; i < state.lights.size(); ++i)
      if (ImGui::Selectable(state.lights[i].name.c_str(), i == state.light)) choose_light(state, i);
    ImGui::EndCombo();
  }
  ImGui::SameLine();
  ImGui::TextDisabled("%s", std::string(to_text(state.shown_light().type)).c_str());
  Light light = state.shown_light();
  bool has_changed = false;
  size_controls(light, state.diagonal_world, has_changed);
  if (light.type != LightType::sun)
    has_changed |= drag3("centre", light.center_world, 1e-3 * state.diagonal_world);
  glm::dvec3 direction = light.direction_world;
  if (drag3("direction", direction, 0.005) && glm::length(direction) > 1e-3) {
    light = facing(light, direction);
    has_changed = true;
  }
  bool follows = state.light_follows;
  if (ImGui::Checkbox("Follows the camera", &follows)) {
    state.light_follows = follows;
    if (follows) light = at_camera(light, state.camera);
    has_changed |= follows;
  }
  ImGui::SameLine();
  if (ImGui::Button("As in the scene")) {
    light = state.first_lights.at(state.light);
    state.light_follows = false;
    has_changed = true;
  }
  if (has_changed) set_light(state, light);
}

void camera_panel(ViewState& state, double& fly_speed_world) {
  if (!ImGui::CollapsingHeader(heading_of(Section::camera))) return;
  Camera camera = state.camera;
  slider("field of view", camera.vertical_fov_deg, 5.0, 120.0, "%.1f deg");
  drag3("eye", camera.eye_world, 1e-3 * state.diagonal_world);
  drag3("target", camera.at_world, 1e-3 * state.diagonal_world);
  slider("speed", fly_speed_world, 1e-3 * state.diagonal_world, state.diagonal_world, "%.3g world/s", true);
  if (ImGui::Button("As in the scene (Home)")) camera = state.first_camera;
  const glm::dvec3 view = camera.at_world - camera.eye_world;
  if (glm::length(glm::cross(view, camera.up_world)) > 1e-6 * glm::length(view)) set_camera(state, camera);
}

std::optional<Saved> save_panel(size_t path_cameras) {
  if (!ImGui::CollapsingHeader(heading_of(Section::save))) return std::nullopt;
  struct Entry {
    const char* title;
    Saved what;
  };
  constexpr Entry kEntries[] = {{"Picture (F2)", Saved::picture}, {"Window (Shift+F2)", Saved::window},
                                {"Scene (Ctrl+S)", Saved::scene}, {"Preset", Saved::preset},
                                {"Study", Saved::study},          {"Camera path", Saved::path}};
  std::optional<Saved> wanted;
  for (const Entry& entry : kEntries) {
    ImGui::BeginDisabled(entry.what == Saved::path && path_cameras == 0);
    if (ImGui::Button(entry.title, {178, 0})) wanted = entry.what;
    ImGui::EndDisabled();
    const bool is_left =
        entry.what == Saved::picture || entry.what == Saved::scene || entry.what == Saved::study;
    if (is_left) ImGui::SameLine();
  }
  return wanted;
}

void help_overlay(float width, float height) {
  constexpr const char* kText =
      "Left drag          orbit; the divider in a split view\n"
      "Shift + left drag  turn the light\n"
      "Right drag         look around\n"
      "Middle drag        pan\n"
      "Wheel              nearer, further\n"
      "W A S D, Q E       fly, down and up; with Shift faster\n"
      "Home               the scene's camera\n"
      "Page Up, Down      technique before, after\n"
      "1 2 3 4 5          technique, truth, side by side, split, texture\n"
      "L V X F N          lit, visibility, error, faults, normals\n"
      "C, T               maps (cascades) coloured, edges of triangles\n"
      "Space              light follows the camera\n"
      ", .                light smaller, larger\n"
      "R, P               record a camera path, play it\n"
      "F2, Shift+F2       save picture, window\n"
      "Ctrl+S, Ctrl+Q     save scene, quit\n"
      "Tab, H             panel, this help";
  ImGui::SetNextWindowPos({width / 2, height / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowBgAlpha(0.92f);
  ImGui::Begin("help", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove);
  std::string_view rest(kText);
  while (!rest.empty()) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    ImGui::TextColored({0.5f, 0.7f, 1.0f, 1.0f}, "%s", std::string(line.substr(0, 18)).c_str());
    ImGui::SameLine(150.0f);
    ImGui::TextUnformatted(std::string(line.substr(19)).c_str());
  }
  ImGui::End();
}

}  // namespace umbrameter
