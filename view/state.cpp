// SPDX-License-Identifier: Apache-2.0
#include "view/state.h"

#include "core/names.h"
#include "view/light_edit.h"

#include <algorithm>
#include <array>

namespace umbrameter {
namespace {

ParameterValues complete(const ViewState& state, const Technique& technique,
                         const ParameterValues& overrides) {
  return in_world(technique.parameters, resolve_parameters(technique, overrides), state.diagonal_world);
}

bool equal(const Camera& a, const Camera& b) {
  return a.eye_world == b.eye_world && a.at_world == b.at_world && a.up_world == b.up_world &&
         a.vertical_fov_deg == b.vertical_fov_deg;
}

}  // namespace

std::string_view title_of(Layout layout) {
  constexpr std::array<std::string_view, kLayouts> kTitles{"Technique", "Truth", "Side by side", "Split",
                                                           "Resource"};
  return kTitles.at(static_cast<size_t>(layout));
}

void set_camera(ViewState& state, const Camera& camera) {
  if (equal(camera, state.camera)) return;
  state.camera = camera;
  if (state.light_follows) state.lights.at(state.light) = at_camera(state.shown_light(), camera);
  ++state.place_version;
}

void set_light(ViewState& state, const Light& light) {
  state.lights.at(state.light) = light;
  ++state.place_version;
}

void set_size(ViewState& state, int width_px, int height_px) {
  if (width_px == state.width_px && height_px == state.height_px) return;
  state.width_px = width_px;
  state.height_px = height_px;
  ++state.place_version;
}

void choose_light(ViewState& state, size_t light) {
  if (light == state.light) return;
  state.light = light;
  ++state.place_version;
}

void choose_technique(ViewState& state, size_t technique) {
  state.technique = technique;
  const Technique& chosen = state.techniques.at(technique);
  if (!state.values.contains(chosen.id)) state.values[chosen.id] = complete(state, chosen, {});
  ++state.run_version;
}

void choose_technique(ViewState& state, const std::string& id) {
  std::vector<std::string> known;
  for (const Technique& technique : state.techniques) known.push_back(technique.id);
  const auto found = std::ranges::find(known, id);
  if (found == known.end())
    fail_input(fmt::format("there is no technique '{}'", id), {}, suggest_name(id, known));
  choose_technique(state, static_cast<size_t>(found - known.begin()));
}

void set_value(ViewState& state, const std::string& parameter, const ParameterValue& value) {
  state.shown_values()[parameter] = value;
  ++state.run_version;
}

void apply_preset(ViewState& state, const std::string& preset) {
  ParameterValues overrides;
  if (!preset.empty()) overrides["preset"] = preset;
  state.shown_values() = complete(state, state.shown(), overrides);
  ++state.run_version;
}

}  // namespace umbrameter
