// SPDX-License-Identifier: Apache-2.0
#include "realtime/executor/pass_state.h"

#include <utility>

namespace umbrameter {
namespace {

GLenum gl_factor(BlendFactor factor) {
  switch (factor) {
    case BlendFactor::zero:
      return GL_ZERO;
    case BlendFactor::one:
      return GL_ONE;
    case BlendFactor::source_color:
      return GL_SRC_COLOR;
    case BlendFactor::one_minus_source_color:
      return GL_ONE_MINUS_SRC_COLOR;
    case BlendFactor::target_color:
      return GL_DST_COLOR;
    case BlendFactor::one_minus_target_color:
      return GL_ONE_MINUS_DST_COLOR;
    case BlendFactor::source_alpha:
      return GL_SRC_ALPHA;
    case BlendFactor::one_minus_source_alpha:
      return GL_ONE_MINUS_SRC_ALPHA;
  }
  return GL_ONE;
}

void blend_by(GLenum equation, const PassState& state) {
  glEnable(GL_BLEND);
  glBlendFunc(gl_factor(state.blend_factors[0]), gl_factor(state.blend_factors[1]));  // min and max ignore it
  glBlendEquation(equation);
}

void set_blend(const PassState& state) {
  switch (state.blend) {
    case BlendMode::none:
      return;
    case BlendMode::add:
      return blend_by(GL_FUNC_ADD, state);
    case BlendMode::min:
      return blend_by(GL_MIN, state);
    case BlendMode::max:
      return blend_by(GL_MAX, state);
  }
}

GLenum gl_function(CompareFunction function) {
  switch (function) {
    case CompareFunction::never:
      return GL_NEVER;
    case CompareFunction::less:
      return GL_LESS;
    case CompareFunction::less_or_equal:
      return GL_LEQUAL;
    case CompareFunction::equal:
      return GL_EQUAL;
    case CompareFunction::unequal:
      return GL_NOTEQUAL;
    case CompareFunction::greater_or_equal:
      return GL_GEQUAL;
    case CompareFunction::greater:
      return GL_GREATER;
    case CompareFunction::always:
      return GL_ALWAYS;
  }
  return GL_ALWAYS;
}

GLenum gl_action(StencilAction action) {
  switch (action) {
    case StencilAction::keep:
      return GL_KEEP;
    case StencilAction::zero:
      return GL_ZERO;
    case StencilAction::replace:
      return GL_REPLACE;
    case StencilAction::increment:
      return GL_INCR;
    case StencilAction::increment_wrap:
      return GL_INCR_WRAP;
    case StencilAction::decrement:
      return GL_DECR;
    case StencilAction::decrement_wrap:
      return GL_DECR_WRAP;
    case StencilAction::invert:
      return GL_INVERT;
  }
  return GL_KEEP;
}

/// `mirrors`: windings are seen reversed, and so are the sides of faces.
void set_stencil(const StencilState& stencil, bool mirrors) {
  glEnable(GL_STENCIL_TEST);
  glFrontFace(mirrors ? GL_CW : GL_CCW);
  glStencilFunc(gl_function(stencil.test), stencil.reference, static_cast<GLuint>(stencil.mask));
  glStencilMask(static_cast<GLuint>(stencil.mask));
  for (const auto& [side, face] : {std::pair(GL_FRONT, stencil.front), std::pair(GL_BACK, stencil.back)})
    glStencilOpSeparate(side, gl_action(face.fail), gl_action(face.depth_fail), gl_action(face.pass));
}

void set_cull(CullMode cull, bool mirrors) {
  if (cull == CullMode::none) return;
  glEnable(GL_CULL_FACE);
  glFrontFace(mirrors ? GL_CW : GL_CCW);
  glCullFace(cull == CullMode::back ? GL_BACK : GL_FRONT);
}

}  // namespace

void set_pass_state(const PassDeclaration& pass, const Step& step) {
  const PassState& state = pass.state;
  set_blend(state);
  set_cull(state.cull, step.mirrors);
  if (state.depth_clamp) glEnable(GL_DEPTH_CLAMP);
  const CompareFunction usual =
      pass.kind == PassKind::scene ? CompareFunction::greater : CompareFunction::always;
  glDepthFunc(gl_function(state.depth_test.value_or(usual)));
  if (!state.depth_write) glDepthMask(GL_FALSE);
  const auto& [red, green, blue, alpha] = state.writes_channel;
  glColorMask(red, green, blue, alpha);
  if (state.stencil) set_stencil(*state.stencil, step.mirrors);
  if (!state.polygon_offset) return;
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(step.polygon_offset[0], step.polygon_offset[1]);
}

}  // namespace umbrameter
