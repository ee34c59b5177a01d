// SPDX-License-Identifier: Apache-2.0
#pragma once
// The table of axes, by family. Not here: what a suite chooses of them (study/stress/suite_file.h).

#include "study/stress/axis.h"

#include <string>
#include <vector>

namespace umbrameter {

/// Where the scene lies and how large it is.
std::vector<StressAxis> placement_axes();
std::vector<StressAxis> light_axes();
std::vector<StressAxis> geometry_axes();
/// Meshes that are not as they should be.
std::vector<StressAxis> mesh_axes();
std::vector<StressAxis> camera_axes();
/// Parameters and formats of techniques on the nominal scene.
std::vector<StressAxis> technique_axes();

/// All of them, in this order.
std::vector<StressAxis> stress_axes();

/// Error{input} with the nearest name for an unknown one.
StressAxis find_stress_axis(const std::string& name);

/// Any parameter on the nominal scene; the first value is nominal.
StressAxis parameter_axis(const std::string& parameter, std::vector<StressValue> values);

}  // namespace umbrameter
