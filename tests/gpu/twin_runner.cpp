// SPDX-License-Identifier: Apache-2.0
#include "tests/gpu/twin_runner.h"

#include "realtime/harness/objects.h"
#include "realtime/harness/program.h"
#include "tests/gpu/gl_test.h"
#include "tests/support/temporary_folder.h"

#include <fmt/format.h>
#include <filesystem>
#include <fstream>

namespace umbrameter::test {
namespace {

namespace fs = std::filesystem;

constexpr int kGroupSize = 64;

std::string compute_shader(const std::string& include, const std::string& expression) {
  return fmt::format(R"(#include "{}"
layout(local_size_x = {}) in;
layout(std430, binding = 0) readonly buffer Inputs {{ vec4 inputs[]; }};
layout(std430, binding = 1) writeonly buffer Outputs {{ vec4 outputs[]; }};
void main() {{
  if (gl_GlobalInvocationID.x >= inputs.length()) return;
  vec4 x = inputs[gl_GlobalInvocationID.x];
  outputs[gl_GlobalInvocationID.x] = {};
}}
)",
                     include, kGroupSize, expression);
}

std::vector<glm::vec4> dispatch(const Program& program, std::span<const glm::vec4> inputs) {
  std::vector<glm::vec4> outputs(inputs.size());
  const Buffer input_buffer = Buffer::of(inputs);
  const Buffer output_buffer(inputs.size_bytes(), nullptr);
  program.use();
  bind_storage_buffer(0, input_buffer);
  bind_storage_buffer(1, output_buffer);
  glDispatchCompute(static_cast<GLuint>((inputs.size() + kGroupSize - 1) / kGroupSize), 1, 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glGetNamedBufferSubData(output_buffer.id(), 0, static_cast<GLsizeiptr>(inputs.size_bytes()),
                          outputs.data());
  check_gl_errors("twin");
  return outputs;
}

}  // namespace

std::vector<glm::vec4> run_glsl(const std::string& include, const std::string& expression,
                                std::span<const glm::vec4> inputs) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "twin.comp";
  std::ofstream(file) << compute_shader(include, expression);
  const fs::path search[] = {shaders_folder() / "lib", shaders_folder() / "shared"};
  const ShaderFile stage{ShaderStage::compute, file, "#include \"frame_data.h\"\n"};
  const Program program({&stage, 1}, search);
  return dispatch(program, inputs);
}

}  // namespace umbrameter::test
