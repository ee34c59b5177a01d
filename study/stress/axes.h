// SPDX-License-Identifier: Apache-2.0
#pragma once
// The table of all axes, with those of techniques' parameters. Not here: those that alter a scene
// (scenes/altered/stress/axes.h), and what a suite chooses of them (study/stress/suite_file.h).

#include "scenes/altered/stress/axis.h"

#include <string>
#include <vector>

namespace umbrameter {

/// Parameters and formats of techniques on the nominal scene.
std::vector<StressAxis> technique_axes();

/// Placement, lights, geometry, meshes, cameras, techniques.
std::vector<StressAxis> stress_axes();

/// Error{input} with the nearest name for an unknown one.
StressAxis find_stress_axis(const std::string& name);

/// Any parameter on the nominal scene; the first value is nominal.
StressAxis parameter_axis(const std::string& parameter, std::vector<StressValue> values);

}  // namespace umbrameter
