// SPDX-License-Identifier: Apache-2.0
// Technique, presets, and a control for every parameter of the manifest.

#include "realtime/manifest/activity.h"
#include "view/panels.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

/// "%.4g texels"; ImGui's formats have no "%" of ours.
std::string format_of(const Parameter& parameter, const char* number) {
  const bool has_unit = parameter.unit != "none" && parameter.unit != "ratio";
  return has_unit ? fmt::format("{} {}", number, parameter.unit) : number;
}

std::string range_text(const Parameter& parameter) {
  if (parameter.type != ParameterType::integer && parameter.type != ParameterType::real) return {};
  return fmt::format("\n\n{:g} to {:g} {}, default {}", parameter.min, parameter.max, parameter.unit,
                     to_text(parameter.default_value));
}

void tooltip(const Parameter& parameter, bool is_active) {
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  std::string text = parameter.doc + range_text(parameter);
  if (!parameter.when.empty())
    text += fmt::format("\n\nActs only when {}{}", parameter.when, is_active ? "." : ": not now.");
  text += "\n\nCtrl+click types a value; right click: default.";
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(380.0f);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

std::optional<ParameterValue> boolean_control(const char* id, bool value) {
  if (!ImGui::Checkbox(id, &value)) return std::nullopt;
  return value;
}

/// Powers of two are chosen by their exponent, so that there is nothing between them.
std::optional<ParameterValue> power_control(const char* id, const Parameter& parameter, int64_t value) {
  int exponent = static_cast<int>(std::lround(std::log2(static_cast<double>(value))));
  const int least = static_cast<int>(std::ceil(std::log2(parameter.min))),
            most = static_cast<int>(std::floor(std::log2(parameter.max)));
  const std::string text = format_of(parameter, std::to_string(value).c_str());
  if (!ImGui::SliderInt(id, &exponent, least, most, text.c_str(), ImGuiSliderFlags_NoInput))
    return std::nullopt;
  return int64_t{1} << exponent;
}

std::optional<ParameterValue> integer_control(const char* id, const Parameter& parameter, int64_t value) {
  if (parameter.scale == ParameterScale::pow2 && parameter.min >= 1.0)
    return power_control(id, parameter, value);
  const auto least = static_cast<int64_t>(parameter.min), most = static_cast<int64_t>(parameter.max);
  ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp;
  if (parameter.scale == ParameterScale::log) flags |= ImGuiSliderFlags_Logarithmic;
  if (!ImGui::SliderScalar(id, ImGuiDataType_S64, &value, &least, &most, format_of(parameter, "%lld").c_str(),
                           flags))
    return std::nullopt;
  if (parameter.step > 1.0)
    value = least + static_cast<int64_t>(std::lround((value - least) / parameter.step) * parameter.step);
  return value;
}

std::optional<ParameterValue> real_control(const char* id, const Parameter& parameter, double value) {
  ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoRoundToFormat;
  if (parameter.scale == ParameterScale::log || parameter.is_relative_to_scene)
    flags |= ImGuiSliderFlags_Logarithmic;
  const std::string format = format_of(parameter, "%.4g");
  if (!ImGui::SliderScalar(id, ImGuiDataType_Double, &value, &parameter.min, &parameter.max, format.c_str(),
                           flags))
    return std::nullopt;
  if (parameter.step > 0.0)
    value = parameter.min + std::round((value - parameter.min) / parameter.step) * parameter.step;
  return value;
}

std::optional<ParameterValue> choice_control(const char* id, const Parameter& parameter,
                                             const std::string& value) {
  if (!ImGui::BeginCombo(id, value.c_str())) return std::nullopt;
  std::optional<ParameterValue> chosen;
  for (const std::string& choice : parameter.choices)
    if (ImGui::Selectable(choice.c_str(), choice == value)) chosen = choice;
  ImGui::EndCombo();
  return chosen;
}

std::optional<ParameterValue> control(const char* id, const Parameter& parameter,
                                      const ParameterValue& value) {
  switch (parameter.type) {
    case ParameterType::boolean:
      return boolean_control(id, std::get<bool>(value));
    case ParameterType::integer:
      return integer_control(id, parameter, std::get<int64_t>(value));
    case ParameterType::real:
      return real_control(id, parameter, std::get<double>(value));
    case ParameterType::choice:
      return choice_control(id, parameter, std::get<std::string>(value));
  }
  return std::nullopt;
}

void parameter_row(ViewState& state, const Parameter& declared) {
  const Technique& technique = state.shown();
  const Parameter parameter = in_world(declared, state.diagonal_world);
  const ParameterValue value = state.shown_values().at(parameter.name);
  const bool is_active =
      umbrameter::is_active(technique, declared, state.shown_values(), state.shown_light());
  ImGui::BeginDisabled(!is_active);
  constexpr float kControl_px = 176.0f;
  const float name_x = ImGui::GetCursorPosX() + kControl_px + ImGui::GetStyle().ItemSpacing.x;
  ImGui::SetNextItemWidth(kControl_px);
  std::optional<ParameterValue> chosen = control(("##" + parameter.name).c_str(), parameter, value);
  const bool is_reset = ImGui::IsItemClicked(ImGuiMouseButton_Right);
  tooltip(parameter, is_active);
  ImGui::SameLine();
  if (parameter.type == ParameterType::boolean) ImGui::SetCursorPosX(name_x);
  const bool is_default = value == parameter.default_value;
  ImGui::TextColored(ImGui::GetStyle().Colors[is_default ? ImGuiCol_TextDisabled : ImGuiCol_Text], "%s",
                     parameter.name.c_str());
  tooltip(parameter, is_active);
  ImGui::EndDisabled();
  if (is_reset) chosen = parameter.default_value;
  if (chosen && *chosen != value) set_value(state, parameter.name, *chosen);
}

void preset_menu(ViewState& state) {
  ImGui::SetNextItemWidth(-1);
  if (!ImGui::BeginCombo("##preset", "Presets: choose one to apply")) return;
  if (ImGui::Selectable("defaults")) apply_preset(state, {});
  for (const Preset& preset : state.shown().presets) {
    if (ImGui::Selectable(preset.name.c_str())) apply_preset(state, preset.name);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", preset.doc.c_str());
  }
  ImGui::EndCombo();
}

void technique_menu(ViewState& state) {
  ImGui::SetNextItemWidth(-1);
  const std::string shown = fmt::format("{}: {}", state.shown().id, state.shown().title);
  if (!ImGui::BeginCombo("##technique", shown.c_str(), ImGuiComboFlags_HeightLarge)) return;
  for (size_t i = 0; i < state.techniques.size(); ++i) {
    const Technique& technique = state.techniques[i];
    const bool is_fit = technique.supports(state.shown_light().type);
    const std::string label = fmt::format("{}: {}", technique.id, technique.title);
    ImGui::BeginDisabled(!is_fit);
    if (ImGui::Selectable(label.c_str(), i == state.technique)) choose_technique(state, i);
    ImGui::EndDisabled();
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", technique.summary.c_str());
  }
  ImGui::EndCombo();
}

}  // namespace

void technique_panel(ViewState& state) {
  if (!ImGui::CollapsingHeader(heading_of(Section::technique), ImGuiTreeNodeFlags_DefaultOpen)) return;
  technique_menu(state);
  preset_menu(state);
  std::vector<std::string> groups;
  for (const Parameter& parameter : state.shown().parameters)
    if (std::ranges::find(groups, parameter.group) == groups.end()) groups.push_back(parameter.group);
  const std::vector<Parameter> parameters = state.shown().parameters;
  for (const std::string& group : groups) {
    ImGui::PushID(group.c_str());
    const bool is_open =
        ImGui::TreeNodeEx(group.empty() ? "other" : group.c_str(), ImGuiTreeNodeFlags_DefaultOpen);
    for (const Parameter& parameter : parameters)
      if (is_open && parameter.group == group) parameter_row(state, parameter);
    if (is_open) ImGui::TreePop();
    ImGui::PopID();
  }
}

}  // namespace umbrameter
