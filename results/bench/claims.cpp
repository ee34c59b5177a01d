// SPDX-License-Identifier: Apache-2.0
#include "results/bench/claims.h"

#include "core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace umbrameter {
namespace {

/// A quantity of one run; `is_certain` when its interval is known.
struct Measured {
  Interval value;
  bool is_certain = false;
};

std::optional<Measured> measured_time(const std::vector<double>& times_ms) {
  if (times_ms.empty()) return std::nullopt;
  if (const auto interval = median_interval(times_ms)) return Measured{*interval, true};
  const double median = median_spread(times_ms).median;
  return Measured{{median, median, median}, false};
}

std::optional<Measured> measure(const BenchEntry& entry, const Claim& claim) {
  switch (claim.quantity) {
    case Quantity::memory: {
      if (entry.memory_bytes == 0) return std::nullopt;
      const auto bytes = static_cast<double>(entry.memory_bytes);
      return Measured{{bytes, bytes, bytes}, true};
    }
    case Quantity::pass_time:
      return measured_time(times_of_pass(entry.times, claim.pass));
    case Quantity::time:
    case Quantity::fps:
      break;
  }
  return measured_time(frame_totals(entry.times, claim.without));
}

Interval divide(const Interval& a, const Interval& b) {
  return {a.value / b.value, a.low / b.high, a.high / b.low};
}

const BenchEntry* find_entry(std::span<const BenchEntry> entries, const std::string& label) {
  const auto found = std::ranges::find(entries, label, &BenchEntry::label);
  return found == entries.end() ? nullptr : &*found;
}

/// Where the paper's number puts the ratio: its side of 1, or its range.
Interval accepted(const PaperRatio& paper) {
  if (paper.is_range()) return {paper.low, paper.low, paper.high};
  return paper.low > 1.0 ? Interval{paper.low, 1.0, std::numeric_limits<double>::infinity()}
                         : Interval{paper.low, 0.0, 1.0};
}

void judge(const Interval& ours, ClaimResult& result) {
  const Interval wanted = accepted(result.paper);
  if (ours.low >= wanted.low && ours.high <= wanted.high) {
    result.verdict = Verdict::agrees;
  } else if (ours.high < wanted.low || ours.low > wanted.high) {
    result.verdict = Verdict::disagrees;
  } else {
    result.reason = "the interval holds both answers";
  }
}

/// Why the two pictures do not fit the claim; empty when they do.
std::string picture_objection(const Claim& claim, const BenchEntry& one, const BenchEntry& other) {
  if (claim.quantity == Quantity::memory || one.picture_hash.empty() || other.picture_hash.empty()) return {};
  const bool are_equal = one.picture_hash == other.picture_hash;
  if (are_equal && claim.pictures == ClaimPictures::other)
    return "both runs drew the same picture, to the bit";
  if (!are_equal && claim.pictures == ClaimPictures::same) return "the two pictures differ";
  return {};
}

void judge_claim(const Claim& claim, std::span<const BenchEntry> entries, ClaimResult& result) {
  std::array<std::optional<Measured>, 2> measured;
  const std::array<const std::string*, 2> labels{&claim.numerator, &claim.denominator};
  for (const size_t side : {0u, 1u}) {
    const BenchEntry* entry = find_entry(entries, *labels[side]);
    if (entry != nullptr) result.compares_per_pixel[side] = entry->compares_per_pixel;
    if (entry == nullptr || entry->failure) {
      result.reason = fmt::format("'{}' {}", *labels[side], entry == nullptr ? "was skipped" : "failed");
      return;
    }
    measured[side] = measure(*entry, claim);
    if (measured[side]) continue;
    result.reason = claim.quantity == Quantity::pass_time
                        ? fmt::format("'{}' has no pass '{}'", *labels[side], claim.pass)
                        : fmt::format("'{}' was not measured", *labels[side]);
    return;
  }
  result.reason =
      picture_objection(claim, *find_entry(entries, *labels[0]), *find_entry(entries, *labels[1]));
  if (!result.reason.empty()) return;
  const bool is_inverse = claim.quantity == Quantity::fps;
  const Measured& above = *measured[is_inverse ? 1 : 0];
  const Measured& below = *measured[is_inverse ? 0 : 1];
  if (below.value.low <= 0.0) {
    result.reason = "a time is 0";
    return;
  }
  result.ours = divide(above.value, below.value);
  if (!above.is_certain || !below.is_certain) {
    result.reason = "fewer than six frames were timed";
    return;
  }
  judge(*result.ours, result);
}

std::string count_text(const std::string& label, const std::optional<double>& count) {
  return fmt::format("'{}' {}", label, count ? fmt::format("{:.4g}", *count) : "an unknown number");
}

void require_fair_cost(const Claim& claim, std::span<const RunCost> runs) {
  const auto compares = [&](const std::string& label) {
    const auto found = std::ranges::find(runs, label, &RunCost::label);
    return found == runs.end() ? std::nullopt : found->compares_per_pixel;
  };
  const auto one = compares(claim.numerator), other = compares(claim.denominator);
  const bool is_equal = one && other && std::max(*one, *other) <= (1.0 + kEqualCost) * std::min(*one, *other);
  if (is_equal != claim.has_unequal_cost) return;
  const std::string counts = fmt::format("{} and {} comparisons per pixel", count_text(claim.numerator, one),
                                         count_text(claim.denominator, other));
  if (is_equal) {
    fail_input(fmt::format("the claim '{}' says unequal_cost, of {}", claim.text, counts), claim.where,
               "leave it out");
  }
  fail_input(fmt::format("the claim '{}' compares unequal costs: {}", claim.text, counts), claim.where,
             "make them equal, or say unequal_cost = true: the counts are printed beside it then");
}

}  // namespace

std::vector<ClaimResult> judge_claims(std::span<const Claim> claims, const std::string& scene,
                                      std::span<const BenchEntry> entries) {
  std::vector<ClaimResult> results;
  for (size_t i = 0; i < claims.size(); ++i) {
    const auto paper = paper_ratio(claims[i], scene);
    if (!paper) continue;
    ClaimResult result;
    result.claim = i;
    result.paper = *paper;
    judge_claim(claims[i], entries, result);
    results.push_back(std::move(result));
  }
  return results;
}

void require_fair_costs(std::span<const Claim> claims, std::span<const RunCost> runs) {
  for (const Claim& claim : claims) {
    if (claim.quantity != Quantity::memory) require_fair_cost(claim, runs);
  }
}

std::string format_compares(const ClaimResult& result) {
  const auto text = [](const std::optional<double>& count) {
    return count ? fmt::format("{:.4g}", *count) : "?";
  };
  return fmt::format("{} : {}", text(result.compares_per_pixel[0]), text(result.compares_per_pixel[1]));
}

std::string_view verdict_text(const ClaimResult& result) {
  if (result.verdict == Verdict::cannot_tell) return "cannot tell";
  const bool agrees = result.verdict == Verdict::agrees;
  if (std::isinf(result.paper.high)) return agrees ? "holds" : "fails";
  if (result.paper.is_range()) return agrees ? "inside" : "outside";
  return agrees ? "same order" : "opposite order";
}

std::string format_paper(const PaperRatio& paper) {
  if (std::isinf(paper.high)) return fmt::format("at least {:.3g}", paper.low);
  if (paper.is_range()) return fmt::format("{:.3g} to {:.3g}", paper.low, paper.high);
  return fmt::format("{:.3g}", paper.low);
}

}  // namespace umbrameter
