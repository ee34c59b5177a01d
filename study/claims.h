// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a paper claims, beside what was measured.

#include "study/pareto.h"
#include "study/study_file.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace umbrameter {

enum class Verdict { agrees, disagrees, cannot_tell };

/// One claim on one scene. `ours` has equal ends when nothing is known about its noise.
struct ClaimResult {
  size_t claim = 0;  // in BenchPlan::claims
  PaperRatio paper;
  std::optional<Interval> ours;
  Verdict verdict = Verdict::cannot_tell;
  std::string reason;  // why it cannot tell; empty otherwise
};

/// Every claim that speaks of `scene`, from the first run of each label (several seeds share one). A single number is
/// agreed with by lying on its side of 1, a range by lying in it, with the whole interval: ratios of whole frames move
/// with hardware, orders should not. Times of two runs that drew the same picture, to the bit, say nothing about two
/// techniques: no verdict, unless the claim is about two ways to one picture, and then none where the pictures differ.
std::vector<ClaimResult> judge_claims(std::span<const Claim> claims, const std::string& scene,
                                      std::span<const BenchEntry> entries);

/// "same order", "opposite order", "inside", "outside", "holds", "fails" or "cannot tell".
std::string_view verdict_text(const ClaimResult& result);
/// "1.94", "1.15 to 2.04" or "at least 1".
std::string format_paper(const PaperRatio& paper);

}  // namespace umbrameter
