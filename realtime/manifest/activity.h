// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which parameters act on a picture, given the others and the light: the manifest's `when`.

#include "realtime/graph/expression.h"
#include "realtime/manifest/technique.h"

namespace umbrameter {

/// light.width and height (full extent in world units; sun: 2 tan(half angle)), light.type, and light.rect, light.disk,
/// light.sphere, light.sun to compare it with.
ExpressionVariables light_variables(const Light& light);

/// Whether `parameter` of `technique` acts on a picture beside `values` (complete) under `light`; true without a `when`.
bool is_active(const Technique& technique, const Parameter& parameter, const ParameterValues& values,
               const Light& light);

}  // namespace umbrameter
