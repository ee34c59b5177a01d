// SPDX-License-Identifier: Apache-2.0
#include "study/tune/search/local_search.h"

#include <algorithm>
#include <cmath>
#include <nlopt.hpp>

namespace umbrameter {
namespace {

constexpr double kPositionTolerance = 1e-3;  // of positions: reals have three digits
constexpr double kImpossibleFactor = 10.0;   // NLopt's models want finite numbers
constexpr int kMaxLineMoves = 4;

struct Subspace {
  Trials& trials;
  std::span<const size_t> axes;
  Point base;
  size_t last_trial;  // trials that may exist when this method ends
  double impossible;
};

Subspace subspace_of(Trials& trials, std::span<const size_t> axes, size_t evaluations) {
  const TuneTrial& best = trials.best();
  return {trials, axes, best.point, trials.all().size() + std::min(evaluations, trials.left()),
          kImpossibleFactor * std::abs(best.objective) + 1.0};
}

double value_in(const std::vector<double>& position, std::vector<double>&, void* data) {
  auto& subspace = *static_cast<Subspace*>(data);
  if (subspace.trials.all().size() >= subspace.last_trial || subspace.trials.is_over())
    throw nlopt::forced_stop();
  Point point = subspace.base;
  for (size_t i = 0; i < subspace.axes.size(); ++i) point[subspace.axes[i]] = position[i];
  const double objective = subspace.trials.at(point);
  return std::isfinite(objective) ? objective : subspace.impossible;
}

/// The trials remember what was found; how a method ended does not matter.
void run(nlopt::algorithm algorithm, Subspace subspace, double first_step) {
  const auto count = static_cast<unsigned>(subspace.axes.size());
  if (count == 0 || subspace.trials.is_over()) return;
  nlopt::opt method(algorithm, count);
  method.set_lower_bounds(0.0);
  method.set_upper_bounds(1.0);
  method.set_min_objective(value_in, &subspace);
  method.set_xtol_abs(kPositionTolerance);
  // Values that are known already cost no evaluation: without this a method could ask for them for ever.
  method.set_maxeval(static_cast<int>(20 * (subspace.last_trial - subspace.trials.all().size()) + 100));
  if (first_step > 0.0) method.set_initial_step(first_step);
  std::vector<double> position;
  for (const size_t axis : subspace.axes) position.push_back(subspace.base[axis]);
  double least = 0.0;
  try {
    method.optimize(position, least);
  } catch (const nlopt::forced_stop&) {  // the budget
  } catch (const nlopt::roundoff_limited&) {
  } catch (const std::runtime_error&) {  // nlopt::failure: flat or degenerate
  }
}

double along(Trials& trials, Point point, size_t axis, double position) {
  point[axis] = std::clamp(position, 0.0, 1.0);
  return trials.at(point);
}

/// Where the parabola through three points h apart, the middle one lowest, has its minimum.
double vertex(double middle, double h, double left, double center, double right) {
  const double curvature = left - 2.0 * center + right;
  return curvature > 0.0 ? middle + 0.5 * h * (left - right) / curvature : middle;
}

}  // namespace

void search_globally(Trials& trials, std::span<const size_t> axes, size_t evaluations) {
  run(nlopt::GN_DIRECT_L, subspace_of(trials, axes, evaluations), 0.0);
}

void search_smoothly(Trials& trials, std::span<const size_t> axes, double first_step, size_t evaluations) {
  if (axes.size() < 2) return;  // a line search does as well
  run(nlopt::LN_BOBYQA, subspace_of(trials, axes, evaluations), first_step);
}

void search_robustly(Trials& trials, std::span<const size_t> axes, double first_step, size_t evaluations) {
  run(nlopt::LN_SBPLX, subspace_of(trials, axes, evaluations), first_step);
}

void search_line(Trials& trials, size_t axis, double step) {
  for (int move = 0; move < kMaxLineMoves && !trials.is_over(); ++move) {
    const TuneTrial start = trials.best();
    const double middle = start.point[axis];
    const double left = along(trials, start.point, axis, middle - step);
    const double right = along(trials, start.point, axis, middle + step);
    if (trials.best().objective < start.objective) continue;
    if (std::isfinite(left) && std::isfinite(right))
      along(trials, start.point, axis, vertex(middle, step, left, start.objective, right));
    return;
  }
}

}  // namespace umbrameter
