// SPDX-License-Identifier: Apache-2.0
#pragma once
// What passes of every kind are made ready with. Private to realtime/executor.

#include "realtime/executor/prelude.h"
#include "realtime/executor/prepare_pass.h"

namespace umbrameter {

/// Error{input} when the run has left it out.
const Target& written_target(const PassDeclaration& pass, const std::string& name, const Targets& targets);

/// Error{input} for a level or layer that the target has not.
void require_place(const PassDeclaration& pass, const WritePlace& place, const std::string& name,
                   const Texture& texture);

/// Error{input} for reads that no shader can do.
void require_readable(const PreparedPass& prepared, const Targets& targets);

PreludeInputs prelude_inputs(const PassDeclaration& pass, const RunInputs& inputs, const Targets& targets,
                             const PassSurroundings& around);

/// What the pass reads of the scene, made where nobody has before.
void take_scene_data(PreparedPass& prepared, const RunInputs& inputs);

/// The textures and buffers that the pass's shaders see, which must have memory.
void take_reads(PreparedPass& prepared, const Targets& targets);

}  // namespace umbrameter
