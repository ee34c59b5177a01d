// SPDX-License-Identifier: Apache-2.0
#pragma once
// Does a technique's penumbra widen where the true one does (METRICS 6.6)? The curve log W_test over log
// W_reference.

#include "metrics/penumbra/penumbra.h"

#include <optional>

namespace umbrameter {

/// A robust line through log2 test width over log2 reference width. Slope 1, intercept 0 is right; slope 0 is
/// a filter of constant width; a negative slope hardens the wrong end; intercept 1 is a light twice too
/// large.
struct ContactHardening {
  size_t profiles = 0;
  double octaves = 0.0;  // between the 5 % and 95 % quantiles of the reference's widths
  /// Absent, "not identifiable", when the widths span less than 1 octave, or less than 2 with a margin above .25 (full
  /// hardening could not be told from half of it), or when there are fewer than 8 profiles.
  std::optional<double> slope;
  std::optional<double> intercept_octaves;  // at the median reference width: the test's excess there
  /// Half of the slope's 95 % interval; absent without a slope, and where all profiles lie in one place.
  std::optional<double> slope_margin;
};

/// Theil-Sen over pairs of accepted profiles that are not hard (width_octaves above its least), at least
/// half an octave apart (closer ones compare noise), of at
/// most 512 profiles evenly picked from those sorted by width. The margin takes profiles of one square of 64 px for one
/// observation, as they share their edge.
ContactHardening measure_contact_hardening(const PenumbraError& penumbra);

}  // namespace umbrameter
