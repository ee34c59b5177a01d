// SPDX-License-Identifier: Apache-2.0
#include "study/stress/run.h"

#include "core/guard.h"
#include "results/pictures/pictures.h"
#include "study/stress/judge.h"
#include "study/stress/stress_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace umbrameter {
namespace {

using enum StressOutcome;

std::string folder_name(const StressValue& value) {
  std::string name = value.text;
  std::ranges::replace(name, ' ', '_');
  return name;
}

class AxisWalk {
 public:
  AxisWalk(const StressAxis& axis, const StressPlan& plan, const StressTools& tools,
           const std::filesystem::path& folder, bool keep_pictures, const JournalState& done,
           JournalWriter& journal, Progress& progress)
      : axis_(axis),
        plan_(plan),
        tools_(tools),
        folder_(folder),
        keep_pictures_(keep_pictures),
        done_(done),
        journal_(journal),
        progress_(progress) {}

  void walk() {
    for (const size_t value : walking_order(axis_)) walk_value(value);
  }

 private:
  bool is_done(const std::string& row, size_t value) const { return done_.find(row, value) != nullptr; }

  bool has_open(size_t value) const {
    const bool technique_open = std::ranges::any_of(
        tools_.techniques, [&](const TechniqueRun& run) { return !is_done(run.label, value); });
    return technique_open || !is_done(std::string(kTruthRow), value);
  }

  /// What ended a worker must not end the next one.
  bool has_died(const std::string& row, size_t value) const {
    const StressCell* cell = done_.find(row, value);
    return cell != nullptr && (cell->outcome == crash || cell->outcome == hang);
  }

  void finish(StressCell cell, const std::string& row, size_t value) {
    if (is_done(row, value)) return;
    cell.axis = axis_.name;
    cell.row = row;
    cell.value = value;
    journal_.finish(cell);
  }

  void walk_value(size_t value) {
    const bool is_nominal = value == axis_.nominal;
    const bool is_needed = is_nominal ? anything_open() : has_open(value);
    if (!is_needed) return;
    const std::string truth_row(kTruthRow);
    if (has_died(truth_row, value)) {
      for (const TechniqueRun& run : tools_.techniques)
        finish(stress_failure(unjudged, "there is no truth"), run.label, value);
      return;
    }
    journal_.start({truth_row, value});
    const StressPoint point = axis_.point(axis_.values[value]);
    const StressScene scene =
        make_stress_scene(point, place_of(value), request_of(plan_.picture), tools_, progress_);
    keep_picture(scene.truth, scene.reference, truth_row, value, scene.reference.pixel_count() > 0);
    finish(scene.truth, truth_row, value);
    for (const TechniqueRun& run : tools_.techniques) {
      const bool is_skipped = is_done(run.label, value) && (!is_nominal || has_died(run.label, value));
      if (is_skipped) continue;
      journal_.start({run.label, value});
      finish(walk_technique(run, point, scene, value), run.label, value);
    }
  }

  bool anything_open() const {
    for (size_t value = 0; value < axis_.values.size(); ++value) {
      if (has_open(value)) return true;
    }
    return false;
  }

  std::filesystem::path place_of(size_t value) const { return folder_ / folder_name(axis_.values[value]); }

  StressCell walk_technique(const TechniqueRun& base, const StressPoint& point, const StressScene& scene,
                            size_t value) {
    const bool has_parameter = axis_.needs_parameter.empty() ||
                               std::ranges::any_of(axis_.needs_parameter, [&](const std::string& name) {
                                 return base.parameters.contains(name);
                               });
    if (!has_parameter) return stress_failure(not_applicable, "has no such parameter");
    if (scene.reference.pixel_count() == 0) return of_scene(scene.truth);
    if (const auto reason = skip_reason(base, scene.scene)) return stress_failure(not_applicable, *reason);
    Image picture;
    std::vector<std::string> warnings;
    bool is_concerned = true;
    const auto failure = guarded([&] {
      const TechniqueRun run = tools_.choose(base, applicable(point.assignments, base), point.edits);
      is_concerned = point.edits.empty() || run.hash != base.hash;
      if (!is_concerned) return;
      const RenderRequest wanted = request_of(plan_.picture, run, plan_.picture.seed);
      Frame frame = tools_.realtime(point.edits).render(scene.scene, wanted, progress_);
      picture = std::move(frame.image);
      warnings = std::move(frame.warnings);
    });
    if (failure) return stress_failure(outcome_of(*failure), failure->message);
    if (!is_concerned) return stress_failure(not_applicable, "keeps nothing in that format");
    if (!scene.is_usable) return of_scene(scene.truth);
    StressCell cell = judge(base.label, picture, scene, value);
    cell.warnings = warnings;
    keep_picture(cell, picture, base.label, value, cell.outcome != ok);
    return cell;
  }

  StressCell judge(const std::string& label, const Image& picture, const StressScene& scene, size_t value) {
    StressMeasure measure = measure_stress(picture, scene.reference, scene.scene.camera.eye_world);
    const auto nominal = nominal_.find(label);
    const bool is_nominal = value == axis_.nominal;
    StressCell cell = judge_stress(measure, is_nominal                  ? &measure
                                            : nominal == nominal_.end() ? nullptr
                                                                        : &nominal->second);
    if (is_nominal) nominal_[label] = std::move(measure);
    return cell;
  }

  /// What a scene without a usable truth is to every technique; the truth's own row says what is wrong.
  static StressCell of_scene(const StressCell& truth) {
    const bool is_shared = truth.outcome == rightly_refused || truth.outcome == refused ||
                           truth.outcome == other_surfaces || truth.outcome == environment;
    return is_shared ? stress_failure(truth.outcome, truth.how)
                     : stress_failure(unjudged, "there is no truth");
  }

  static std::vector<std::string> applicable(const std::vector<std::string>& assignments,
                                             const TechniqueRun& run) {
    std::vector<std::string> out;
    for (const std::string& text : assignments) {
      if (run.parameters.contains(split_assignment(text).first)) out.push_back(text);
    }
    return out;
  }

  void keep_picture(const StressCell& cell, const Image& image, const std::string& row, size_t value,
                    bool is_wanted) const {
    if (!keep_pictures_ || !is_wanted || cell.outcome == bad_value) return;
    write_picture(place_of(value) / (row + ".png"), visibility_picture(image));
  }

  const StressAxis& axis_;
  const StressPlan& plan_;
  const StressTools& tools_;
  const std::filesystem::path& folder_;
  const bool keep_pictures_;
  const JournalState& done_;
  JournalWriter& journal_;
  Progress& progress_;
  std::map<std::string, StressMeasure> nominal_;  // by label
};

}  // namespace

std::vector<size_t> walking_order(const StressAxis& axis) {
  std::vector<size_t> order = {axis.nominal};
  for (size_t value = 0; value < axis.values.size(); ++value) {
    if (value != axis.nominal) order.push_back(value);
  }
  return order;
}

size_t cells_of(const StressAxis& axis, size_t techniques) {
  return axis.values.size() * (techniques + 1);
}

void run_stress_axis(const StressAxis& axis, const StressPlan& plan, const StressTools& tools,
                     const std::filesystem::path& folder, bool keep_pictures, const JournalState& done,
                     JournalWriter& journal, Progress& progress) {
  AxisWalk(axis, plan, tools, folder, keep_pictures, done, journal, progress).walk();
}

}  // namespace umbrameter
