// SPDX-License-Identifier: Apache-2.0
#include "results/selftest/outcome.h"

#include "results/diagnosis_format.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>

namespace umbrameter {

namespace {

std::optional<double> share(size_t part, size_t whole) {
  if (whole == 0) return std::nullopt;
  return static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

std::string text_of(const SelftestRound& round) {
  return fmt::format("{} x {} px, seed {}", round.width_px, round.height_px, round.seed);
}

std::string_view name_of(FaultOrigin origin) {
  constexpr std::array<std::string_view, 4> kNames = {"technique", "image", "reference", "metric"};
  return kNames[static_cast<size_t>(origin)];
}

bool CauseOutcome::is_right() const {
  return cause && std::ranges::find(right, *cause) != right.end();
}

std::string text_of(const CauseOutcome& outcome) {
  const std::string head = fmt::format("{} of {}: ", outcome.name, outcome.scene);
  if (!outcome.fault) return head + "no fault grew";
  const Substitution* best = find_substitution(outcome.best);
  return head + fmt::format("{}, {} removes {:.0f} %", format_fault(*outcome.fault),
                            best == nullptr ? "nothing" : best->label, 100.0 * outcome.removed);
}

bool FaultOutcome::is_right() const {
  return verdict.kind && std::ranges::find(right, *verdict.kind) != right.end();
}

bool HardeningOutcome::is_told() const {
  return exact.slope.has_value();
}

std::optional<double> MaskOutcome::precision() const {
  return share(both, found);
}

std::optional<double> MaskOutcome::recall() const {
  return share(both, painted);
}

size_t SelftestResults::found() const {
  return static_cast<size_t>(std::ranges::count_if(faults, &FaultOutcome::is_found));
}

size_t SelftestResults::right() const {
  return static_cast<size_t>(std::ranges::count_if(faults, &FaultOutcome::is_right));
}

size_t SelftestResults::false_alarms() const {
  return static_cast<size_t>(
      std::ranges::count_if(benign, [](const BenignOutcome& o) { return !o.verdict.passes(); }));
}

size_t SelftestResults::right_causes() const {
  return static_cast<size_t>(std::ranges::count_if(causes, &CauseOutcome::is_right));
}

size_t SelftestResults::scenes_with_penumbrae() const {
  return static_cast<size_t>(
      std::ranges::count_if(hardening, [](const HardeningOutcome& o) { return o.penumbrae > 0; }));
}

size_t SelftestResults::telling_hardening() const {
  return static_cast<size_t>(std::ranges::count_if(hardening, &HardeningOutcome::is_told));
}

const BenignOutcome* SelftestResults::nearest_benign() const {
  const auto nearest =
      std::ranges::max_element(benign, {}, [](const BenignOutcome& o) { return worst_severity(o.verdict); });
  return nearest == benign.end() ? nullptr : &*nearest;
}

std::vector<MaskOutcome> SelftestResults::masks_over_scenes() const {
  std::vector<MaskOutcome> sums;
  for (const MaskOutcome& mask : masks) {
    auto sum = std::ranges::find(sums, mask.name, &MaskOutcome::name);
    if (sum == sums.end()) sum = sums.insert(sums.end(), MaskOutcome{mask.name, "", {}, mask.fault});
    sum->painted += mask.painted;
    sum->found += mask.found;
    sum->both += mask.both;
  }
  return sums;
}

bool SelftestResults::passes(const SelftestTargets& targets) const {
  const bool masks_pass = std::ranges::all_of(masks_over_scenes(), [&](const MaskOutcome& mask) {
    return mask.precision().value_or(0.0) >= targets.mask && mask.recall().value_or(0.0) >= targets.mask;
  });
  const bool causes_pass =
      static_cast<double>(right_causes()) >= targets.cause * static_cast<double>(causes.size());
  const bool hardening_passes =
      hardening.empty() ||
      (scenes_with_penumbrae() > 0 && static_cast<double>(telling_hardening()) >=
                                          targets.hardening * static_cast<double>(scenes_with_penumbrae()));
  const BenignOutcome* nearest = nearest_benign();
  const bool benign_pass = nearest == nullptr || worst_severity(nearest->verdict) <= targets.nearest;
  const bool any =
      !benign.empty() || !faults.empty() || !masks.empty() || !causes.empty() || !hardening.empty();
  return any && benign_pass && causes_pass && hardening_passes && found() == faults.size() &&
         false_alarms() == 0 && masks_pass &&
         static_cast<double>(right()) >= targets.right * static_cast<double>(faults.size());
}

}  // namespace umbrameter
