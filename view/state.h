// SPDX-License-Identifier: Apache-2.0
#pragma once
// What one has chosen in the window. Not here: what came of it (view/session.h).

#include "core/parameters.h"
#include "realtime/inspect.h"
#include "realtime/manifest/technique.h"
#include "scenes/scene.h"
#include "view/paint.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

enum class Layout : uint8_t { technique, truth, side_by_side, split, resource };
inline constexpr size_t kLayouts = 5;
std::string_view title_of(Layout layout);

struct ViewState {
  std::vector<Technique> techniques;
  size_t technique = 0;
  std::map<std::string, ParameterValues> values;  // complete, in world units; by technique, once it was shown
  double diagonal_world = 1.0;                    // of the scene

  Camera camera, first_camera;
  std::vector<Light> lights, first_lights;
  size_t light = 0;
  bool light_follows = false;

  int width_px = 0, height_px = 0;  // of the picture
  uint64_t place_version = 1;       // rises with camera, light and size
  uint64_t run_version = 1;         // rises with technique, parameters and shader files

  Layout layout = Layout::split;
  Layer layer = Layer::lit;
  PaintSettings paint;
  double split = 0.5;                   // technique left of it, truth right
  ResourcePart resource;                // shown by that layout
  bool wants_times = false;             // of passes
  std::optional<glm::ivec2> cursor_px;  // in the picture

  const Technique& shown() const { return techniques.at(technique); }
  const Light& shown_light() const { return lights.at(light); }
  ParameterValues& shown_values() { return values.at(shown().id); }
  const ParameterValues& shown_values() const { return values.at(shown().id); }
};

/// Setters that count the version up, and nothing where nothing changes.
void set_camera(ViewState& state, const Camera& camera);
void set_light(ViewState& state, const Light& light);
void set_size(ViewState& state, int width_px, int height_px);
void choose_light(ViewState& state, size_t light);
/// With the values that it had, or its defaults.
void choose_technique(ViewState& state, size_t technique);
/// Error{input} for an unknown id.
void choose_technique(ViewState& state, const std::string& id);
void set_value(ViewState& state, const std::string& parameter, const ParameterValue& value);
/// Every parameter as the preset says; defaults where it is empty.
void apply_preset(ViewState& state, const std::string& preset);

}  // namespace umbrameter
