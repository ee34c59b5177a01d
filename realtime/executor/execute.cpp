// SPDX-License-Identifier: Apache-2.0
#include "realtime/executor/execute.h"

#include "realtime/executor/compute.h"
#include "realtime/executor/pass_state.h"
#include "realtime/harness/context.h"
#include "realtime/harness/draw.h"

#include <algorithm>
#include <array>

namespace umbrameter {
namespace {

void bind_range(const Buffer& buffer, const UniformRange& range) {
  glBindBufferRange(GL_UNIFORM_BUFFER, range.binding, buffer.id(), range.offset, range.bytes);
}

/// On around one pass's draw only, so that every other pass need not turn them off.
void set_clip_distances(const PassState& state, bool is_on) {
  for (int i = 0; i < state.clip_distances; ++i) {
    const GLenum distance = GL_CLIP_DISTANCE0 + static_cast<GLenum>(i);
    is_on ? glEnable(distance) : glDisable(distance);
  }
}

/// Colours take the given values, the last one repeated. Depth takes the first one in a pass without colours
/// and is otherwise cleared to far, which is 0.
void clear_targets(const PreparedPass& pass, const std::vector<double>& values) {
  std::array<GLfloat, 4> color{};
  std::array<GLuint, 4> integers{};
  for (size_t k = 0; k < color.size(); ++k) {
    const double value = values[std::min(k, values.size() - 1)];
    color[k] = static_cast<GLfloat>(value);
    integers[k] = static_cast<GLuint>(static_cast<int64_t>(value));
  }
  for (size_t k = 0; k < pass.color_formats.size(); ++k) {
    const auto attachment = static_cast<GLint>(k);
    if (pass.color_formats[k]->is_integer) {
      glClearNamedFramebufferuiv(pass.framebuffer.id(), GL_COLOR, attachment, integers.data());
    } else {
      glClearNamedFramebufferfv(pass.framebuffer.id(), GL_COLOR, attachment, color.data());
    }
  }
  const GLfloat depth = pass.color_formats.empty() ? color[0] : 0.0f;
  if (pass.has_depth) glClearNamedFramebufferfv(pass.framebuffer.id(), GL_DEPTH, 0, &depth);
}

/// Scissors hold clears and everything drawn to the part; the viewport alone does so to neither.
void set_viewport(const Viewport& part) {
  glViewport(part.x, part.y, part.width, part.height);
  glScissor(part.x, part.y, part.width, part.height);
  glEnable(GL_SCISSOR_TEST);
}

void clear_stencil(const PreparedPass& pass, GLint value) {
  glStencilMask(0xff);
  glClearNamedFramebufferiv(pass.framebuffer.id(), GL_STENCIL, 0, &value);
}

/// The mean over each texel's samples.
void resolve(const Resolve& targets) {
  const int width = targets.to.width();
  const int height = targets.to.height();
  glBlitNamedFramebuffer(targets.from.id(), targets.to.id(), 0, 0, width, height, 0, 0, width, height,
                         GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void draw_instances(const PreparedPass& pass, const Step& step, const SceneBuffers& scene_buffers) {
  if (!pass.instance_program) return;
  const InstanceBuffers& instances = *scene_buffers.instances();
  const InstanceSelection& drawn = step.instances ? *step.instances : instances.all();
  pass.instance_program->use();
  instances.draw(drawn);
  if (!pass.instance_cutout_program) return;
  pass.instance_cutout_program->use();
  scene_buffers.cutouts()->bind_storage();
  instances.draw_cutouts(drawn);
}

/// So many vertices a triangle, which pull from the scene's storage buffers.
void draw_pulled(const PreparedPass& pass, const Step& step, const SceneBuffers& scene_buffers) {
  scene_buffers.bind_storage();
  set_clip_distances(pass.declaration->state, true);
  scene_buffers.draw_pulled(step.vertices);
  if (pass.instance_program) {
    pass.instance_program->use();
    scene_buffers.instances()->draw_pulled(scene_buffers.instances()->all(), step.vertices);
  }
  set_clip_distances(pass.declaration->state, false);
}

/// The program and all that its shaders read.
void bind_inputs(const Plan& plan, const Step& step, const SceneBuffers& scene_buffers) {
  const PreparedPass& pass = plan.passes[step.pass];
  pass.program->use();
  for (const BoundTexture& bound : pass.textures) bind_texture(bound.unit, *bound.texture, *bound.sampler);
  if (!pass.scene_data.empty()) scene_buffers.bind_storage();  // cut-outs and instances too
  for (const BoundBuffer& bound : pass.scene_data) bind_storage_buffer(bound.binding, *bound.buffer);
  for (const BoundBuffer& bound : pass.buffers) bind_storage_buffer(bound.binding, *bound.buffer);
  for (const UniformRange& range : step.uniforms) bind_range(plan.uniforms, range);
}

void run_compute(const Plan& plan, const Step& step, const SceneBuffers& scene_buffers) {
  const PreparedPass& pass = plan.passes[step.pass];
  clear_written(pass);
  bind_inputs(plan, step, scene_buffers);
  dispatch(pass, step.groups);
}

void draw_pass(const Plan& plan, const Step& step, const SceneBuffers& scene_buffers,
               const VertexArray& empty_vertex_array) {
  const PreparedPass& pass = plan.passes[step.pass];
  const PassDeclaration& declaration = *pass.declaration;
  set_default_state();
  pass.framebuffer.bind();
  if (step.viewport) set_viewport(*step.viewport);
  if (declaration.state.clear) clear_targets(pass, *declaration.state.clear);
  if (declaration.state.clear_stencil) clear_stencil(pass, *declaration.state.clear_stencil);
  set_pass_state(declaration, step);
  bind_inputs(plan, step, scene_buffers);
  if (step.vertices > 0) {
    draw_pulled(pass, step, scene_buffers);
  } else if (declaration.kind == PassKind::scene) {
    set_clip_distances(declaration.state, true);
    step.casters ? scene_buffers.draw(*step.casters) : scene_buffers.draw();
    if (pass.cutout_program) {
      pass.cutout_program->use();
      scene_buffers.cutouts()->draw();
    }
    draw_instances(pass, step, scene_buffers);
    set_clip_distances(declaration.state, false);
  } else {
    draw_fullscreen_tested(empty_vertex_array);
  }
  glDisable(GL_SCISSOR_TEST);  // which would hold blits, too
  for (const Resolve& targets : pass.resolves) resolve(targets);
}

/// What a pass does stands together in a graphics debugger's list.
class DebugGroup {
 public:
  explicit DebugGroup(const std::string& name) {
    glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, static_cast<GLsizei>(name.size()), name.data());
  }
  ~DebugGroup() { glPopDebugGroup(); }
  DebugGroup(const DebugGroup&) = delete;
  DebugGroup& operator=(const DebugGroup&) = delete;
};

void draw_step(const Plan& plan, const Step& step, const SceneBuffers& scene_buffers,
               const VertexArray& empty_vertex_array) {
  const PreparedPass& pass = plan.passes[step.pass];
  const DebugGroup group(pass.declaration->id);
  if (step.barriers != 0) glMemoryBarrier(step.barriers);
  switch (pass.declaration->kind) {
    case PassKind::scene:
    case PassKind::fullscreen:
      return draw_pass(plan, step, scene_buffers, empty_vertex_array);
    case PassKind::compute:
      return run_compute(plan, step, scene_buffers);
    case PassKind::mipmap:
      for (const Texture* texture : pass.mipmaps) glGenerateTextureMipmap(texture->id());
      return;
    case PassKind::loop:
      break;
  }
  UMBRAMETER_ASSERT(false, "pass '{}' is a loop, which plans unroll", pass.declaration->id);
}

/// GL runs behind the calls: waiting now and then keeps the progress honest.
void report_step(const Plan& plan, size_t step, Progress& progress) {
  constexpr size_t kStepsBetweenWaits = 16;
  check_gl_errors(fmt::format("pass '{}'", plan.passes[plan.steps[step].pass].declaration->id));
  if (step % kStepsBetweenWaits == kStepsBetweenWaits - 1) glFinish();
  progress.advance(1);
}

}  // namespace

void draw_frame(const Plan& plan, const SceneBuffers& scene_buffers, const VertexArray& empty_vertex_array,
                const FrameWatch& watch) {
  for (const UniformRange& range : plan.frame_uniforms) bind_range(plan.uniforms, range);
  if (plan.history_uniforms) bind_range(plan.uniforms, *plan.history_uniforms);
  if (watch.is_first) {
    for (const Step& step : plan.steps) {
      if (step.once && !step.is_kept) draw_step(plan, step, scene_buffers, empty_vertex_array);
    }
  }
  constexpr size_t kNone = static_cast<size_t>(-1);
  size_t running = kNone;
  for (size_t i = 0; i < plan.steps.size(); ++i) {
    if (plan.steps[i].once) continue;
    if (plan.steps[i].is_kept) {
      if (watch.progress != nullptr) watch.progress->advance(1);
      continue;
    }
    const size_t label = plan.passes[plan.steps[i].pass].label;
    if (watch.timers != nullptr && label != running) {
      if (running != kNone) watch.timers->end();
      watch.timers->begin(label);
      running = label;
    }
    draw_step(plan, plan.steps[i], scene_buffers, empty_vertex_array);
    if (watch.progress != nullptr) report_step(plan, i, *watch.progress);
  }
  if (plan.last_barriers != 0) glMemoryBarrier(plan.last_barriers);
  if (running != kNone) watch.timers->end();
}

}  // namespace umbrameter
