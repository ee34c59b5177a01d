// SPDX-License-Identifier: Apache-2.0
#include "realtime/executor/plan.h"

#include "realtime/executor/barriers.h"
#include "realtime/executor/compute.h"
#include "realtime/executor/pass_parts.h"
#include "realtime/executor/prelude.h"
#include "realtime/harness/frame_uniforms.h"
#include "realtime/manifest/names.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <set>

namespace umbrameter {
namespace {

/// Collects uniform blocks, each at an offset every GL accepts (256 is the largest alignment allowed).
class UniformStore {
 public:
  UniformRange add(GLuint binding, const void* data, size_t bytes) {
    constexpr size_t kAlignment = 256;
    constexpr size_t kBlockUnit = 16;  // std140 rounds a block's size up to a vec4
    const size_t offset = bytes_.size();
    const size_t block_bytes = (bytes + kBlockUnit - 1) / kBlockUnit * kBlockUnit;
    bytes_.resize(offset + (block_bytes + kAlignment - 1) / kAlignment * kAlignment);
    std::memcpy(bytes_.data() + offset, data, bytes);
    return {binding, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(block_bytes)};
  }
  Buffer upload() const { return Buffer(bytes_.size(), bytes_.data()); }
  std::vector<std::byte> take_bytes() { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
};

struct Loop {
  std::string variable;
  int64_t index = 0;
  int64_t count = 0;
};

class Planner {
 public:
  Planner(const RunInputs& inputs, ProgramCache& programs)
      : inputs_(inputs), programs_(programs), views_(inputs), variables_(run_variables(inputs)) {
    plan_.targets = std::make_unique<Targets>(inputs, variables_);
  }

  Plan make() {
    FrameData frame =
        make_frame_data(inputs_.scene, inputs_.gbuffer.width(), inputs_.gbuffer.height(), inputs_.seed);
    frame.receiver_plane_world = glm::vec4(inputs_.receiver_plane_world);
    plan_.frame_uniforms.push_back(store_.add(kFrameBinding, &frame, sizeof(frame)));
    const std::vector<std::byte> parameters = parameter_block(inputs_.technique, inputs_.values);
    if (!parameters.empty()) {
      plan_.frame_uniforms.push_back(store_.add(kParameterBinding, parameters.data(), parameters.size()));
    }
    add_history();
    add_passes(inputs_.technique.passes);
    require_visibility();
    plan_.uniforms = store_.upload();
    plan_.uniform_bytes = store_.take_bytes();
    plan_.center_views = views_.center();
    plan_.sample_view = views_.first_sample();
    return std::move(plan_);
  }

 private:
  void add_history() {
    if (!inputs_.technique.has_history()) return;
    const Camera& previous =
        inputs_.previous_camera == nullptr ? inputs_.scene.camera : *inputs_.previous_camera;
    const HistoryData history =
        make_history_data(previous, inputs_.frame, inputs_.gbuffer.width(), inputs_.gbuffer.height());
    plan_.history_uniforms = store_.add(kHistoryBinding, &history, sizeof(history));
  }

  void add_passes(const std::vector<PassDeclaration>& passes) {
    for (const PassDeclaration& pass : passes) {
      if (!holds(pass.condition, variables_)) continue;
      if (pass.kind == PassKind::loop) {
        add_loop(pass);
      } else {
        add_step(pass);
      }
    }
  }

  void add_loop(const PassDeclaration& pass) {
    const auto count = whole_number(pass.loop_count, variables_, 0, static_cast<int64_t>(kMaxSteps),
                                    fmt::format("count of loop '{}'", pass.id));
    variables_[pass.loop_variable + "_count"] = static_cast<double>(count);
    loops_.push_back({pass.loop_variable, 0, count});
    for (int64_t index = 0; index < count; ++index) {
      variables_[pass.loop_variable] = static_cast<double>(index);
      loops_.back().index = index;
      add_passes(pass.body);
    }
    loops_.pop_back();
    variables_.erase(pass.loop_variable);
    variables_.erase(pass.loop_variable + "_count");
  }

  void add_step(const PassDeclaration& pass) {
    if (plan_.steps.size() == kMaxSteps) {
      fail_input(
          fmt::format("technique '{}' would draw more than {} passes", inputs_.technique.id, kMaxSteps),
          pass.where, "lower a loop's count");
    }
    Step step;
    step.pass = prepared_index(
        pass, {chosen(pass, pass.write_level, "write_level"), chosen(pass, pass.write_layer, "write_layer")});
    step.once = pass.once;
    if (const auto& offset = pass.state.polygon_offset) {
      for (size_t k = 0; k < 2; ++k)
        step.polygon_offset[k] = static_cast<float>((*offset)[k].evaluate(variables_));
    }
    step.viewport = viewport_of(pass, plan_.passes[step.pass].place.level);
    step.vertices = vertices_of(pass);
    if (pass.kind == PassKind::compute) step.groups = group_counts(pass, variables_);
    add_loop_block(step);
    GLuint binding = kFirstViewBinding;
    for (const std::string& name : pass_views(pass)) {
      std::span<const FittedView> views = views_.get(name, variables_);
      if (name == pass.view && !pass.view_index.is_empty())
        views = views.subspan(member(pass, views.size()), 1);
      step.uniforms.push_back(view_range(binding++, views));
      if (name != pass.view) continue;
      const FittedView& fitted = views.front();
      step.mirrors = fitted.mirrors;
      if (pass.kind == PassKind::scene) add_casters(step, fitted, pass.state.depth_clamp);
    }
    plan_.steps.push_back(std::move(step));
  }

  void add_loop_block(Step& step) {
    if (loops_.empty()) return;
    std::vector<int32_t> values;
    for (const Loop& loop : loops_) {
      values.push_back(static_cast<int32_t>(loop.index));
      values.push_back(static_cast<int32_t>(loop.count));
    }
    step.uniforms.push_back(store_.add(kLoopBinding, values.data(), values.size() * sizeof(int32_t)));
  }

  /// Error{input} where it is empty or reaches outside the level that the pass writes.
  std::optional<Viewport> viewport_of(const PassDeclaration& pass, int level) const {
    if (!pass.state.viewport) return std::nullopt;
    const auto& [x, y, width, height] = *pass.state.viewport;
    const Texture& target = written_target(pass, pass.writes.front(), *plan_.targets).drawn();
    const auto [left, across] = part_of(pass, x, width, "width", level_side(target.width(), level));
    const auto [bottom, up] = part_of(pass, y, height, "height", level_side(target.height(), level));
    return Viewport{left, bottom, across, up};
  }

  /// Where a viewport begins along one axis, and how far it goes.
  std::pair<int, int> part_of(const PassDeclaration& pass, const Expression& from, const Expression& extent,
                              std::string_view side, int target_texels) const {
    const std::string what = fmt::format("viewport of pass '{}'", pass.id);
    constexpr int64_t kMost = std::numeric_limits<int>::max();
    const int64_t begin = whole_number(from, variables_, 0, kMost, what);
    const int64_t texels = whole_number(extent, variables_, 1, kMost, what);
    if (begin + texels > target_texels)
      fail_input(fmt::format("{} covers texels {} to {} of '{}', whose {} is {}", what, begin, begin + texels,
                             pass.writes.front(), side, target_texels),
                 from.where(), "viewport = [x, y, width, height] lies inside what the pass writes");
    return {static_cast<int>(begin), static_cast<int>(texels)};
  }

  int vertices_of(const PassDeclaration& pass) const {
    if (pass.vertices.is_empty()) return 0;
    const auto most = static_cast<int64_t>(std::numeric_limits<GLsizei>::max()) /
                      static_cast<int64_t>(std::max<uint64_t>(inputs_.scene_buffers.triangle_count(), 1));
    return static_cast<int>(whole_number(pass.vertices, variables_, 1, std::min<int64_t>(most, 1024),
                                         fmt::format("vertices of pass '{}'", pass.id)));
  }

  size_t member(const PassDeclaration& pass, size_t count) const {
    return static_cast<size_t>(whole_number(pass.view_index, variables_, 0, static_cast<int64_t>(count) - 1,
                                            fmt::format("view_index of pass '{}'", pass.id)));
  }

  UniformRange view_range(GLuint binding, std::span<const FittedView> views) {
    const auto [known, is_new] = view_ranges_.try_emplace({views.data(), views.size()});
    if (is_new) {
      std::vector<LightViewData> data;
      for (const FittedView& view : views) data.push_back(view.data);
      known->second = store_.add(0, data.data(), data.size() * sizeof(LightViewData));
    }
    UniformRange range = known->second;
    range.binding = binding;
    return range;
  }

  void add_casters(Step& step, const FittedView& fitted, bool clamps_depth) {
    plan_.scene_pass_triangles += inputs_.scene_buffers.triangle_count();
    if (!plan_.passes[step.pass].may_cull_casters) return;
    if (!inputs_.casters.empty()) {
      auto& known = casters_[{&fitted, clamps_depth}];
      if (known == nullptr) {
        known =
            std::make_shared<const IndexRanges>(casters_in_view(inputs_.casters, fitted.view, clamps_depth));
      }
      step.casters = known;
      plan_.culled_triangles += inputs_.scene.triangles.size() - known->triangle_count();
    }
    if (!inputs_.instance_boxes.empty()) add_instances(step, fitted, clamps_depth);
  }

  void add_instances(Step& step, const FittedView& fitted, bool clamps_depth) {
    const InstanceBuffers& instances = *inputs_.scene_buffers.instances();
    auto& known = instances_[{&fitted, clamps_depth}];
    if (known == nullptr) {
      const glm::dmat4 clip_from_world =
          glm::dmat4(fitted.view.clip_from_light) * glm::dmat4(fitted.view.light_from_world);
      known = std::make_shared<const InstanceSelection>(
          instances.select(instances_in_view(inputs_.instance_boxes, clip_from_world, clamps_depth)));
    }
    step.instances = known;
    plan_.culled_triangles += instances.all().triangles - known->triangles;
  }

  /// The level or layer that the pass writes; 0 where it says none.
  int chosen(const PassDeclaration& pass, const Expression& expression, std::string_view key) const {
    if (expression.is_empty()) return 0;
    return static_cast<int>(whole_number(expression, variables_, 0, std::numeric_limits<int>::max(),
                                         fmt::format("{} of pass '{}'", key, pass.id)));
  }

  size_t prepared_index(const PassDeclaration& pass, const WritePlace& place) {
    const auto found = std::ranges::find_if(plan_.passes, [&](const PreparedPass& prepared) {
      return prepared.declaration == &pass && prepared.place == place;
    });
    if (found != plan_.passes.end()) return static_cast<size_t>(found - plan_.passes.begin());
    plan_.passes.push_back(prepare(pass, place));
    return plan_.passes.size() - 1;
  }

  PreparedPass prepare(const PassDeclaration& pass, const WritePlace& place) {
    PassSurroundings around;
    for (const Loop& loop : loops_) around.loop_variables.push_back(loop.variable);
    around.vertices = vertices_of(pass);
    for (const std::string& name : pass.views) around.view_counts[name] = views_.get(name, variables_).size();
    PreparedPass prepared = prepare_pass(pass, place, inputs_, *plan_.targets, around, programs_);
    take_scene_data(prepared, inputs_);
    if (prepared.program) add_warnings(*prepared.program);
    if (!pass.once) prepared.label = label_index(pass.timer.empty() ? pass.id : pass.timer);
    return prepared;
  }

  void add_warnings(const Program& program) {
    for (const std::string& warning : program.warnings()) {
      if (std::ranges::find(plan_.warnings, warning) == plan_.warnings.end())
        plan_.warnings.push_back(warning);
    }
  }

  size_t label_index(const std::string& label) {
    const auto found = std::ranges::find(plan_.labels, label);
    if (found != plan_.labels.end()) return static_cast<size_t>(found - plan_.labels.begin());
    plan_.labels.push_back(label);
    return plan_.labels.size() - 1;
  }

  void require_visibility() const {
    for (const PreparedPass& pass : plan_.passes) {
      if (std::ranges::find(pass.declaration->writes, kVisibility) != pass.declaration->writes.end()) return;
    }
    fail_input(
        fmt::format("technique '{}' writes no 'visibility' with these parameters", inputs_.technique.id),
        {(inputs_.technique.folder / "technique.toml").string(), 0, 0},
        "the conditions leave out every pass that would");
  }

  const RunInputs& inputs_;
  ProgramCache& programs_;
  RunViews views_;
  ExpressionVariables variables_;
  UniformStore store_;
  std::map<std::pair<const FittedView*, size_t>, UniformRange> view_ranges_;
  std::map<std::pair<const FittedView*, bool>, std::shared_ptr<const IndexRanges>>
      casters_;  // bool: clamped depth
  std::map<std::pair<const FittedView*, bool>, std::shared_ptr<const InstanceSelection>>
      instances_;  // as casters_
  std::vector<Loop> loops_;
  Plan plan_;
};

}  // namespace

Plan make_plan(const RunInputs& inputs, ProgramCache& programs) {
  return Planner(inputs, programs).make();
}

size_t memory_bytes(const Plan& plan) {
  std::set<const Buffer*> buffers;
  for (const PreparedPass& pass : plan.passes)
    for (const BoundBuffer& bound : pass.scene_data) buffers.insert(bound.buffer);
  size_t bytes = plan.targets->declared_bytes();
  for (const Buffer* buffer : buffers) bytes += buffer->bytes();
  return bytes;
}

void attach(Plan& plan) {
  std::vector<bool> is_drawn(plan.passes.size(), false);
  for (const Step& step : plan.steps) is_drawn[step.pass] = is_drawn[step.pass] || !step.is_kept;
  for (size_t i = 0; i < is_drawn.size(); ++i) {
    if (!is_drawn[i]) continue;
    const PassDeclaration& pass = *plan.passes[i].declaration;
    for (const auto* names : {&pass.reads, &pass.writes}) {
      for (const std::string& name : *names) plan.targets->allocate(name);
    }
  }
  for (size_t i = 0; i < is_drawn.size(); ++i) {
    if (is_drawn[i]) attach_pass(plan.passes[i], *plan.targets);
  }
  place_barriers(plan);
}

}  // namespace umbrameter
