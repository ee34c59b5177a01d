// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a paper claims, beside what was measured.

#include "results/bench/claim.h"
#include "results/bench/pareto.h"

#include <array>
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
  std::array<std::optional<double>, 2> compares_per_pixel;  // of numerator and denominator; absent: not known
  Verdict verdict = Verdict::cannot_tell;
  std::string reason;  // why it cannot tell; empty otherwise
};

/// How far apart two runs' comparisons a pixel may lie, as a share of the smaller number, to count as one cost.
inline constexpr double kEqualCost = 0.1;

/// How often a run compares the map a pixel, as realtime/manifest/technique.h counts; absent: not known.
struct RunCost {
  std::string label;
  std::optional<double> compares_per_pixel;
};

/// Of a claim about times: Error{input} at its place where one side compares the map more often than the other, or it is not
/// known how often, and the claim does not say so; and where it says so and they compare equally often.
void require_fair_costs(std::span<const Claim> claims, std::span<const RunCost> runs);

/// Every claim that speaks of `scene`, from the first run of each label (several seeds share one). A single number is
/// agreed with by lying on its side of 1, a range by lying in it, with the whole interval: ratios of whole frames move
/// with hardware, orders should not. Times of two runs that drew the same picture, to the bit, say nothing about two
/// techniques: no verdict, unless the claim is about two ways to one picture, and then none where the pictures differ.
std::vector<ClaimResult> judge_claims(std::span<const Claim> claims, const std::string& scene,
                                      std::span<const BenchEntry> entries);

/// "same order", "opposite order", "inside", "outside", "holds", "fails" or "cannot tell".
std::string_view verdict_text(const ClaimResult& result);
/// "16 : 49", an unknown side as "?".
std::string format_compares(const ClaimResult& result);
/// "1.94", "1.15 to 2.04" or "at least 1".
std::string format_paper(const PaperRatio& paper);

}  // namespace umbrameter
