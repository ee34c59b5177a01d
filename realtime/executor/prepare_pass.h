#pragma once
// A pass made ready to draw: its program compiled, its targets and textures at hand.

#include "realtime/executor/targets.h"
#include "realtime/harness/program.h"

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace umbrameter {

/// A pass with everything that is the same in all its iterations.
struct PreparedPass {
  const PassDeclaration* declaration = nullptr;
  std::shared_ptr<const Program> program;
  Framebuffer framebuffer;
  std::vector<const TextureFormat*> color_formats;
  bool has_depth = false;
  std::vector<std::pair<GLuint, const Target*>> textures;  // by unit
  size_t label = 0;                                        // in Plan::labels
};

/// `loop_variables`: of the loops around the pass, outermost first. Leaves `label` at 0. Error{input} for
/// targets that are left out or differ in size, and for shaders that do not compile.
PreparedPass prepare_pass(const PassDeclaration& pass, const RunInputs& inputs, const Targets& targets,
                          std::span<const std::string> loop_variables, ProgramCache& programs);

}  // namespace umbrameter
