// SPDX-License-Identifier: Apache-2.0
#include "study/tune/tune.h"

#include "core/clock.h"
#include "core/error.h"
#include "core/guard.h"
#include "study/tune/after_search.h"
#include "study/tune/candidates.h"
#include "study/tune/settle.h"
#include "study/tune/windows.h"

#include <algorithm>
#include <map>

namespace umbrameter {
namespace {

constexpr double kCoarseShare = 0.5;  // of the search's evaluations and time
// Of the time, until when the search goes on: so long that what comes after it can be measured.
constexpr double kLeastSearchShare = 0.5;  // of what the windows left
constexpr double kMostSearchShare = 0.7;
constexpr double kTunedWindowsShare = 0.8;
constexpr double kOwnCost =
    2.0;  // of a preset with taps and a map of its own, in pictures at the defaults' cost
constexpr size_t kTunedWindowPoints = 8;  // of a window whose ends are nearly known
constexpr size_t kHeldOutPerScene = 2 * kHeldOutShares.size();
constexpr size_t kKept = 5;  // coarse trials that are tried at full size

size_t default_evaluations(size_t axes) {
  return 25 + 5 * axes;
}

TuneHead head_of(const TunePlan& plan) {
  return {plan.technique.id, plan.technique.hash, plan.is_engine,      plan.parameters,
          plan.objective,    plan.full.width_px,  plan.full.height_px, plan.seed};
}

class Tuning {
 public:
  Tuning(std::span<SceneJob> scenes, const TunePlan& plan, Renderer& realtime, Progress& progress)
      : scenes_(scenes),
        plan_(plan),
        progress_(progress),
        start_(Clock::now()),
        space_(choose_search_space(plan.parameters, plan.tuned, plan.technique.id)),
        candidates_(make_candidates(plan, space_)),
        studio_(realtime, plan.technique, plan.seed, progress, plan.kept) {}

  /// Windows first, then the optimum, then what it competes with: whatever the time, what is asked most is there.
  TuneResult run() {
    result_.head = head_of(plan_);
    result_.notes = plan_.notes;
    Judge judge(studio_, searched_views(plan_.full), plan_.objective, base());
    start_search_ = Clock::now();
    result_.texel_world = median_texel_world(studio_, judge.views().front(), base());
    result_.windows = windows(judge, base(), 1.0);
    search_share_ = find_search_share(judge.views().size());
    std::optional<Judge> checked = plan_.cameras > 1 ? judge_elsewhere(judge, kCheckedShares) : std::nullopt;
    progress_.begin("tuning " + plan_.technique.id, evaluations());
    SearchResult found = search(judge);
    const ParameterValues kept = settle(space_, found, by_hand(), judge, checked ? &*checked : nullptr);
    found.best = {kept, point_of(space_, kept), judge.ratio(kept)};
    result_.evaluations = result_.coarse_evaluations + judge.evaluations();
    progress_.end();
    result_.best.name = "tuned";
    result_.best.values = kept;
    result_.full_trials = found.trials;
    result_.is_converged = found.is_converged;
    find_tuned_windows(judge);
    std::optional<Judge> held_out = judge_elsewhere(judge, kHeldOutShares);
    if (!held_out) result_.notes.push_back("no held-out score: no other camera sees enough");
    compare(judge, held_out, true);
    explain(judge, found);
    compare(judge, held_out, false);
    if (plan_.grid_steps > 0)
      result_.grid = check_grid(judge, space_, plan_.is_active, base(), plan_.grid_steps);
    for (const SceneJob& job : scenes_) result_.scenes.push_back(job.name);
    for (const Parameter& axis : space_) result_.tuned.push_back(axis.name);
    result_.device = judge.views().front().device;
    result_.wall_time_s = seconds_since(start_);
    return std::move(result_);
  }

 private:
  const ParameterValues& base() const { return plan_.technique.parameters; }

  size_t active_axes() const {
    const auto acts = [&](const Parameter& axis) {
      return !plan_.is_active || plan_.is_active(axis, base());
    };
    return static_cast<size_t>(std::ranges::count_if(space_, acts));
  }

  size_t evaluations() const {
    return plan_.evaluations > 0 ? plan_.evaluations : default_evaluations(active_axes());
  }

  /// Of the time: what is left when tuned windows, presets and sensitivities take as long a picture as the windows did.
  double find_search_share(size_t views) const {
    size_t drawn = 0;
    for (const SafeWindow& window : result_.windows) drawn += views * window.points.size();
    const auto own_cost = std::ranges::count(candidates_, false, &Candidate::same_cost);
    const double others = static_cast<double>(candidates_.size() - static_cast<size_t>(own_cost)) +
                          kOwnCost * static_cast<double>(own_cost);
    const size_t after_each = views * (kTunedWindowPoints * result_.windows.size() + 2 * active_axes());
    const size_t held_out = plan_.cameras > 1 ? scenes_.size() * kHeldOutPerScene : 0;
    const double after = static_cast<double>(after_each) + others * static_cast<double>(views + held_out);
    const double spent_s = seconds_since(start_search_);
    const double a_picture_s = drawn > 0 ? spent_s / static_cast<double>(drawn) : 0.0;
    const double spent = std::min(1.0, spent_s / plan_.time_limit_s);
    const double least = spent + kLeastSearchShare * (1.0 - spent);
    return std::max(least, std::min(kMostSearchShare, 1.0 - after * a_picture_s / plan_.time_limit_s));
  }

  std::function<bool()> time_is_up_after(double share) const {
    return [this, share] { return seconds_since(start_search_) > share * plan_.time_limit_s; };
  }

  ObjectiveFunction counted(Judge& judge) const {
    return [this, &judge](const ParameterValues& values) {
      const double ratio = judge.ratio(values);
      progress_.advance(1);
      return ratio;
    };
  }

  /// The tuned axes of the defaults and presets: the search begins with what people set by hand.
  std::vector<ParameterValues> starts() const {
    std::vector<ParameterValues> values;
    for (const Candidate& candidate : candidates_) {
      if (candidate.same_cost) values.push_back(candidate.values);
    }
    return values;
  }

  SearchResult search(Judge& judge) {
    const double share = search_share_;
    // settle() may ask for one more an axis.
    const size_t count = evaluations() - std::min(evaluations() / 2, space_.size());
    if (!plan_.coarse)
      return minimise(space_, starts(), base(), counted(judge), {count, time_is_up_after(share)},
                      plan_.is_active);
    Judge coarse(studio_, searched_views(*plan_.coarse), plan_.objective, base());
    const auto coarse_count = static_cast<size_t>(kCoarseShare * static_cast<double>(count));
    const SearchResult first =
        minimise(space_, starts(), base(), counted(coarse),
                 {coarse_count, time_is_up_after(kCoarseShare * share)}, plan_.is_active);
    result_.coarse_trials = first.trials;
    result_.coarse_evaluations = coarse.evaluations();
    std::vector<ParameterValues> kept = best_values(first.trials, kKept);
    kept.push_back(first.trials.front().values);  // the first start, which is known to work
    return minimise(space_, kept, base(), counted(judge),
                    {count - std::min(count, first.trials.size()), time_is_up_after(share)}, plan_.is_active,
                    first.effects);
  }

  /// As they are rendered: a preset's values in the search's digits.
  std::vector<ParameterValues> by_hand() const {
    std::vector<ParameterValues> all;
    for (const ParameterValues& values : starts())
      all.push_back(values_at(space_, point_of(space_, values), base()));
    return all;
  }

  /// Each scene's own camera, and with several those beside it.
  std::vector<View> searched_views(const Fidelity& fidelity) {
    std::vector<View> views;
    for (SceneJob& job : scenes_) {
      views.push_back(studio_.make_view(job, 0.0, fidelity));
      if (plan_.cameras == 1) continue;
      for (View& view : turned_views(views.back(), kSearchedShares)) views.push_back(std::move(view));
    }
    return views;
  }

  std::vector<View> turned_views(const View& own, std::span<const double> shares) {
    const auto [arc, is_new] = arcs_.try_emplace(own.job->name);
    if (is_new) arc->second = find_arc(studio_, own);
    return make_turned_views(studio_, own, arc->second, shares);
  }

  /// On cameras that nothing was searched with; absent where there is none to judge on.
  std::optional<Judge> judge_elsewhere(const Judge& judge, std::span<const double> shares) {
    std::vector<View> views;
    for (const View& view : judge.views()) {
      if (view.angle_deg != 0.0) continue;
      for (View& turned : turned_views(view, shares)) views.push_back(std::move(turned));
    }
    std::optional<Judge> elsewhere;
    if (views.empty()) return elsewhere;
    guarded([&] { elsewhere.emplace(studio_, std::move(views), plan_.objective, base()); });
    return elsewhere;
  }

  /// Those of the same cost come first and always; own maps of 4096 texels may take longer than the search.
  void compare(const Judge& judge, const std::optional<Judge>& held_out, bool same_cost) {
    const Judge* others = held_out ? &*held_out : nullptr;
    if (same_cost) score_candidate(judge, others, result_.best);
    for (Candidate& candidate : candidates_) {
      if (candidate.same_cost != same_cost) continue;
      if (!same_cost && time_is_up_after(1.0)()) {
        result_.notes.push_back("the time was up: not measured: " + candidate.name);
        continue;
      }
      score_candidate(judge, others, candidate);
      candidate.gain = gain_over(judge, false, result_.best, candidate);
      if (others != nullptr) candidate.held_out_gain = gain_over(*others, true, result_.best, candidate);
      result_.others.push_back(candidate);
    }
  }

  std::vector<SafeWindow> windows(const Judge& judge, const ParameterValues& values, double time_share,
                                  std::span<const SafeWindow> before = {}) {
    return find_windows(
        studio_, judge, space_, plan_.is_active, plan_.objective, values,
        [is_up = time_is_up_after(time_share)] { return !is_up(); }, before);
  }

  /// Beside the values that were found, if they are others.
  void find_tuned_windows(const Judge& judge) {
    if (result_.best.values == base()) return;
    std::vector<SafeWindow> found = windows(judge, result_.best.values, kTunedWindowsShare, result_.windows);
    const auto is_complete = [](const SafeWindow& window) { return window.is_complete; };
    if (!std::ranges::all_of(found, is_complete))
      result_.notes.push_back("the time was up: not every safe window was measured beside the tuned values");
    for (SafeWindow& window : found) {
      if (!window.is_complete) continue;
      window.is_at_tuned = true;
      result_.windows.push_back(std::move(window));
    }
  }

  /// Parameters that did not act, and those whose levels were tried and made no difference.
  void name_idle(const SearchResult& found) {
    for (const AxisEffect& effect : found.effects) {
      const Parameter& parameter = find_parameter(plan_.parameters, effect.parameter, plan_.technique.id);
      if (plan_.is_active && !plan_.is_active(parameter, result_.best.values)) {
        result_.notes.push_back(
            fmt::format("'{}' was not tuned: it acts only when {}", effect.parameter, parameter.when));
        continue;
      }
      if (effect.values < 2 || effect.relative_spread >= kWorthChanging) continue;
      result_.notes.push_back(
          fmt::format("'{}' need not be tuned here: {} values change the objective by {:.2g} % at most",
                      effect.parameter, effect.values, 100.0 * effect.relative_spread));
    }
  }

  void explain(Judge& judge, const SearchResult& found) {
    name_idle(found);
    const GoesOn goes_on = [is_up = time_is_up_after(1.0)] { return !is_up(); };
    result_.sensitivities = measure_sensitivities(judge, space_, plan_.is_active, found, goes_on);
    if (!goes_on()) result_.notes.push_back("the time was up: sensitivities are incomplete");
  }

  std::span<SceneJob> scenes_;
  const TunePlan& plan_;
  Progress& progress_;
  Clock::time_point start_;
  Clock::time_point start_search_;
  SearchSpace space_;
  std::vector<Candidate> candidates_;
  Studio studio_;
  std::map<std::string, Arc> arcs_;  // by scene
  TuneResult result_;
  double search_share_ = kMostSearchShare;
};

}  // namespace

TuneResult run_tune(std::span<SceneJob> scenes, const TunePlan& plan, Renderer& realtime,
                    Progress& progress) {
  return Tuning(scenes, plan, realtime, progress).run();
}

}  // namespace umbrameter
