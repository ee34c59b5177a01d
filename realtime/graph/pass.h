// SPDX-License-Identifier: Apache-2.0
#pragma once
// `[[pass]]`: what is drawn, in the order it runs.

#include "realtime/graph/expression.h"

#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

enum class PassKind {
  scene,       // every triangle
  fullscreen,  // one triangle over the target
  mipmap,      // the further levels of what it writes
  loop         // its own passes, again and again
};
enum class CullMode { none, back, front };
enum class BlendMode { none, add, min, max };

/// Fixed-function state of a pass.
struct PassState {
  CullMode cull = CullMode::none;
  BlendMode blend = BlendMode::none;
  std::optional<std::vector<double>> clear;  // clear every written target first
  bool depth_clamp = true;
  int clip_distances = 0;  // gl_ClipDistance[0 .. n-1] that the vertex shader writes
};

struct PassDeclaration {
  std::string id;
  PassKind kind = PassKind::fullscreen;
  std::string view;              // scene: view to render from
  Expression view_index;         // which member when that is a family of views
  std::string vertex, fragment;  // files in the folder or in shaders/; scene passes may leave fragment empty
  std::vector<std::string> reads;   // resource names or built-ins (gbuffer.position, ...)
  std::vector<std::string> writes;  // resource names, or "visibility"
  std::vector<std::string> views;   // views whose block the shaders see
  PassState state;
  Expression write_level;  // level of the written resources; 0 when left out
  Expression write_layer;  // layer of those that have layers
  bool once = false;       // drawn in the first frame of a run only: depends on parameters alone
  Expression condition;    // run only when this is left out or not 0
  std::string timer;       // label that timings are summed under; the id when empty
  std::string loop_variable;
  Expression loop_count;
  std::vector<PassDeclaration> body;  // loop only
  FileLocation where;
};

}  // namespace umbrameter
