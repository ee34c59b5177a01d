// SPDX-License-Identifier: Apache-2.0
#pragma once
// Compute passes: how they are made ready, bound and run. What they store others see through barriers.h.

#include "realtime/executor/prepare_pass.h"

#include <array>

namespace umbrameter {

/// As prepare_pass() of a compute pass.
PreparedPass prepare_compute(const PassDeclaration& pass, const WritePlace& place, const RunInputs& inputs,
                             const Targets& targets, const PassSurroundings& around, ProgramCache& programs);

/// As attach_pass().
void attach_compute(PreparedPass& prepared, const Targets& targets);

/// Work groups along each axis. Error{input} at an expression that gives none, or more than this device runs.
std::array<GLuint, 3> group_counts(const PassDeclaration& pass, const ExpressionVariables& variables);

/// Clears what the pass says it clears.
void clear_written(const PreparedPass& prepared);

/// Binds the images and runs the program, which must be in use, with all that it reads bound.
void dispatch(const PreparedPass& prepared, const std::array<GLuint, 3>& groups);

}  // namespace umbrameter
