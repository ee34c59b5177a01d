// SPDX-License-Identifier: Apache-2.0
#include "study/regress/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace umbrameter {
namespace {

// Of a median of n normal values: 1.2533 standard deviations / sqrt(n); a standard deviation is 1.4826 MAD.
constexpr double kMedianSdOfMad = 1.2533 * 1.4826;
constexpr double kTimeSigmas = 3.0;

struct Change {
  double value = 0.0;   // of the mean squared error
  double noise = 0.0;   // what noise may make of it
  double margin = 0.0;  // what counts as the same
};

Change change_of(const CaseNumbers& now, const CaseNumbers& before, const RegressGates& gates) {
  const double truths = std::hypot(now.noise_sd, before.noise_sd);
  const double seeds = std::hypot(now.seed_sd, before.seed_sd);
  return {now.mse.value - before.mse.value, gates.sigmas * std::hypot(truths, seeds),
          gates.same_share * std::max(0.0, before.mse.value) + gates.same_rmse * gates.same_rmse};
}

bool is_worse_for_certain(const Change& change) {
  return change.value > change.margin + change.noise;
}

const GateMeasure* worst_of(const GateVerdict& gate) {
  const GateMeasure* worst = nullptr;
  for (const GateMeasure& m : gate.measures) {
    if (m.kind != gate.kind || m.key != gate.key || !m.exceeds()) continue;
    if (worst == nullptr || m.severity() > worst->severity()) worst = &m;
  }
  return worst;
}

std::string gate_message(const GateVerdict& gate) {
  const GateMeasure* m = worst_of(gate);
  if (m == nullptr) return std::string(name_of(gate));
  return fmt::format("{} is {:.4g}, {:.1f} times what may be added to the baseline's {:.4g}", name_of(gate),
                     m->value.value_or(0.0), m->severity(), m->baseline.value_or(0.0));
}

// Only the RMSE has an interval: a limit inside of it is undecided. What was not measured never passes.
CaseVerdict judge_limits(const CaseNumbers& now, const RegressGates& gates) {
  CaseVerdict verdict;
  for (const auto& [name, limit] : gates.at_most) {
    const bool is_rmse = name == "rmse";
    const auto found = now.measures.find(name);
    if (!is_rmse && found == now.measures.end())
      return {CaseOutcome::fail,
              "limit",
              fmt::format("{} has a limit of {:.4g} and was not measured", name, limit),
              {}};
    const Interval value = is_rmse ? rmse_of(now) : Interval{found->second, found->second, found->second};
    if (value.high <= limit) continue;
    const bool fails = value.low > limit;
    if (!fails && !verdict.kind.empty()) continue;
    verdict.outcome = fails ? CaseOutcome::fail : CaseOutcome::undecided;
    verdict.kind = "limit";
    verdict.message = is_rmse
                          ? fmt::format("RMSE {:.5f} [{:.5f}, {:.5f}] against a limit of {:.5g}", value.value,
                                        value.low, value.high, limit)
                          : fmt::format("{} is {:.4g}, above its limit of {:.4g}", name, value.value, limit);
    if (fails) break;
  }
  return verdict;
}

CaseVerdict judge_ratchet(const CaseNumbers& now, const CaseNumbers& before, const Change& change) {
  CaseVerdict verdict;
  if (change.value < -change.margin - change.noise) verdict.outcome = CaseOutcome::better;
  if (change.value <= change.margin) return verdict;
  const bool fails = is_worse_for_certain(change);
  verdict.outcome = fails ? CaseOutcome::fail : CaseOutcome::undecided;
  verdict.kind = "ratchet";
  verdict.message = fmt::format(
      "RMSE was {:.5f} and is {:.5f}: the mean squared error grew by {:.3g}, {} the {:.3g} that count as the "
      "same and "
      "the {:.3g} of noise",
      rmse_of(before).value, rmse_of(now).value, change.value, fails ? "more than" : "within", change.margin,
      change.noise);
  return verdict;
}

}  // namespace

CaseVerdict judge_case(const CaseNumbers& now, const CaseNumbers& before, const RegressGates& gates) {
  const Change change = change_of(now, before, gates);
  const GateRun baseline = gate_run_of(before);
  const GateVerdict gate =
      judge_gate(gate_run_of(now), &baseline, is_worse_for_certain(change), gates.worse_by);
  if (!gate.passes()) return {CaseOutcome::fail, std::string(name_of(gate)), gate_message(gate), gate};
  CaseVerdict limits = judge_limits(now, gates);
  CaseVerdict ratchet = gates.ratchet ? judge_ratchet(now, before, change) : CaseVerdict{};
  CaseVerdict& verdict = limits.outcome > ratchet.outcome ? limits : ratchet;
  verdict.gate = gate;
  return verdict;
}

std::optional<CaseVerdict> judge_time(const BaselineTime& now, const BaselineTime& before, double ratio) {
  const auto width = [](const BaselineTime& time) {
    return kTimeSigmas * kMedianSdOfMad * time.mad_ms / std::sqrt(std::max(1, time.frames));
  };
  if (now.median_ms - width(now) <= ratio * (before.median_ms + width(before))) return std::nullopt;
  return not_compared("time",
                      fmt::format("a frame took {:.4g} ms and takes {:.4g} ms, beyond {:.3g} times and noise",
                                  before.median_ms, now.median_ms, ratio));
}

}  // namespace umbrameter
