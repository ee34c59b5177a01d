// SPDX-License-Identifier: Apache-2.0
#pragma once
// Runs a GLSL expression over a list of inputs on the GPU, to compare library functions with their C++ twins.

#include <glm/vec4.hpp>

#include <span>
#include <string>
#include <vector>

namespace umbrameter::test {

/// One result per input. `include` is a file of realtime/shaders/lib; `expression` is GLSL of type vec4 in
/// which `x` is the input. Needs a current context.
std::vector<glm::vec4> run_glsl(const std::string& include, const std::string& expression,
                                std::span<const glm::vec4> inputs);

}  // namespace umbrameter::test
