// SPDX-License-Identifier: Apache-2.0
#include "study/stress/axes.h"

#include "core/error.h"
#include "core/names.h"
#include "scenes/altered/stress/axes.h"

#include <iterator>

namespace umbrameter {

std::vector<StressAxis> stress_axes() {
  std::vector<StressAxis> all;
  for (const auto family :
       {placement_axes, light_axes, geometry_axes, mesh_axes, camera_axes, technique_axes}) {
    std::vector<StressAxis> axes = family();
    std::move(axes.begin(), axes.end(), std::back_inserter(all));
  }
  return all;
}

StressAxis find_stress_axis(const std::string& name) {
  std::vector<std::string> known;
  for (StressAxis& axis : stress_axes()) {
    if (axis.name == name) return axis;
    known.push_back(axis.name);
  }
  fail_input(fmt::format("there is no stress axis '{}'", name), {}, suggest_name(name, known));
}

}  // namespace umbrameter
