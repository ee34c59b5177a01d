// SPDX-License-Identifier: Apache-2.0
// Presets named after papers and engines hold their constants: the source's number in the source's unit, and what turns it
// into ours.

#include "realtime/manifest/technique.h"
#include "tests/support/source_dir.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace umbrameter {
namespace {

struct SourceConstant {
  const char* technique;
  const char* preset;
  const char* parameter;
  double in_source;
  double conversion;  // ours for 1 of the source's
  const char* where;
};

// Sterna, github.com/maxest/MaxestFramework, samples/shadows: a map of 500 units and 2048 texels, seen from 500 units.
constexpr double kSternaMapUnits = 500.0;
constexpr double kSternaTexels = 2048.0;
constexpr double kSternaTexelsPerUnit = kSternaTexels / kSternaMapUnits;
constexpr const char* kSternaMain = "MaxestFramework/samples/shadows/src/main.cpp";
constexpr const char* kSternaCommon = "MaxestFramework/samples/shadows/data/common.hlsl";
constexpr const char* kSternaMask = "MaxestFramework/samples/shadows/data/shadow_mask_ps.hlsl";
// Godot 4.x: one map of directional_shadow_max_distance metres.
constexpr double kGodotMapMetres = 100.0;
constexpr const char* kGodotLights =
    "godot/servers/rendering/renderer_rd/shaders/scene_forward_lights_inc.glsl";
constexpr const char* kGodotQuality = "godot/servers/rendering/renderer_rd/renderer_scene_render_rd.cpp";
// Babylon.js at a map of 1024.
constexpr const char* kBabylon =
    "Babylon.js/packages/dev/core/src/Shaders/ShadersInclude/shadowsFragmentFunctions.fx";
constexpr const char* kBabylonGenerator =
    "Babylon.js/packages/dev/core/src/Lights/Shadows/shadowGenerator.ts";
constexpr const char* kFilament = "filament/shaders/src/surface_shadowing.fs";
constexpr const char* kFilamentOptions = "filament/filament/include/filament/LightManager.h, ShadowOptions";

const SourceConstant kConstants[] = {
    {"pcf_disk", "paper-d", "radius_texels", 0.002, kSternaTexels, kSternaMain},
    {"pcf_disk", "paper-d", "bias_texels", 2.0, kSternaTexelsPerUnit, kSternaMask},
    {"pcf_disk", "paper-d", "taps", 16, 1, kSternaMask},
    {"pcss", "paper-d", "curve_radius", 0.002, 1, kSternaMain},
    {"pcss", "paper-d", "curve_search", 0.002, 1.2, kSternaMain},
    {"pcss", "paper-d", "curve_scale", 80, 1, kSternaCommon},
    {"pcss", "paper-d", "curve_most", 1, 1, kSternaCommon},
    {"pcss", "paper-d", "curve_camera", 500, 1 / kSternaMapUnits, kSternaMain},
    {"pcss", "paper-d", "bias_texels", 2.0, kSternaTexelsPerUnit, kSternaMask},
    {"pcss", "paper-d", "search_taps", 32, 1, kSternaMain},
    {"pcss", "paper-d", "filter_taps", 16, 1, kSternaMask},
    {"penumbra_mask", "paper-d", "curve_radius", 0.002, 1, kSternaMain},
    {"penumbra_mask", "paper-d", "curve_search", 0.002, 1, kSternaMain},
    {"penumbra_mask", "paper-d", "search_scale", 1.2, 1, kSternaMain},
    {"penumbra_mask", "paper-d", "curve_camera", 500, 1 / kSternaMapUnits, kSternaMain},
    {"penumbra_mask", "paper-d", "mask_divisor", 4, 1, kSternaMain},
    {"penumbra_mask", "paper-d-checkerboard", "curve_radius", 0.002, 1, kSternaMain},
    {"pcss_checkerboard", "paper-d", "curve_radius", 0.002, 1, kSternaMain},
    {"pcss_min_filter", "paper-d", "curve_radius", 0.002, 1, kSternaMain},
    {"pcss", "godot-sun", "light_size_scale", 1, 2,
     kGodotLights},  // tangent of the whole angle, not of its half
    {"pcss", "godot-sun", "curve_camera", 0.5 * kGodotMapMetres + 20.0, 1 / kGodotMapMetres,
     "godot/scene/3d/light_3d.cpp"},
    {"pcss", "godot-sun", "search_taps", 24, 1, kGodotQuality},
    {"pcss", "godot-sun", "filter_taps", 24, 1, kGodotQuality},
    {"pcf_disk", "godot-high", "radius_texels", 3, 1, kGodotQuality},
    {"pcf_disk", "godot-high", "taps", 16, 1, kGodotQuality},
    {"pcf_disk", "godot-ultra", "radius_texels", 4, 1, kGodotQuality},
    {"pcf_disk", "godot-ultra", "taps", 32, 1, kGodotQuality},
    {"pcss", "babylon-medium", "curve_radius", 0.1, 1, kBabylonGenerator},
    {"pcss", "babylon-medium", "curve_search", 0.1, 1, kBabylonGenerator},
    {"pcss", "babylon-medium", "curve_offset", 10, 1.0 / 1024, kBabylon},
    {"pcss", "babylon-medium", "curve_falloff", 1, 1, kBabylon},
    {"pcss", "babylon-medium", "search_taps", 16, 1, kBabylon},
    {"pcss", "babylon-medium", "filter_taps", 32, 1, kBabylon},
    {"pcss", "filament-lamp", "search_taps", 16, 1, kFilament},
    {"pcss", "filament-lamp", "filter_taps", 16, 1, kFilament},
    {"pcss", "filament-lamp", "curve_radius", 1, 1, kFilament},
    {"pcss", "filament-lamp", "bias_world", 0.001, 1, kFilamentOptions},
    {"pcss", "filament-lamp", "normal_offset_texels", 1, 1, kFilamentOptions},
    {"esm", "paper-a", "exponent", 100, 1, "Araujo, listing 4"},
    {"esm", "paper-a", "full_shadow_at", 0.5, 1, "Araujo, listing 4"},
    {"pcss_esm", "paper-a", "exponent", 100, 1, "Araujo, listing 4"},
    {"pcss_esm", "paper-a", "full_shadow_at", 0.5, 1, "Araujo, listing 4"},
    {"pcss_vsm", "paper-a", "min_variance_of_range", 0.00005, 1, "Araujo, listing 2"},
    {"vsm_inline", "paper-a", "min_variance_of_range", 0.00005, 1, "Araujo, listing 2"},
    {"vsm", "paper-e", "min_variance_of_range", 0.00002, 1, "Rzeczkowski, 3.2.5"},
    {"pcss", "paper-e", "search_taps", 8 * 8, 1, "Rzeczkowski, figure 4.13"},
    {"pcss", "paper-e", "filter_taps", 8 * 8, 1, "Rzeczkowski, figure 4.13"},
    {"pcss", "paper-e", "map_size", 1024, 1, "Rzeczkowski, figure 4.13"},
    {"edge_mask", "paper-c-4", "filter_width_texels", 4, 1, "Evans, Agenjo and Blat, 4.3"},
    {"edge_mask", "paper-c-4", "threshold", 0.5, 1.0 / 255, "a target of 8 bits"},
    {"edge_mask_quantised", "paper-c-235", "threshold_1", 0.2, 1, "Evans, Agenjo and Blat, 4.4"},
    {"edge_mask_quantised", "paper-c-235", "threshold_2", 0.5, 1, "Evans, Agenjo and Blat, 4.4"},
    {"edge_mask_quantised", "paper-c-235", "threshold_3", 0.8, 1, "Evans, Agenjo and Blat, 4.4"},
    {"edge_mask_quantised", "paper-c-235", "width_1_texels", 2, 1, "Evans, Agenjo and Blat, table 1"},
    {"edge_mask_quantised", "paper-c-235", "width_3_texels", 5, 1, "Evans, Agenjo and Blat, table 1"},
};

/// Choices and switches without which the constants would mean something else.
struct SourceChoice {
  const char* technique;
  const char* preset;
  const char* parameter;
  const char* value;
};

const SourceChoice kChoices[] = {
    {"pcss", "paper-d", "penumbra_curve", "squared"},
    {"pcss", "paper-d", "curve_base", "map"},
    {"pcss", "paper-d", "map_fit", "none"},
    {"pcss", "paper-d", "bilinear_taps", "true"},
    {"penumbra_mask", "paper-d", "penumbra_curve", "squared"},
    {"penumbra_mask", "paper-d", "mask_precision", "byte"},
    {"penumbra_mask", "paper-d-one", "mask_default", "one"},
    {"penumbra_mask", "paper-d-checkerboard", "pattern", "checkerboard"},
    {"pcss", "godot-sun", "penumbra_curve", "ratio"},
    {"pcss", "godot-sun", "curve_base", "light"},
    {"pcss", "babylon-medium", "penumbra_curve", "difference"},
    {"pcss", "filament-lamp", "penumbra_curve", "ratio"},
    {"pcss", "filament-lamp", "average", "harmonic"},
    {"esm", "paper-a", "depth_form", "stored"},
    {"pcss_esm", "paper-a", "depth_form", "stored"},
    {"pcss_vsm", "paper-a", "depth_form", "stored"},
    {"vsm_inline", "paper-a", "depth_form", "stored"},
    {"vsm", "paper-e", "depth_form", "stored"},
    {"pcss", "paper-e", "kernel", "jittered"},
    {"pcss", "paper-e", "early_out", "true"},
    {"edge_mask", "paper-c-4", "filter_shape", "poisson"},
    {"edge_mask", "paper-c-4-grid", "filter_shape", "grid"},
    {"edge_mask_quantised", "paper-c-235", "filter_shape", "grid"},
    {"edge_mask_quantised", "paper-c-235", "calibration", "drop"},
};

ParameterValue value_of(const std::string& technique, const std::string& preset,
                        const std::string& parameter) {
  static const auto all = list_techniques(source_dir() / "realtime" / "techniques");
  const auto found = std::ranges::find(all, technique, &Technique::id);
  if (found == all.end()) throw std::runtime_error("no technique " + technique);
  return resolve_parameters(*found, {{"preset", preset}}).at(parameter);
}

double number(const ParameterValue& value) {
  if (const auto* integer = std::get_if<int64_t>(&value)) return static_cast<double>(*integer);
  return std::get<double>(value);
}

TEST(PresetSources, ConstantsTimesTheirConversionAreThePresets) {
  for (const SourceConstant& c : kConstants) {
    const double ours = number(value_of(c.technique, c.preset, c.parameter));
    const double expected = c.in_source * c.conversion;
    EXPECT_NEAR(ours, expected, 1e-3 * std::abs(expected))
        << c.technique << ":" << c.preset << " " << c.parameter << ", " << c.where;
  }
}

TEST(PresetSources, ChoicesAreTheSources) {
  for (const SourceChoice& c : kChoices) {
    EXPECT_EQ(to_text(value_of(c.technique, c.preset, c.parameter)), c.value)
        << c.technique << ":" << c.preset << " " << c.parameter;
  }
}

}  // namespace
}  // namespace umbrameter
