// SPDX-License-Identifier: Apache-2.0
// Presets named after papers and engines hold their constants: the source's number in the source's unit, and what turns it
// into ours.

#include "realtime/manifest/technique.h"
#include "tests/support/source_dir.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

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
constexpr const char* kBevy = "bevy/crates/bevy_pbr/src/render/shadow_sampling.wgsl";
constexpr const char* kBevyLight = "bevy/crates/bevy_pbr/src/light/directional_light.rs";
constexpr const char* kThreeExample = "three.js/examples/webgl_shadowmap_pcss.html";
constexpr const char* kFilament = "filament/shaders/src/surface_shadowing.fs";
// bgfx: the first 16 taps of a Vogel disk made for 10 reach the root of 1.6 times its radius.
const double kBgfxDisk = std::sqrt(16.0 / 10.0);
constexpr const char* kBgfx = "bgfx/examples/16-shadowmaps/common.sh";
// smSettings: by light and kind of depth; stored depth (InvZ) of a spot light is what it starts with.
constexpr const char* kBgfxSettings = "bgfx/examples/16-shadowmaps/shadowmaps.cpp, m_xOffset";
constexpr const char* kPlayCanvasSun =
    "engine/src/scene/shader-lib/glsl/chunks/lit/frag/lighting/shadowSoft.js";
constexpr const char* kPlayCanvasLamp =
    "engine/src/scene/shader-lib/glsl/chunks/lit/frag/lighting/shadowPCSS.js";
constexpr const char* kPlayCanvasLight = "engine/src/scene/light.js, penumbraSize";
// uv of a map of 1024 texels over the tangent of half its cone: lateral coordinates are twice that tangent wide.
constexpr double kPlayCanvasLateral = 2.0 / 1024.0;
// Unity HDRP.
constexpr const char* kHdrpLight = "com.unity.render-pipelines.high-definition/HDAdditionalLightData.cs";
constexpr const char* kHdrpSampling = "com.unity.render-pipelines.high-definition/HDShadowSampling.hlsl";
constexpr const char* kHdrpRequest =
    "com.unity.render-pipelines.high-definition/HDGpuLightsBuilder, dirLightPCSSDepth2RadialScale";
constexpr const char* kFilamentOptions = "filament/filament/include/filament/LightManager.h, ShadowOptions";

constexpr const char* kMoments2015 = "Peters and Klein, I3D 2015: 16 bits";
constexpr const char* kMoments2017 = "Peters et al., JCGT 6(1), code of the demo";
// Second-hand: ports of the code of the same authors' later paper, whose four-moment constants are those of the demo.
constexpr const char* kMoments2018 = "Muenstermann et al., I3D 2018, ports of the code";
// Unreal Engine 5.3, in centimetres.
constexpr double kMetresOfCentimetres = 0.01;
constexpr const char* kUnreal =
    "UnrealEngine/Engine/Source/Runtime/Renderer/Private/VirtualShadowMaps/VirtualShadowMapProjection.cpp";

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
    {"pcss", "babylon-low", "search_taps", 16, 1, kBabylon},
    {"pcss", "babylon-low", "filter_taps", 16, 1, kBabylon},
    {"pcss", "babylon-low", "curve_radius", 0.1, 1, kBabylonGenerator},
    {"pcss", "babylon-low", "curve_offset", 10, 1.0 / 1024, kBabylon},
    {"pcss", "babylon-high", "search_taps", 32, 1, kBabylon},
    {"pcss", "babylon-high", "filter_taps", 64, 1, kBabylon},
    {"pcss", "babylon-high", "curve_radius", 0.1, 1, kBabylonGenerator},
    {"pcss", "babylon-high", "curve_offset", 10, 1.0 / 1024, kBabylon},
    {"pcss", "godot-omni", "search_taps", 24, 1, kGodotQuality},
    {"pcss", "godot-omni", "filter_taps", 24, 1, kGodotQuality},
    {"pcss", "godot-omni", "curve_radius", 1, 1, kGodotLights},
    {"pcss", "godot-omni", "curve_search", 1, 1, kGodotLights},
    {"pcss", "godot-omni", "light_size_scale", 1, 1, kGodotLights},
    {"pcss", "bevy-taps", "search_taps", 8, 1, kBevy},
    {"pcss", "bevy-taps", "filter_taps", 8, 1, kBevy},
    {"pcss", "threejs-example-taps", "search_taps", 17, 1, kThreeExample},
    {"pcss", "threejs-example-taps", "filter_taps", 17, 2, kThreeExample},  // each tap again, turned
    {"pcss", "threejs-example-taps", "search_focus", 0.75, 1, kThreeExample},
    {"pcf_tent", "bevy-gaussian", "bias_world", 0.02, 1, kBevyLight},
    {"pcf_tent", "bevy-gaussian", "normal_offset_texels", 1.8, 1, kBevyLight},
    {"pcss", "filament-lamp", "search_taps", 16, 1, kFilament},
    {"pcss", "filament-lamp", "filter_taps", 16, 1, kFilament},
    {"pcss", "filament-lamp", "curve_radius", 1, 1, kFilament},
    {"pcss", "filament-lamp", "bias_world", 0.001, 1, kFilamentOptions},
    {"pcss", "filament-lamp", "normal_offset_texels", 1, 1, kFilamentOptions},
    {"pcf_disk", "bgfx", "taps", 16, 1, kBgfx},
    {"pcf_disk", "bgfx", "radius_texels", 2.0, kBgfxDisk, kBgfx},
    {"pcss_map_units", "bgfx", "search_taps", 16, 1, kBgfx},
    {"pcss_map_units", "bgfx", "filter_taps", 16, 1, kBgfx},
    {"pcss_map_units", "bgfx", "search_radius", 0.01, kBgfxDisk, kBgfx},
    {"pcss_map_units", "bgfx", "penumbra_size", 15.0, kBgfxDisk, kBgfxSettings},
    {"pcss_map_units", "bgfx", "most_radius", 0.25, kBgfxDisk, kBgfx},
    {"pcss_map_units", "bgfx", "fade_share", 0.25, 1, kBgfx},
    {"pcss_map_units", "bgfx-sun", "search_taps", 16, 1, kBgfx},
    {"pcss_map_units", "bgfx-sun", "filter_taps", 16, 1, kBgfx},
    {"pcss_map_units", "bgfx-sun", "search_radius", 0.01, kBgfxDisk, kBgfx},
    {"pcss_map_units", "bgfx-sun", "penumbra_size", 0.5, kBgfxDisk, kBgfxSettings},
    {"pcss_map_units", "bgfx-sun", "most_radius", 0.25, kBgfxDisk, kBgfx},
    {"pcss_map_units", "bgfx-sun", "fade_share", 0.25, 1, kBgfx},
    {"pcss_map_units", "filament-sun", "search_taps", 16, 1, kFilament},
    {"pcss_map_units", "filament-sun", "filter_taps", 16, 1, kFilament},
    {"pcss_map_units", "filament-sun", "search_radius", 0.02, 1, kFilamentOptions},
    {"pcss_map_units", "filament-sun", "penumbra_size", 0.02, 1, kFilamentOptions},
    {"pcss_map_units", "filament-sun", "bias_world", 0.001, 1, kFilamentOptions},
    {"pcss_map_units", "filament-sun", "normal_offset_texels", 1, 1, kFilamentOptions},
    {"pcss_map_units", "filament-sun", "slope_bias", 2, 1, kFilamentOptions},
    {"pcss_map_units", "playcanvas-sun", "search_taps", 16, 1, kPlayCanvasLight},
    {"pcss_map_units", "playcanvas-sun", "filter_taps", 16, 1, kPlayCanvasLight},
    {"pcss_map_units", "playcanvas-sun", "focus", 1.33, 0.5, kPlayCanvasSun},
    {"pcss_map_units", "playcanvas-sun", "search_radius", 1, 1, kPlayCanvasLight},
    {"pcss_map_units", "playcanvas-sun", "penumbra_size", 1, 1, kPlayCanvasLight},
    {"pcss_map_units", "playcanvas-lamp", "search_taps", 16, 1, kPlayCanvasLamp},
    {"pcss_map_units", "playcanvas-lamp", "filter_taps", 16, 1, kPlayCanvasLamp},
    {"pcss_map_units", "playcanvas-lamp", "search_radius", 1, kPlayCanvasLateral, kPlayCanvasLight},
    {"pcss_map_units", "playcanvas-lamp", "penumbra_size", 1.0 / 3.0, kPlayCanvasLateral, kPlayCanvasLamp},
    {"dpcf", "filament-lamp", "search_taps", 12, 1, kFilament},
    {"dpcf", "filament-lamp", "radius_world", 0.02, 1, kFilamentOptions},
    {"dpcf", "filament-lamp", "ratio_scale", 1, 1, kFilamentOptions},
    {"dpcf", "filament-sun", "search_taps", 12, 1, kFilament},
    {"dpcf", "filament-sun", "radius_world", 0.02, 1, kFilamentOptions},
    {"pcss_cone", "unity-hdrp", "search_taps", 24, 1, kHdrpLight},
    {"pcss_cone", "unity-hdrp", "filter_taps", 16, 1, kHdrpLight},
    {"pcss_cone", "unity-hdrp", "search_clump", 2, 0.5, kHdrpLight},
    {"pcss_cone", "unity-hdrp", "search_angle_deg", 12, 1, kHdrpLight},
    {"pcss_cone", "unity-hdrp", "least_filter_angle_deg", 10, 1, kHdrpLight},
    {"pcss_cone", "unity-hdrp", "least_filter_texels", 1.5, 1, kHdrpLight},
    {"pcss_cone", "unity-hdrp", "max_radius_world", 0.56, 1, kHdrpLight},
    {"pcss_cone", "unity-hdrp", "max_offset_world", 0.5, 1, kHdrpLight},
    {"pcss_cone", "unity-hdrp", "cone_share", 0.9, 1, kHdrpSampling},
    {"pcss_cone", "unity-hdrp", "max_offset_share", 0.25, 1, kHdrpSampling},
    {"pcss_cone", "unity-hdrp", "light_size_scale", 1, 2, kHdrpRequest},
    {"pcss_cone", "unity-hdrp", "normal_offset_texels", 0.75, std::numbers::sqrt2, kHdrpLight},
    {"msm4", "peters-klein-2015", "moment_bias", 3e-5, 1, kMoments2015},
    {"msm4", "peters-klein-2015", "bias_even_moments", 1, 1, kMoments2015},  // halves at both ends of [0, 1]
    {"msm4", "peters-2017", "moment_bias", 6e-5, 1, kMoments2017},
    {"msm4", "peters-2017", "bias_even_moments", 0.628, 1, kMoments2017},
    {"msm4", "peters-2017-128", "moment_bias", 3e-7, 1, kMoments2017},
    {"msm4", "peters-2017-128", "bias_even_moments", 0.375, 1, kMoments2017},
    {"msm6", "muenstermann-2018-96", "moment_bias", 6e-4, 1, kMoments2018},
    {"msm6", "muenstermann-2018-192", "moment_bias", 5e-6, 1, kMoments2018},
    {"smrt", "unreal", "rays", 7, 1, kUnreal},
    {"smrt", "unreal", "samples", 8, 1, kUnreal},
    {"smrt", "unreal", "max_ray_angle_rad", 0.03, 1, kUnreal},
    {"smrt", "unreal", "sun_length", 1.5, 1, kUnreal},
    {"smrt", "unreal", "texel_dither", 2, 1, kUnreal},
    {"smrt", "unreal", "lamp_slope", 0.05, 1, kUnreal},
    {"smrt", "unreal", "sun_slope_world", 5, kMetresOfCentimetres, kUnreal},
    {"smrt", "unreal", "normal_distances", 0.5, 0.001, kUnreal},
    {"smrt_cascades", "unreal", "rays", 7, 1, kUnreal},
    {"smrt_cascades", "unreal", "samples", 8, 1, kUnreal},
    {"smrt_cascades", "unreal", "sun_length", 1.5, 1, kUnreal},
    {"smrt_cascades", "unreal", "texel_dither", 2, 1, kUnreal},
    {"smrt_cascades", "unreal", "sun_slope_world", 5, kMetresOfCentimetres, kUnreal},
    {"smrt_cascades", "unreal", "normal_distances", 0.5, 0.001, kUnreal},
    {"smrt", "unreal", "own_texel_bias", 2, 1,
     "VirtualShadowMapProjectionSpot.ush, ComputeOptimalSlopeBiasLocal"},
    {"contact_shadows", "filament", "steps", 8, 1, kFilamentOptions},
    {"contact_shadows", "filament", "length_world", 0.3, 1, kFilamentOptions},
    {"contact_shadows", "filament", "thickness_steps", 1, 2, kFilament},  // within a tolerance of its middle
    {"contact_shadows", "filament", "own_plane_px", 0, 1, kFilament},
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
    {"ray_traced_svgf", "schied-2017", "samples", 1, 1, "SVGF, section 1: one path a pixel"},
    {"ray_traced_svgf", "schied-2017", "history_frames", 5, 1, "SVGF, section 4.1: 1 / alpha, which is 0.2"},
    {"ray_traced_svgf", "schied-2017", "levels", 5, 1, "SVGF, section 4.3: five iterations"},
    {"ray_traced_svgf", "schied-2017", "short_history", 4, 1, "SVGF, section 4.2: fewer than four frames"},
    {"ray_traced_svgf", "schied-2017", "sigma_depth", 1, 1, "SVGF, section 4.4"},
    {"ray_traced_svgf", "schied-2017", "sigma_normal", 128, 1, "SVGF, section 4.4"},
    {"ray_traced_svgf", "schied-2017", "sigma_visibility", 4, 1, "SVGF, section 4.4"},
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
    {"pcss", "babylon-low", "penumbra_curve", "difference"},
    {"pcss", "babylon-high", "penumbra_curve", "difference"},
    {"pcss", "godot-omni", "penumbra_curve", "ratio"},
    {"pcss", "godot-omni", "curve_base", "light"},
    {"pcf_tent", "bevy-gaussian", "size", "5x5"},
    {"pcf_tent", "bevy-gaussian", "weights", "witness"},
    {"pcf_tent", "bevy-gaussian", "normal_offset_form", "constant"},
    {"pcss", "filament-lamp", "penumbra_curve", "ratio"},
    {"pcss", "filament-lamp", "average", "harmonic"},
    {"pcf_disk", "bgfx", "bilinear", "false"},
    {"pcf_disk", "bgfx", "rotation", "gradient_noise"},
    {"pcss_map_units", "bgfx", "radius_unit", "map"},
    {"pcss_map_units", "bgfx", "drop", "stored_ratio"},
    {"pcss_map_units", "bgfx", "bilinear_taps", "false"},
    {"pcss_map_units", "filament-sun", "radius_unit", "world"},
    {"pcss_map_units", "filament-sun", "drop", "stored_ratio"},
    {"pcss_map_units", "filament-sun", "receiver_plane", "tap"},
    {"pcss_map_units", "playcanvas-sun", "radius_unit", "range"},
    {"pcss_map_units", "playcanvas-sun", "drop", "stored_drop"},
    {"pcss_map_units", "playcanvas-sun", "rotation", "white_noise"},
    {"pcss_map_units", "playcanvas-lamp", "radius_unit", "lateral"},
    {"pcss_map_units", "playcanvas-lamp", "drop", "drop"},
    {"dpcf", "filament-lamp", "radius_base", "world"},
    {"dpcf", "filament-lamp", "ratio", "distance"},
    {"dpcf", "filament-sun", "ratio", "stored_depth"},
    {"pcss_cone", "unity-hdrp", "normal_offset_form", "constant"},
    {"msm4", "peters-klein-2015", "moment_format", "rgba16"},
    {"msm4", "peters-klein-2015", "quantisation", "peters_klein_2015"},
    {"msm4", "peters-2017", "moment_format", "rgba16"},
    {"msm4", "peters-2017", "quantisation", "peters_2017"},
    {"msm4", "peters-2017-128", "moment_format", "rgba32f"},
    {"msm6", "muenstermann-2018-96", "moment_format", "rg16"},
    {"msm6", "muenstermann-2018-192", "moment_format", "rg32f"},
    {"smrt", "unreal", "ray_reach", "unreal"},
    {"smrt", "unreal", "extrapolation", "true"},
    {"smrt_cascades", "unreal", "ray_reach", "unreal"},
    {"smrt_cascades", "unreal", "extrapolation", "true"},
    {"smrt", "unreal", "receiver_plane", "none"},
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

/// How often a pixel compares the map, as the sources count it.
struct SourceCount {
  const char* technique;
  const char* preset;
  double compares_per_pixel;
  const char* where;
};

const SourceCount kCounts[] = {
    {"pcss", "paper-a", 9 + 25, "Araujo: 3 x 3 and 5 x 5"},
    {"pcss_vsm", "paper-a-7", 49 + 49, "Araujo: 7 x 7 and 7 x 7"},
    {"edge_mask", "paper-c-4-grid", 16, "Evans, Agenjo and Blat: 4 x 4"},
    {"edge_mask", "paper-c-4", 16, "Evans, Agenjo and Blat: 4 x 4"},
    {"edge_mask", "paper-c-7-grid", 49, "Evans, Agenjo and Blat: 7 x 7"},
    {"edge_mask_quantised", "paper-c-235", 25, "Evans, Agenjo and Blat: 5 x 5 in the widest band"},
    {"pcss", "paper-d", 32 + 4 * 16, "Sterna: 32 and 16 bilinear"},
    {"penumbra_mask", "paper-d", 32.0 / 16 + 4 * 16,
     "Sterna: 32 in a sixteenth of the pixels and 16 bilinear"},
    {"pcf_adaptive", "paper-e", 64, "Rzeczkowski: 8 x 8"},
    {"pcss", "paper-e", 64 + 64, "Rzeczkowski: 8 x 8 twice"},
    {"pcss_map_units", "bgfx", 16 + 16, "bgfx: 16 and 16"},
    {"pcss_map_units", "filament-sun", 16 + 4 * 16, "Filament: 16 and 16 bilinear"},
    {"dpcf", "filament-lamp", 12, "Filament: 12 for both"},
    {"smrt", "unreal", 7 * (8 + 1), "Unreal: 7 rays of 8, and the receiver"},
    {"pcss_cone", "unity-hdrp", 24 + 4 * 16, "Unity HDRP: 24 and 16 bilinear"},
};

const std::vector<Technique>& techniques() {
  static const auto all = list_techniques(source_dir() / "realtime" / "techniques");
  return all;
}

const Technique& technique_of(const std::string& id) {
  const auto found = std::ranges::find(techniques(), id, &Technique::id);
  if (found == techniques().end()) throw std::runtime_error("no technique " + id);
  return *found;
}

ParameterValue value_of(const std::string& technique, const std::string& preset,
                        const std::string& parameter) {
  return resolve_parameters(technique_of(technique), {{"preset", preset}}).at(parameter);
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

TEST(PresetSources, CompareAsOftenAsTheSources) {
  for (const SourceCount& c : kCounts) {
    const Technique& technique = technique_of(c.technique);
    const ParameterValues values = resolve_parameters(technique, {{"preset", std::string(c.preset)}});
    EXPECT_EQ(compares_per_pixel(technique, values), c.compares_per_pixel)
        << c.technique << ":" << c.preset << ", " << c.where;
  }
}

TEST(PresetSources, EveryTechniqueTellsHowOftenItCompares) {
  for (const Technique& technique : techniques()) {
    const auto of = [&](const ParameterValues& values) {
      return compares_per_pixel(technique, resolve_parameters(technique, values)).value_or(0.0);
    };
    EXPECT_GE(of({}), 1.0) << technique.id;
    for (const Preset& preset : technique.presets)
      EXPECT_GT(of({{"preset", preset.name}}), 0.0) << technique.id << ":" << preset.name;
  }
}

TEST(PresetSources, ABoxThatCoversTexelsInPartComparesThemAll) {
  const Technique& technique = technique_of("edge_mask");
  const auto of = [&](const char* shape) {
    return compares_per_pixel(technique, resolve_parameters(technique, {{"filter_shape", std::string(shape)},
                                                                        {"filter_width_texels", 4.0}}));
  };
  EXPECT_EQ(of("box"), 25.0);
  EXPECT_EQ(of("grid"), 16.0);
}

TEST(PresetSources, ChoicesAreTheSources) {
  for (const SourceChoice& c : kChoices) {
    EXPECT_EQ(to_text(value_of(c.technique, c.preset, c.parameter)), c.value)
        << c.technique << ":" << c.preset << " " << c.parameter;
  }
}

}  // namespace
}  // namespace umbrameter
