// SPDX-License-Identifier: Apache-2.0
#include "lab/timing.h"

#include "core/guard.h"
#include "lab/renamed_progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace umbrameter {
namespace {

constexpr uint64_t kResidentBytes = uint64_t{2} << 30;
constexpr double kWarmUpMs = 50.0;  // until clocks and caches have settled
constexpr int kMaxWarmUpFrames = 16;

/// A run between its first frame and its last one.
struct LiveRun {
  PreparedRun prepared;
  TimedRun& result;
  int64_t frames = 0;  // still to be timed
};

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Warms up; frames to time then. A frame beyond the budget is the only one.
int64_t plan_frames(LiveRun& run, const TimingPlan& plan) {
  const double budget_ms = 1000.0 * plan.budget_s;
  double spent_ms = 0.0;
  double frame_ms = 0.0;
  for (int i = 0; i < kMaxWarmUpFrames && spent_ms < kWarmUpMs; ++i) {
    std::vector<double> times_ms = run.prepared.time_frame();
    frame_ms = sum(times_ms);
    spent_ms += frame_ms;
    if (frame_ms < budget_ms) continue;
    run.result.times.frames_ms.push_back(std::move(times_ms));
    return 0;
  }
  const double affordable = budget_ms / std::max(frame_ms, 1e-6);
  return std::max<int64_t>(1, static_cast<int64_t>(std::min<double>(affordable, plan.wanted_frames)));
}

/// Frames of a run with `frames` of them in the rounds up to `round` of `rounds`: spread evenly.
int64_t frames_until(int64_t round, int64_t rounds, int64_t frames) {
  return round * frames / rounds;
}

void time_group(std::vector<LiveRun>& group, const TimingPlan& plan, Progress& progress) {
  if (group.empty()) return;
  for (LiveRun& run : group) {
    run.result.failure = guarded([&] { run.frames = plan_frames(run, plan); });
  }
  int64_t rounds = 0;
  int64_t all_frames = 0;
  for (const LiveRun& run : group) {
    rounds = std::max(rounds, run.frames);
    all_frames += run.frames;
  }
  progress.begin(fmt::format("timing {} runs in turn", group.size()), static_cast<uint64_t>(all_frames));
  for (int64_t round = 0; round < rounds; ++round) {
    for (LiveRun& run : group) {
      if (run.result.failure) continue;
      if (frames_until(round + 1, rounds, run.frames) == frames_until(round, rounds, run.frames)) continue;
      run.result.failure = guarded([&] { run.result.times.frames_ms.push_back(run.prepared.time_frame()); });
      progress.advance(1);
    }
  }
  progress.end();
  group.clear();
}

}  // namespace

std::vector<TimedRun> render_interleaved(Renderer& renderer, const Scene& scene,
                                         std::span<const LabelledRequest> requests, const TimingPlan& plan,
                                         Progress& progress, const FirstFrame& first_frame) {
  std::vector<TimedRun> results(requests.size());
  std::vector<LiveRun> group;
  uint64_t resident_bytes = 0;
  for (size_t i = 0; i < requests.size(); ++i) {
    TimedRun& result = results[i];
    RenamedProgress renamed(progress, [&](std::string_view) { return requests[i].label; });
    result.failure = guarded([&] {
      const bool is_timed = plan.wanted_frames > 0;
      PreparedRun prepared;
      if (is_timed) {
        prepared = renderer.prepare(scene, requests[i].request, renamed);
      } else {
        prepared.frame = renderer.render(scene, requests[i].request, renamed);
      }
      result.frame = std::move(prepared.frame);
      if (first_frame) first_frame(i, result.frame);
      if (!prepared.time_frame) return;
      result.times.passes = prepared.passes;
      result.timer = prepared.timer;
      resident_bytes += result.frame.memory_bytes;
      group.push_back({std::move(prepared), result});
    });
    if (resident_bytes < kResidentBytes) continue;
    time_group(group, plan, progress);
    resident_bytes = 0;
  }
  time_group(group, plan, progress);
  return results;
}

}  // namespace umbrameter
