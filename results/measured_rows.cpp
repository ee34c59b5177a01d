// SPDX-License-Identifier: Apache-2.0
#include "results/measured_rows.h"

#include "metrics/error/p95_error.h"
#include "metrics/error/worst_pixels.h"
#include "metrics/faults/map_seam.h"
#include "metrics/penumbra/width_error.h"
#include "metrics/temporal/history.h"

namespace umbrameter {

std::vector<Metric> measured_rows() {
  std::vector<Metric> rows = {
      {.key = "worst_pixels_rmse",
       .label = "worst pixels",
       .group = "error",
       .unit = "visibility",
       .doc = "root mean square of V - R over the hundredth of the pixels that is farthest off",
       .measure =
           [](const MetricInputs& in) { return measure_worst_pixels(in.test, in.reference, in.mask); }},
      {.key = "p95_error",
       .label = "shaded pixels but a twentieth",
       .group = "error",
       .unit = "visibility",
       .doc =
           "95th percentile, over shaded pixels, of what |V - R| exceeds two standard errors of the truth by",
       .measure = [](const MetricInputs& in) { return measure_p95_error(in.test, in.reference, in.mask); },
       .gate = RowGate{.limit = {0.1, 0.5}}},
      {.key = "map_seam",
       .label = "seams between maps",
       .group = "error",
       .unit = "visibility",
       .doc = "step of V - R where one cascade or face ends and the next begins, beyond the steps beside it",
       .better = Better::nearest_zero,
       .form = MetricForm::signed_error,
       .measure = [](const MetricInputs& in) { return measure_map_seam(in.test, in.reference, in.mask); }},
      {.key = "width_error_octaves",
       .label = "wrong widths",
       .group = "penumbrae",
       .unit = "octaves",
       .doc = "root mean square of log2 of the width over the true one; a penumbra that is lost or torn "
              "counts 4",
       .form = MetricForm::error,
       .measure = [](const MetricInputs& in) { return measure_width_error(in.profiles); },
       .term = ObjectiveTerm{"widths", 0.5}},
      {.key = "ghosting",
       .label = "ghosting",
       .group = "over time",
       .unit = "visibility",
       .doc = "root mean square of V - R that the motion of earlier frames leaves in the last, beyond that "
              "of the "
              "same frame where nothing moved",
       .better = Better::nearest_zero,
       .form = MetricForm::signed_error,
       .measure =
           [](const MetricInputs& in) {
             return in.still == nullptr ? std::nullopt
                                        : measure_ghosting(in.test, *in.still, in.reference, in.mask);
           },
       .needs = MetricNeeds::sequence},
      {.key = "convergence_frames",
       .label = "frames to converge",
       .group = "over time",
       .unit = "frames",
       .doc = "frames of a still scene after which nine tenths of the error that frames mend is mended",
       .form = MetricForm::number,
       .measure =
           [](const MetricInputs& in) {
             return in.still_pictures.empty() ? std::nullopt
                                              : measure_convergence(in.still_pictures, in.reference, in.mask);
           },
       .needs = MetricNeeds::sequence},
  };
  for (Metric& row : rows) {
    row.of = [key = row.key](const TechniqueResult& run) -> std::optional<double> {
      const auto found = run.measured.find(key);
      return found == run.measured.end() ? std::nullopt : std::optional(found->second);
    };
  }
  return rows;
}

}  // namespace umbrameter
