// SPDX-License-Identifier: Apache-2.0
#pragma once
// A diagnosis as people read it; the terminal and the report show the same text.

#include "metrics/diagnosis.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace umbrameter {

/// The fault's word for people: "geometric leak".
std::string format_fault(FaultClass fault);

/// "geometric leak 0.00310": the worst fault and its part of the mean absolute error; "none"; "n/a" when
/// there is no diagnosis.
std::string format_worst_fault(const std::optional<Diagnosis>& diagnosis);

/// "acne 0.0120, bleed 0.0031": every class with a tenth or more of the mean absolute error, the largest first; the worst where
/// none has; "none"; "n/a" when there is no diagnosis.
std::string format_faults(const std::optional<Diagnosis>& diagnosis);

/// "+acne 0.0110": classes whose part grew against the baseline's by a tenth or more of the run's mean absolute error, the
/// largest growth first; "nothing"; "n/a" when one has no diagnosis.
std::string format_growth(const std::optional<Diagnosis>& diagnosis,
                          const std::optional<Diagnosis>& baseline);

/// Terms and their texts.
using TermLines = std::vector<std::pair<std::string, std::string>>;

/// Width, offset, profiles and contact hardening.
TermLines penumbra_lines(const Diagnosis& diagnosis);

/// The worst fault, every class that has pixels, gap and moire.
TermLines fault_lines(const Diagnosis& diagnosis);

/// The map's footprint and the error it goes with, stairs, banding and noise; what does not apply is left out.
TermLines cause_lines(const Diagnosis& diagnosis);

}  // namespace umbrameter
