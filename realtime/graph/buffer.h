// SPDX-License-Identifier: Apache-2.0
#pragma once
// `[[resource]]` with kind = "buffer": a list of numbers, vectors or matrices that shaders share.

#include "realtime/graph/expression.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace umbrameter {

enum class ElementScalar { real, integer, unsigned_integer };

/// What a buffer holds in each place. Four bytes a component, without gaps in GLSL's std430.
struct ElementType {
  std::string_view glsl;  // how manifests and shaders call it
  ElementScalar scalar = ElementScalar::real;
  int components = 1;  // 16: a matrix of four columns
  size_t bytes() const { return size_t{4} * static_cast<size_t>(components); }
};

/// None of three components: std430 pads them to four.
std::span<const ElementType> element_types();
/// Error{input} at `where` with a spelling hint when there is no such type.
const ElementType& find_element_type(std::string_view name, const FileLocation& where = {});

struct BufferDeclaration {
  std::string name;
  const ElementType* element = nullptr;
  Expression count;
  Expression condition;
  FileLocation where;
};

}  // namespace umbrameter
