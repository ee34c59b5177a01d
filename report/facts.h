// SPDX-License-Identifier: Apache-2.0
#pragma once
// Everything known of a reference or a run, as terms with texts.

#include "results/diagnosis_format.h"
#include "results/results.h"

namespace umbrameter {

/// `scene` has a reference.
TermLines reference_facts(const SceneResult& scene);
TermLines run_facts(const TechniqueResult& run);

}  // namespace umbrameter
