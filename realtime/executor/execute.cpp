#include "realtime/executor/execute.h"

#include "realtime/harness/context.h"
#include "realtime/harness/draw.h"

#include <algorithm>
#include <array>

namespace umbrameter {
namespace {

void bind_range(const Buffer& buffer, const UniformRange& range) {
  glBindBufferRange(GL_UNIFORM_BUFFER, range.binding, buffer.id(), range.offset, range.bytes);
}

void set_blend(const std::string& blend) {
  if (blend == "none") return;
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);  // min and max ignore it
  glBlendEquation(blend == "add" ? GL_FUNC_ADD : blend == "min" ? GL_MIN : GL_MAX);
}

void set_cull(const std::string& cull, bool mirrors) {
  if (cull == "none") return;
  glEnable(GL_CULL_FACE);
  glFrontFace(mirrors ? GL_CW : GL_CCW);
  glCullFace(cull == "back" ? GL_BACK : GL_FRONT);
}

void set_state(const PassState& state, bool mirrors) {
  set_default_state();
  set_blend(state.blend);
  set_cull(state.cull, mirrors);
  if (state.depth_clamp) glEnable(GL_DEPTH_CLAMP);
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

void draw_step(const Plan& plan, const Step& step, const SceneBuffers& scene_buffers,
               const VertexArray& empty_vertex_array) {
  const PreparedPass& pass = plan.passes[step.pass];
  const PassState& state = pass.declaration->state;
  set_state(state, step.mirrors);
  pass.framebuffer.bind();
  if (state.clear) clear_targets(pass, *state.clear);
  pass.program->use();
  for (const auto& [unit, target] : pass.textures) bind_texture(unit, *target->texture, target->sampler);
  for (const UniformRange& range : step.uniforms) bind_range(plan.uniforms, range);
  if (pass.declaration->kind == "scene") {
    scene_buffers.draw();
  } else {
    draw_fullscreen(empty_vertex_array);
  }
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
  const auto label = [&plan](size_t step) { return plan.passes[plan.steps[step].pass].label; };
  for (size_t i = 0; i < plan.steps.size(); ++i) {
    const bool starts = i == 0 || label(i - 1) != label(i);
    const bool ends = i + 1 == plan.steps.size() || label(i + 1) != label(i);
    if (watch.timers != nullptr && starts) watch.timers->begin(label(i));
    draw_step(plan, plan.steps[i], scene_buffers, empty_vertex_array);
    if (watch.timers != nullptr && ends) watch.timers->end();
    if (watch.progress != nullptr) report_step(plan, i, *watch.progress);
  }
}

}  // namespace umbrameter
