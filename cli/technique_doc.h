// SPDX-License-Identifier: Apache-2.0
#pragma once
// The text of docs/techniques.md.

#include "realtime/manifest/technique.h"
#include "results/results.h"

#include <span>
#include <string>

namespace umbrameter {

/// Markdown: what the manifests declare, and what `results` measured of each technique. Runs of a technique with changed
/// parameters are listed under their labels.
std::string technique_doc(std::span<const Technique> techniques, const Results& results);

}  // namespace umbrameter
