// SPDX-License-Identifier: Apache-2.0
#pragma once
// What makes any pass's vertex shader draw instances, without its knowing.

#include <string>

namespace umbrameter {

/// Put at the end of a pass's own prelude, with that of cut-outs if it `has_holes`: the shader's vertex then stands where its
/// instance does. Its text goes through with_placed_vertices().
std::string instance_vertex_prelude(bool has_holes);

/// `text` whose declaration `layout(location = 0) in vec3 NAME;` is replaced, so that NAME is set by that prelude. Error{input}
/// naming `file` where the text does not hold exactly one.
std::string with_placed_vertices(const std::string& text, const std::string& file);

}  // namespace umbrameter
