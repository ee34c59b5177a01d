// SPDX-License-Identifier: Apache-2.0
#pragma once
// `[[pass]]`: what is drawn, in the order it runs.

#include "realtime/graph/expression.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

enum class PassKind {
  scene,       // every triangle
  fullscreen,  // one triangle over the target
  mipmap,      // the further levels of what it writes
  loop,        // its own passes, again and again
  compute      // groups of threads
};
enum class CullMode { none, back, front };
enum class BlendMode { none, add, min, max };
enum class BlendFactor {
  zero,
  one,
  source_color,
  one_minus_source_color,
  target_color,
  one_minus_target_color,
  source_alpha,
  one_minus_source_alpha
};
/// Against what is stored, in reversed depth: greater is nearer.
enum class CompareFunction { never, less, less_or_equal, equal, unequal, greater_or_equal, greater, always };
enum class StencilAction {
  keep,
  zero,
  replace,
  increment,  // as far as 255
  increment_wrap,
  decrement,  // as far as 0
  decrement_wrap,
  invert
};

/// What becomes of the stencil under the faces of one side.
struct StencilFace {
  StencilAction fail = StencilAction::keep;        // the stencil's test
  StencilAction depth_fail = StencilAction::keep;  // the depth's
  StencilAction pass = StencilAction::keep;
};

struct StencilState {
  CompareFunction test = CompareFunction::always;  // of `reference` with what is stored
  int reference = 0;
  int mask = 255;
  StencilFace front, back;
};

/// Fixed-function state of a pass.
struct PassState {
  CullMode cull = CullMode::none;
  BlendMode blend = BlendMode::none;
  std::array<BlendFactor, 2> blend_factors{BlendFactor::one,
                                           BlendFactor::one};  // of what is drawn, what is there
  std::array<bool, 4> writes_channel{true, true, true, true};
  std::optional<CompareFunction> depth_test;  // greater in scene passes, always in fullscreen ones
  bool depth_write = true;
  std::optional<std::array<Expression, 2>> polygon_offset;  // glPolygonOffset's factor and units
  std::optional<StencilState> stencil;
  std::optional<int> clear_stencil;
  std::optional<std::vector<double>> clear;           // clear every written target first
  std::optional<std::array<Expression, 4>> viewport;  // x, y, width, height in texels: clears and draws there
  bool depth_clamp = true;
  int clip_distances = 0;  // gl_ClipDistance[0 .. n-1] that the vertex shader writes
};

struct PassDeclaration {
  std::string id;
  PassKind kind = PassKind::fullscreen;
  std::string view;              // scene: view to render from
  Expression view_index;         // which member when that is a family of views
  std::string vertex, fragment;  // files in the folder or in shaders/; scene passes may leave fragment empty
  Expression vertices;  // scene: that each triangle is drawn with, without attributes; empty: its own three
  std::string compute;  // compute: the shader's file
  std::vector<Expression> groups;   // compute: along x, y, z; 1 to 3 of them, the rest 1
  bool overwrites = false;          // compute: writes every element and texel, and reads none of them
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
