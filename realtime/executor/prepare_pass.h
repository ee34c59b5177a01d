// SPDX-License-Identifier: Apache-2.0
#pragma once
// A pass made ready to draw: its program compiled, its targets and textures at hand.

#include "realtime/executor/targets.h"
#include "realtime/harness/program.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace umbrameter {

/// A texture as a pass binds it.
struct BoundTexture {
  GLuint unit = 0;
  const Texture* texture = nullptr;
  const Sampler* sampler = nullptr;
};

/// A storage buffer as a pass binds it.
struct BoundBuffer {
  GLuint binding = 0;
  const Buffer* buffer = nullptr;
};

/// A level of a texture, all its layers, as a compute pass stores into it.
struct BoundImage {
  GLuint unit = 0;
  const Texture* texture = nullptr;
};

/// A multisampled target and the texture that takes its mean.
struct Resolve {
  Framebuffer from, to;
};

/// Which part of its targets a pass writes.
struct WritePlace {
  int level = 0;
  int layer = 0;  // of those that have layers
  bool operator==(const WritePlace&) const = default;
};

/// A pass with everything that is the same in all its iterations that write the same place.
struct PreparedPass {
  const PassDeclaration* declaration = nullptr;
  WritePlace place;
  std::shared_ptr<const Program> program;
  std::shared_ptr<const Program>
      cutout_program;  // of a scene pass: the same for triangles with holes, if there are any
  std::shared_ptr<const Program> instance_program, instance_cutout_program;  // the same for instances
  Framebuffer framebuffer;
  std::vector<const TextureFormat*> color_formats;
  bool has_depth = false;
  /// The library's vertex shader projects every triangle by the pass's view and nothing else, and no stage asks which
  /// triangle it is: what the view clips may be left out.
  bool may_cull_casters = false;
  std::vector<BoundTexture> textures;
  std::vector<BoundBuffer> buffers;
  std::vector<BoundImage> images;
  std::vector<BufferTarget> written_buffers;          // of a compute pass
  std::vector<BoundBuffer> scene_data;                // that it reads
  std::vector<std::unique_ptr<Texture>> level_views;  // of textures that are written too
  std::vector<Resolve> resolves;                      // after drawing
  std::vector<const Texture*> mipmaps;                // textures whose further levels a mipmap pass makes
  size_t label = 0;                                   // in Plan::labels
};

/// What a pass's shaders see besides the technique's own things.
struct PassSurroundings {
  std::vector<std::string> loop_variables;    // of the loops around it, outermost first
  std::map<std::string, size_t> view_counts;  // of the views it lists: 1, or a family's
  int vertices = 0;                           // Step::vertices
};

/// Leaves `label` at 0, and the textures to attach_pass. Error{input} for targets that are left out or differ in size, for
/// levels and layers they do not have, and for shaders that do not compile.
PreparedPass prepare_pass(const PassDeclaration& pass, const WritePlace& place, const RunInputs& inputs,
                          const Targets& targets, const PassSurroundings& around, ProgramCache& programs);

/// Makes the framebuffer and takes the textures, which must have memory.
void attach_pass(PreparedPass& prepared, const Targets& targets);

}  // namespace umbrameter
