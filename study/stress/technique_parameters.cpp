// SPDX-License-Identifier: Apache-2.0
#include "scenes/altered/stress/stage_text.h"
#include "study/stress/axes.h"

#include <fmt/format.h>

#include <cmath>

namespace umbrameter {
namespace {

/// The nominal scene with `assignments` over its parameters.
StressPoint with_parameters(const std::vector<std::string>& assignments) {
  StressPoint point = point_of(nominal_stage());
  for (const std::string& assignment : assignments) {
    const std::string name = assignment.substr(0, assignment.find('=') + 1);
    std::erase_if(point.assignments, [&](const std::string& other) { return other.starts_with(name); });
    point.assignments.push_back(assignment);
  }
  return point;
}

StressPoint map_size_point(const StressValue& value) {
  return with_parameters({"map_size=" + value.text});
}

// A grid has as many taps as its side squared.
StressPoint taps_point(const StressValue& value) {
  const int side = static_cast<int>(std::sqrt(value.number) + 0.5);
  return with_parameters({"taps=" + value.text, "filter_taps=" + value.text, "search_taps=" + value.text,
                          "light_samples=" + value.text, fmt::format("grid_taps={}", side)});
}

StressPoint exponent_point(const StressValue& value) {
  return with_parameters({"exponent=" + value.text});
}

StressPoint log_exponent_point(const StressValue& value) {
  return with_parameters({"exponent=" + value.text, "form=log_space"});
}

StressPoint evsm_point(const StressValue& value) {
  return with_parameters({"positive_exponent=" + value.text});
}

StressPoint kernel_point(const StressValue& value) {
  return with_parameters({"map_size=16", "filter_width_texels=" + value.text, "radius_texels=" + value.text,
                          "width_1_texels=" + value.text, "width_2_texels=" + value.text,
                          "width_3_texels=" + value.text});
}

// The kernel follows the light, so the light must grow.
StressPoint light_kernel_point(const StressValue& value) {
  StageScene stage = nominal_stage();
  stage.light_size_world = value.number;
  StressPoint point = point_of(stage);
  point.assignments = {"map_size=16"};
  return point;
}

// A mat that hides its shadow from a bias of its thickness.
StressPoint bias_point(const StressValue& value) {
  StageScene stage = nominal_stage();
  stage.meshes.push_back({"shape = \"plate\"\nsize = [1.2, 1.2]\nthickness = 0.05\n", {1.2, 0.15, 0.4}});
  StressPoint point = with_parameters({"bias_texels=" + value.text});
  point.scene = to_toml(stage);
  return point;
}

StressPoint depth_point(const StressValue& value) {
  StressPoint point = with_parameters({});
  if (value.text != "depth32f") point.edits = {{"\"depth32f\"", "\"" + value.text + "\""}};
  return point;
}

StressPoint stored_point(const StressValue& value) {
  StressPoint point = with_parameters({});
  if (value.text == "32f") return point;
  for (const char* channels : {"r", "rg", "rgba"})
    point.edits.push_back(
        {fmt::format("\"{}32f\"", channels), fmt::format("\"{}{}\"", channels, value.text)});
  return point;
}

}  // namespace

StressAxis parameter_axis(const std::string& parameter, std::vector<StressValue> values) {
  return {.name = parameter,
          .unit = "",
          .doc = "The parameter of that name.",
          .values = std::move(values),
          .needs_parameter = {parameter},
          .point = [parameter](const StressValue& value) {
            return with_parameters({parameter + "=" + value.text});
          }};
}

std::vector<StressAxis> technique_axes() {
  return {
      {.name = "map_size",
       .unit = "texels",
       .doc = "Side of the shadow map.",
       .values = numbers({8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192, 16384}),
       .nominal = 6,
       .needs_parameter = {"map_size"},
       .point = map_size_point},
      {.name = "taps",
       .unit = "taps",
       .doc = "Map reads of a filter and of a search; samples of the light.",
       .values = numbers({1024, 256, 64, 16, 4, 1}),
       .nominal = 3,
       .needs_parameter = {"taps", "filter_taps", "grid_taps", "light_samples"},
       .point = taps_point},
      {.name = "kernel_width",
       .unit = "texels",
       .doc = "Width or radius of a fixed filter over a map 16 wide.",
       .values = numbers({1, 3, 5, 9, 17, 33, 65, 129}),
       .nominal = 1,
       .needs_parameter = {"filter_width_texels", "radius_texels", "width_1_texels"},
       .point = kernel_point},
      {.name = "light_kernel",
       .unit = "world",
       .doc = "Side of the light over a map 16 wide, for filters that follow it.",
       .values = numbers({0.3, 1, 3, 10, 100}),
       .nominal = 0,
       .needs_parameter = {"filter_taps"},
       .point = light_kernel_point},
      {.name = "bias_texels",
       .unit = "texels",
       .doc = "Constant bias: too little shadows lit surfaces, too much detaches shadows.",
       .values = numbers({0, 0.01, 0.1, 0.3, 1, 3, 10, 32, 33}),
       .nominal = 2,
       .needs_parameter = {"bias_texels"},
       .point = bias_point},
      {.name = "esm_exponent",
       .unit = "1",
       .doc = "c of exp(c z), stored as it is.",
       .values = numbers({1, 10, 40, 80, 88, 89, 100, 1000}),
       .nominal = 3,
       .needs_parameter = {"exponent"},
       .point = exponent_point},
      {.name = "log_exponent",
       .unit = "1",
       .doc = "The same in log space.",
       .values = numbers({1, 10, 40, 80, 200, 500, 1000, 2000}),
       .nominal = 3,
       .needs_parameter = {"exponent"},
       .point = log_exponent_point},
      {.name = "evsm_exponent",
       .unit = "1",
       .doc = "The positive warp's exponent; above 44 its square overflows a float.",
       .values = numbers({0.01, 1, 5, 15, 30, 40, 42, 43, 44.5, 100}),
       .nominal = 5,
       .needs_parameter = {"positive_exponent"},
       .point = evsm_point},
      {.name = "depth_format",
       .unit = "",
       .doc = "Format of every depth map.",
       .values = words({"depth32f", "depth24", "depth16"}),
       .needs_parameter = {"map_size"},
       .point = depth_point},
      {.name = "stored_format",
       .unit = "",
       .doc = "Format of moments, exponentials, masks and coarse maps; 8 bits hold 0 to 1.",
       .values = words({"32f", "16f", "8"}),
       .needs_parameter = {},
       .point = stored_point},
  };
}

}  // namespace umbrameter
