// SPDX-License-Identifier: Apache-2.0
#include "core/error.h"
#include "realtime/harness/context.h"
#include "realtime/harness/timers.h"

#include <array>
#include <functional>

namespace umbrameter {

namespace {

using WallClock = std::chrono::steady_clock;

struct Measured {
  double query_ms = 0.0;
  double wall_ms = 0.0;
};

Measured measure(const std::function<void()>& work) {
  const Query query = make_query(GL_TIME_ELAPSED);
  glFinish();
  const WallClock::time_point start = WallClock::now();
  glBeginQuery(GL_TIME_ELAPSED, query.id());
  work();
  glEndQuery(GL_TIME_ELAPSED);
  glFinish();
  const double wall_ms = std::chrono::duration<double, std::milli>(WallClock::now() - start).count();
  GLuint64 nanoseconds = 0;
  glGetQueryObjectui64v(query.id(), GL_QUERY_RESULT, &nanoseconds);
  return {static_cast<double>(nanoseconds) * 1e-6, wall_ms};
}

bool claims_too_much(const Measured& measured) {
  constexpr double kClockStep_ms = 0.01;
  return measured.query_ms > 1.05 * measured.wall_ms + kClockStep_ms;
}

bool clears_are_believable() {
  for (int i = 0; i < 3; ++i) {
    if (claims_too_much(measure([] { glClear(GL_COLOR_BUFFER_BIT); }))) return false;
    if (claims_too_much(measure([] {}))) return false;
  }
  return true;
}

/// Points that all fall outside the clip volume: nothing but vertex work.
GlHandle<destroy_program> make_point_program() {
  constexpr const char* kText =
      "#version 450 core\n"
      "void main() { gl_Position = vec4(3.0 + abs(sin(float(gl_VertexID))), 0.0, 0.0, 1.0); }\n";
  const GLuint shader = glCreateShader(GL_VERTEX_SHADER);
  glShaderSource(shader, 1, &kText, nullptr);
  glCompileShader(shader);
  GlHandle<destroy_program> program(glCreateProgram());
  glAttachShader(program.id(), shader);
  glLinkProgram(program.id());
  glDeleteShader(shader);
  return program;
}

bool long_draw_is_counted() {
  constexpr double kLong_ms = 5.0;
  constexpr GLsizei kMostPoints = 1 << 26;
  const GlHandle<destroy_program> program = make_point_program();
  const VertexArray no_attributes = make_empty_vertex_array();
  glUseProgram(program.id());
  glBindVertexArray(no_attributes.id());
  Measured measured;
  for (GLsizei points = 1 << 12; points <= kMostPoints && measured.wall_ms < kLong_ms; points *= 4) {
    measured = measure([points] { glDrawArrays(GL_POINTS, 0, points); });
  }
  return !claims_too_much(measured) && measured.query_ms > 0.5 * measured.wall_ms;
}

}  // namespace

TimerKind choose_timer() {
  const Texture texture(find_texture_format("rgba32f"), 256, 256, "timer check");
  const std::array<const Texture*, 1> colors = {&texture};
  const Framebuffer framebuffer(colors, nullptr);  // without a window there is no other to draw to
  framebuffer.bind();
  const bool is_good = clears_are_believable() && long_draw_is_counted();
  glUseProgram(0);
  glBindVertexArray(0);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  check_gl_errors("checking the timer");
  return is_good ? TimerKind::elapsed_query : TimerKind::finish_and_clock;
}

}  // namespace umbrameter
