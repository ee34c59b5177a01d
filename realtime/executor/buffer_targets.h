// SPDX-License-Identifier: Apache-2.0
#pragma once
// The storage buffers a run reads and writes: those whose condition holds.

#include "realtime/executor/run_inputs.h"

#include <map>
#include <memory>
#include <span>
#include <string>

namespace umbrameter {

struct BufferTarget {
  const ElementType* element = nullptr;
  size_t count = 0;
  std::shared_ptr<const Buffer> buffer;  // null before allocate()
  size_t bytes() const { return count * element->bytes(); }
};

class BufferTargets {
 public:
  /// None has memory yet. Error{input} for a count that is none or too large for this GL.
  BufferTargets(const RunInputs& inputs, const ExpressionVariables& variables);

  /// Null when the run leaves it out. What a frame before held is called "previous.<name>".
  const BufferTarget* find(const std::string& name) const;
  /// Of all of them.
  size_t bytes() const;
  /// Gives the buffer memory, zeros, unless it has some. Other names are ignored.
  void allocate(const std::string& name);
  /// Puts another run's buffer of the same size in the place of `name`.
  void replace(const std::string& name, std::shared_ptr<const Buffer> buffer);

 private:
  void add(const BufferDeclaration& declaration, const std::string& name,
           const ExpressionVariables& variables);

  std::map<std::string, BufferTarget, std::less<>> targets_;
};

/// Sets every component to `values`, the last one repeated: in GL's command stream, without a copy from the host.
void clear_buffer(const BufferTarget& target, std::span<const double> values);

/// One row, a pixel per element: channel Y, or R, G, B, A; four pixels for a matrix, its columns. Integers become floats.
Image read_elements(const BufferTarget& target);

}  // namespace umbrameter
