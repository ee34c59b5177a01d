// SPDX-License-Identifier: Apache-2.0
#pragma once
// The textures a run reads and writes: those resources whose condition holds, `visibility`, and the G-buffer.

#include "realtime/executor/run_inputs.h"

#include <map>
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
  /// Error{input} when a size is none or too large for this GL.
  Targets(const RunInputs& inputs, const ExpressionVariables& variables);

  /// Null when the run leaves the resource out.
  const Target* find(const std::string& name) const;
  const Texture& visibility() const { return visibility_; }
  /// Of the technique's own resources.
  size_t declared_bytes() const;

 private:
  void add_resource(const ResourceDeclaration& resource, const ExpressionVariables& variables);

  Texture visibility_;
  std::map<std::string, Texture, std::less<>> owned_;
  std::map<std::string, Texture, std::less<>> multisampled_;
  std::map<std::string, Target, std::less<>> targets_;
};

}  // namespace umbrameter
