// SPDX-License-Identifier: Apache-2.0
#pragma once
// A pass made ready to draw: its program compiled, its targets and textures at hand.

#include "realtime/executor/targets.h"
#include "realtime/harness/program.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace umbrameter {

/// A texture as a pass binds it.
struct BoundTexture {
  GLuint unit = 0;
  const Texture* texture = nullptr;
  const Sampler* sampler = nullptr;
};

/// A multisampled target and the texture that takes its mean.
struct Resolve {
  Framebuffer from, to;
};

/// A pass with everything that is the same in all its iterations that write the same level.
struct PreparedPass {
  const PassDeclaration* declaration = nullptr;
  int write_level = 0;
  std::shared_ptr<const Program> program;
  std::shared_ptr<const Program>
      cutout_program;  // of a scene pass: the same for triangles with holes, if there are any
  Framebuffer framebuffer;
  std::vector<const TextureFormat*> color_formats;
  bool has_depth = false;
  /// The library's vertex shader projects every triangle by the pass's view and nothing else, and no stage asks which
  /// triangle it is: what the view clips may be left out.
  bool may_cull_casters = false;
  std::vector<BoundTexture> textures;
  std::vector<std::unique_ptr<Texture>> level_views;  // of textures that are written too
  std::vector<Resolve> resolves;                      // after drawing
  std::vector<const Texture*> mipmaps;                // textures whose further levels a mipmap pass makes
  size_t label = 0;                                   // in Plan::labels
};

/// `loop_variables`: of the loops around the pass, outermost first. Leaves `label` at 0. Error{input} for
/// targets that are left out or differ in size, for levels they do not have, and for shaders that do not
/// compile.
PreparedPass prepare_pass(const PassDeclaration& pass, int write_level, const RunInputs& inputs,
                          const Targets& targets, std::span<const std::string> loop_variables,
                          ProgramCache& programs);

}  // namespace umbrameter
