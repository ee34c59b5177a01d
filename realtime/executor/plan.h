// SPDX-License-Identifier: Apache-2.0
#pragma once
// A run as a flat list of draws: loops unrolled, programs compiled, textures made, all uniform data in one
// buffer. Executing it only binds and draws.

#include "realtime/executor/prepare_pass.h"
#include "realtime/executor/run_views.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

/// A range of the plan's uniform buffer.
struct UniformRange {
  GLuint binding = 0;
  GLintptr offset = 0;
  GLsizeiptr bytes = 0;
};

/// A part of the targets, in texels of the level written; row 0 is the bottom one.
struct Viewport {
  int x = 0, y = 0, width = 0, height = 0;
};

struct Step {
  size_t pass = 0;    // in Plan::passes
  bool once = false;  // in the first frame only, untimed
  std::vector<UniformRange> uniforms;
  bool mirrors = false;
  std::array<float, 2> polygon_offset{};       // factor, units
  std::optional<Viewport> viewport;            // of a pass that draws into a part of its targets
  std::array<GLuint, 3> groups{};              // of a compute pass
  GLbitfield barriers = 0;                     // before it
  int vertices = 0;                            // that each triangle is drawn with and pulls; 0: its own three
  std::shared_ptr<const IndexRanges> casters;  // of a scene pass; none: every triangle
  std::shared_ptr<const InstanceSelection> instances;  // of a scene pass; none: all of them
  bool is_kept = false;  // what it would write is there from an earlier run: not drawn
};

struct Plan {
  std::unique_ptr<Targets> targets;
  std::vector<PreparedPass> passes;
  std::vector<Step> steps;
  GLbitfield last_barriers = 0;              // after a frame
  std::vector<std::string> labels;           // of timers
  std::vector<UniformRange> frame_uniforms;  // the first is FrameData's
  std::optional<UniformRange> history_uniforms;
  Buffer uniforms;
  std::vector<std::byte> uniform_bytes;   // what is in it
  std::vector<FittedView> center_views;   // from the light's centre: one map, or a family's
  std::optional<FittedView> sample_view;  // of the first sample, where maps are drawn from many
  std::vector<std::string> warnings;      // the GLSL compiler's
  uint64_t culled_triangles = 0, scene_pass_triangles = 0;  // over all scene passes of a frame
};

/// More draws than this are refused.
inline constexpr size_t kMaxSteps = size_t{1} << 18;

/// Error{input} for sizes, counts and shaders that do not work.
Plan make_plan(const RunInputs& inputs, ProgramCache& programs);

/// Of the textures that a plan declares and the scene's data that its passes read, each counted once.
size_t memory_bytes(const Plan& plan);

/// Gives memory to the textures of all steps that are to be drawn, and binds it: before the first frame.
void attach(Plan& plan);

}  // namespace umbrameter
