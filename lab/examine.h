// SPDX-License-Identifier: Apache-2.0
#pragma once
// A picture as the gate sees it (metrics/gate.h).

#include "core/image.h"
#include "metrics/faults/faults.h"
#include "metrics/gate.h"
#include "metrics/metric_probe.h"

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace umbrameter {

/// What the gate saw of a picture.
struct Examined {
  GateRun run;
  std::vector<uint8_t> mask;              // scored pixels; empty when void
  std::vector<FaultClass> fault_classes;  // [height][width]; empty when void
};

Examined examine(const Image& picture, const Image& truth, const glm::dvec3& eye_world,
                 const ErrorMetric& metric = error_metric);

}  // namespace umbrameter
