// SPDX-License-Identifier: Apache-2.0
#include "results/tune/engine_settings.h"

#include <algorithm>
#include <array>

namespace umbrameter {
namespace {

struct EngineSetting {
  std::string_view parameter, settings;
};

// Names as in the engines' manuals. Unity's URP multiplies both of its biases by the world width of a texel; the built-in
// pipeline's shadowBias is in world units; three.js compares its bias with depth from 0 to 1.
constexpr std::array kSettings{
    EngineSetting{"bias_world",
                  "Unity built-in Light.shadowBias; Filament constantBias; Godot shadow_bias (scaled by its "
                  "engine); three.js -shadow.bias times (far - near)"},
    EngineSetting{"bias_texels", "Unity URP Depth Bias; elsewhere the world units beside it"},
    EngineSetting{"normal_offset_texels",
                  "Unity URP Normal Bias; Filament normalBias; three.js shadow.normalBias (world units)"},
    EngineSetting{"slope_bias",
                  "Unity HDRP Slope-Scale Depth Bias; Unreal Shadow Slope Bias; factor of glPolygonOffset"},
    EngineSetting{
        "light_size_scale",
        "the light's size times this: Unity HDRP Radius or Angular Diameter; Unreal Source Radius or "
        "Source Angle; Godot light_size or light_angular_distance; Bevy soft_shadow_size"},
    EngineSetting{"map_size", "the shadow map's resolution, everywhere"},
    EngineSetting{"radius_texels", "three.js shadow.radius; Godot shadow_blur (scaled by its engine)"},
    EngineSetting{"taps", "the shadow filter's quality, everywhere"},
    EngineSetting{"filter_taps", "the shadow filter's quality, everywhere"},
    EngineSetting{"search_taps", "the blocker search's samples: Unity HDRP, Godot, Babylon"},
};

/// The value of a parameter that a shader without it has.
constexpr std::array kNeutral{
    EngineSetting{"receiver_plane", "none"},     EngineSetting{"caster_layer", "nearest"},
    EngineSetting{"bias_mode", "manual"},        EngineSetting{"rotation", "none"},
    EngineSetting{"penumbra_curve", "physical"},
};

}  // namespace

std::string_view engine_settings_of(std::string_view parameter) {
  const auto found = std::ranges::find(kSettings, parameter, &EngineSetting::parameter);
  return found == kSettings.end() ? std::string_view{} : found->settings;
}

bool is_neutral(const Parameter& parameter, const ParameterValue& value) {
  if (parameter.type == ParameterType::choice) {
    const auto found = std::ranges::find(kNeutral, parameter.name, &EngineSetting::parameter);
    return found != kNeutral.end() && found->settings == to_text(value);
  }
  return numeric_value(parameter, value) == 0.0;
}

}  // namespace umbrameter
