// SPDX-License-Identifier: Apache-2.0
#pragma once
// The textures and buffers a run reads and writes: those resources whose condition holds, `visibility`, and the G-buffer.

#include "realtime/executor/buffer_targets.h"

#include <map>
#include <memory>
#include <string>

namespace umbrameter {

/// A texture with the sampler it is read through. A multisampled one is drawn into and then resolved into `texture`.
struct Target {
  const Texture* texture = nullptr;
  Sampler sampler;
  const Texture* multisampled = nullptr;
  const Texture& drawn() const { return multisampled != nullptr ? *multisampled : *texture; }
};

class Targets {
 public:
  /// The technique's own textures have no memory before allocate(). Error{input} when a size is none or too large for
  /// this GL.
  Targets(const RunInputs& inputs, const ExpressionVariables& variables);

  /// Null when the run leaves the resource out. What a frame before held has names of its own, "previous.<name>".
  const Target* find(const std::string& name) const;
  /// Whether the run has a texture or a buffer of this name.
  bool has(const std::string& name) const { return find(name) != nullptr || buffers_.find(name) != nullptr; }
  /// The storage buffers, under names of the same kind.
  BufferTargets& buffers() { return buffers_; }
  const BufferTargets& buffers() const { return buffers_; }
  const Texture& visibility() const { return visibility_; }
  /// Of the technique's own resources.
  size_t declared_bytes() const;
  /// Gives the resource memory unless it has some.
  void allocate(const std::string& name);
  /// A declared resource's texture, for others to read too; null for other names, and for a multisampled depth.
  std::shared_ptr<const Texture> share(const std::string& name) const;
  /// Puts one of the same format and shape in the place of a texture that share() gives.
  void replace(const std::string& name, std::shared_ptr<const Texture> texture);

 private:
  void add_resource(const ResourceDeclaration& resource, const std::string& name,
                    const ExpressionVariables& variables);

  Texture visibility_;
  BufferTargets buffers_;
  using Textures = std::map<std::string, std::shared_ptr<const Texture>, std::less<>>;
  Textures owned_;
  Textures multisampled_;
  std::map<std::string, Target, std::less<>> targets_;
};

}  // namespace umbrameter
