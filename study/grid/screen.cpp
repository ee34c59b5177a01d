// SPDX-License-Identifier: Apache-2.0
#include "study/grid/screen.h"

#include "core/guard.h"

#include <algorithm>
#include <map>
#include <set>

namespace umbrameter {
namespace {

/// The runs of a technique that share all values but one parameter's.
struct Line {
  std::string technique;
  std::string parameter;
  std::vector<size_t> runs;  // by value
};

/// Runs that share what is left of their parameters without `name` are one line.
std::vector<Line> lines_of(const SweepPlan& plan, const std::string& technique, const std::string& name) {
  std::map<std::pair<uint64_t, ParameterValues>, Line> lines;
  for (size_t i = 0; i < plan.runs.size(); ++i) {
    const BenchRun& run = plan.runs[i];
    if (run.technique.technique != technique) continue;
    ParameterValues others = run.technique.parameters;
    others.erase(name);
    Line& line = lines[{run.seed, std::move(others)}];
    line.runs.push_back(i);
  }
  std::vector<Line> all;
  for (auto& [others, line] : lines) {
    if (line.runs.size() < 2) continue;
    line.technique = technique;
    line.parameter = name;
    std::ranges::sort(line.runs, {}, [&](size_t i) { return plan.runs[i].technique.parameters.at(name); });
    all.push_back(std::move(line));
  }
  return all;
}

std::set<std::pair<std::string, std::string>> varied(const SweepPlan& plan) {
  std::map<std::pair<std::string, std::string>, std::set<ParameterValue>> values;
  for (const BenchRun& run : plan.runs) {
    for (const auto& [name, value] : run.technique.parameters)
      values[{run.technique.technique, name}].insert(value);
  }
  std::set<std::pair<std::string, std::string>> found;
  for (const auto& [parameter, different] : values) {
    if (different.size() > 1) found.insert(parameter);
  }
  return found;
}

bool look_alike(const Scene& scene, const BenchRun& one, const BenchRun& other, Renderer& realtime,
                Progress& progress) {
  const auto picture = [&](const BenchRun& run) {
    const RenderRequest request{kScreenWidth_px, kScreenHeight_px, run.seed, run.technique.technique,
                                run.technique.parameters};
    return realtime.render(scene, request, progress).image.planes.at("visibility");
  };
  bool are_alike = false;
  const auto failure = guarded([&] { are_alike = picture(one) == picture(other); });
  return !failure && are_alike;
}

double saved_s(std::span<const PlanStep> steps, size_t scene, std::span<const size_t> runs) {
  double sum_s = 0.0;
  for (const PlanStep& step : steps) {
    if (step.scene == scene && step.run && std::ranges::find(runs, *step.run) != runs.end())
      sum_s += step.estimated_s;
  }
  return sum_s;
}

}  // namespace

std::vector<IdleParameter> screen_parameters(const SweepPlan& plan, std::span<const StudyScene> scenes,
                                             std::span<const PlanStep> steps, Renderer& realtime,
                                             Progress& progress) {
  std::vector<IdleParameter> idle;
  const auto parameters = varied(plan);
  progress.begin("screening parameters", parameters.size() * scenes.size());
  for (size_t scene = 0; scene < scenes.size(); ++scene) {
    SilentProgress silent;
    for (const auto& [technique, parameter] : parameters) {
      progress.advance(1);
      const std::vector<Line> lines = lines_of(plan, technique, parameter);
      if (lines.empty()) continue;
      const Line& first = lines.front();
      const BenchRun &low = plan.runs[first.runs.front()], &high = plan.runs[first.runs.back()];
      if (skip_reason(low.technique, scenes[scene].scene)) continue;
      if (!look_alike(scenes[scene].scene, low, high, realtime, silent)) continue;
      IdleParameter found{scene, low.technique.id, parameter};
      for (const Line& line : lines) {
        const std::span<const size_t> spare(line.runs.begin() + 1, line.runs.end());
        found.runs += spare.size();
        found.saved_s += saved_s(steps, scene, spare);
      }
      idle.push_back(found);
    }
  }
  progress.end();
  return idle;
}

}  // namespace umbrameter
