// SPDX-License-Identifier: Apache-2.0
#include "report/selftest_output.h"

#include "results/json/json_optional.h"
#include "results/json/schemas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace umbrameter {
namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr GateClass kFirstMeasured = GateClass::acne;

std::optional<double> severity_of(const GateVerdict& verdict, GateClass kind) {
  std::optional<double> worst;
  for (const GateMeasure& m : verdict.measures) {
    if (m.kind == kind && m.value) worst = std::max(worst.value_or(-HUGE_VAL), m.severity());
  }
  return worst;
}

std::string kind_text(const GateVerdict& verdict) {
  return verdict.passes() ? "passes" : std::string(name_of(verdict));
}

std::string cell(const std::optional<double>& severity) {
  if (!severity) return " ";
  if (*severity <= 0.05) return ".";
  const std::string text = *severity > 99.0 ? "> 99" : fmt::format("{:.1f}", *severity);
  return *severity > 1.0 ? "**" + text + "**" : text;
}

// Those that one kind of measure decides; the others are names for what measures say together, or for any further one.
bool is_measured(GateClass kind) {
  return kind >= kFirstMeasured && kind != GateClass::penumbra_too_wide && kind != GateClass::measured;
}

template <class Visit>
void for_each_measured(const Visit& visit) {
  for (size_t k = 0; k < kGateClasses; ++k) {
    if (is_measured(static_cast<GateClass>(k))) visit(static_cast<GateClass>(k));
  }
}

std::string fault_row(const FaultOutcome& fault) {
  std::string row = fmt::format("| {} | {} | {} |", fault.name, name_of(fault.origin), fault.scene);
  for_each_measured(
      [&](GateClass kind) { row += fmt::format(" {} |", cell(severity_of(fault.verdict, kind))); });
  const char* mark = fault.is_right() ? "" : fault.is_found() ? " (wrong)" : " (missed)";
  return row + fmt::format(" {}{} |\n", kind_text(fault.verdict), mark);
}

std::string fault_matrix(const SelftestResults& results, const SelftestRound& round) {
  std::string head = "| fault | in | scene |", rule = "|---|---|---|";
  for_each_measured([&](GateClass kind) {
    head += fmt::format(" {} |", name_of(kind));
    rule += "---|";
  });
  std::string text = head + " verdict |\n" + rule + "---|\n";
  for (const FaultOutcome& fault : results.faults) {
    if (fault.round == round) text += fault_row(fault);
  }
  return text;
}

// A row a scene, a column a name, in the order they come in; `text_of` an outcome, empty where there is none.
template <class Outcome, class TextOf>
std::string by_scene(const std::vector<Outcome>& outcomes, const TextOf& text_of) {
  if (outcomes.empty()) return "";
  std::vector<std::string> names, scenes;
  for (const Outcome& o : outcomes) {
    if (std::ranges::find(names, o.name) == names.end()) names.push_back(o.name);
    if (std::ranges::find(scenes, o.scene) == scenes.end()) scenes.push_back(o.scene);
  }
  std::string head = "| scene |", rule = "|---|";
  for (const std::string& name : names) head += fmt::format(" {} |", name), rule += "---|";
  std::string text = head + "\n" + rule + "\n";
  for (const std::string& scene : scenes) {
    text += fmt::format("| {} |", scene);
    for (const std::string& name : names) {
      const auto found = std::ranges::find_if(
          outcomes, [&](const Outcome& o) { return o.name == name && o.scene == scene; });
      text += fmt::format(" {} |", found == outcomes.end() ? "" : text_of(*found));
    }
    text += "\n";
  }
  return text;
}

template <class Outcome>
std::vector<Outcome> in_round(const std::vector<Outcome>& outcomes, const SelftestRound& round) {
  std::vector<Outcome> some;
  std::ranges::copy_if(outcomes, std::back_inserter(some),
                       [&](const Outcome& o) { return o.round == round; });
  return some;
}

std::vector<SelftestRound> rounds_of(const SelftestResults& results) {
  std::vector<SelftestRound> rounds;
  const auto add = [&](const auto& outcomes) {
    for (const auto& o : outcomes) {
      if (std::ranges::find(rounds, o.round) == rounds.end()) rounds.push_back(o.round);
    }
  };
  add(results.benign);
  add(results.faults);
  return rounds;
}

std::string benign_matrix(const SelftestResults& results, const SelftestRound& round) {
  return by_scene(in_round(results.benign, round), [](const BenignOutcome& o) {
    return o.verdict.passes() ? fmt::format("{:.2f}", worst_severity(o.verdict))
                              : fmt::format("**{}**", kind_text(o.verdict));
  });
}

std::string left_out_lines(const SelftestResults& results) {
  std::string text;
  for (const LeftOut& out : results.left_out) {
    text += fmt::format(
        "left out: {} of {} ({}): the map does not resolve {:.0f} % of the true edges, {:.0f} % of the "
        "shade\n",
        out.name, out.scene, text_of(out.round), 100.0 * out.unresolved.edges.value_or(0.0),
        100.0 * out.unresolved.shade);
  }
  return text.empty() ? text : text + "\n";
}

std::string ratio_text(const std::optional<double>& ratio) {
  return ratio ? fmt::format("{:.3f}", *ratio) : "n/a";
}

std::string mask_table(const SelftestResults& results) {
  std::string text =
      "| painted | class | scenes | pixels | precision | recall |\n|---|---|---|---|---|---|\n";
  for (const MaskOutcome& mask : results.masks_over_scenes()) {
    const auto scenes = std::ranges::count(results.masks, mask.name, &MaskOutcome::name);
    text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", mask.name, name_of(mask.fault), scenes,
                        mask.painted, ratio_text(mask.precision()), ratio_text(mask.recall()));
  }
  return text;
}

// What one scene says alone; the target is of all together.
std::string recall_by_scene(const SelftestResults& results, const SelftestRound& round) {
  return by_scene(in_round(results.masks, round),
                  [](const MaskOutcome& mask) { return ratio_text(mask.recall()); });
}

std::string cause_list(const SelftestResults& results) {
  std::string text;
  for (const CauseOutcome& outcome : results.causes)
    text += fmt::format("- {}{}\n", text_of(outcome), outcome.is_right() ? "" : " (wrong)");
  return text.empty() ? text
                      : text + fmt::format("\n{} of {} substitutions point at what was put in\n",
                                           results.right_causes(), results.causes.size());
}

std::string hardening_table(const SelftestResults& results) {
  std::string text = "| scene | penumbrae | profiles | octaves | slope |\n|---|---|---|---|---|\n";
  for (const HardeningOutcome& outcome : results.hardening) {
    const ContactHardening& exact = outcome.exact;
    const std::string slope =
        exact.slope ? fmt::format("{:.2f} +- {:.2f}", *exact.slope, exact.slope_margin.value_or(0.0))
                    : "not identifiable";
    text += fmt::format("| {} | {} | {} | {:.2f} | {} |\n", outcome.scene, outcome.penumbrae, exact.profiles,
                        exact.octaves, slope);
  }
  return text + fmt::format("\ncontact hardening can be told on {} of {} scenes with penumbrae\n",
                            results.telling_hardening(), results.scenes_with_penumbrae());
}

OrderedJson verdict_json(const GateVerdict& verdict) {
  OrderedJson measures = OrderedJson::array();
  for (const GateMeasure& m : verdict.measures) {
    measures.push_back({{"class", name_of(m)},
                        {"value", optional_json(m.value)},
                        {"baseline", optional_json(m.baseline)},
                        {"allowed", m.allowed}});
  }
  return {{"passes", verdict.passes()}, {"class", kind_text(verdict)}, {"measures", measures}};
}

OrderedJson tried_json(const CauseOutcome& outcome) {
  OrderedJson tried = OrderedJson::array();
  for (const SubstitutionOutcome& one : outcome.tried) {
    if (one.not_tried) continue;
    tried.push_back({{"id", one.id},
                     {"changes", one.changes},
                     {"removed", one.removed.front()},
                     {"elsewhere", one.elsewhere}});
  }
  return tried;
}

OrderedJson round_json(const SelftestRound& round) {
  return {{"width_px", round.width_px}, {"height_px", round.height_px}, {"seed", round.seed}};
}

}  // namespace

std::string selftest_markdown(const SelftestResults& results) {
  std::string text;
  const std::vector<SelftestRound> rounds = rounds_of(results);
  for (const SelftestRound& round : rounds) {
    if (rounds.size() > 1) text += text_of(round) + ":\n\n";
    if (!results.faults.empty()) text += fault_matrix(results, round) + "\n";
    text += benign_matrix(results, round) + "\n" + recall_by_scene(results, round) + "\n";
  }
  if (!results.masks.empty()) text += mask_table(results) + "\n";
  if (!results.hardening.empty()) text += hardening_table(results) + "\n";
  if (!results.causes.empty()) text += cause_list(results) + "\n";
  text += left_out_lines(results);
  if (const BenignOutcome* nearest = results.nearest_benign()) {
    text += fmt::format("nearest benign trial: {} of {} ({}), {:.2f} of its limit\n", nearest->name,
                        nearest->scene, text_of(nearest->round), worst_severity(nearest->verdict));
  }
  return text + fmt::format(
                    "found {} of {} faults, {} of the right class; {} false alarms in {} trials over {} "
                    "scenes: {}\n",
                    results.found(), results.faults.size(), results.right(), results.false_alarms(),
                    results.benign.size(), results.scenes, results.passes() ? "passes" : "fails");
}

std::string selftest_json(const SelftestResults& results) {
  OrderedJson faults = OrderedJson::array(), benign = OrderedJson::array(), masks = OrderedJson::array(),
              left_out = OrderedJson::array();
  for (const FaultOutcome& fault : results.faults) {
    OrderedJson right = OrderedJson::array();
    for (const GateClass kind : fault.right) right.push_back(name_of(kind));
    faults.push_back({{"fault", fault.name},
                      {"in", name_of(fault.origin)},
                      {"scene", fault.scene},
                      {"round", round_json(fault.round)},
                      {"expected", right},
                      {"found", fault.is_found()},
                      {"right", fault.is_right()},
                      {"verdict", verdict_json(fault.verdict)}});
  }
  for (const BenignOutcome& o : results.benign) {
    benign.push_back({{"variant", o.name},
                      {"scene", o.scene},
                      {"round", round_json(o.round)},
                      {"severity", worst_severity(o.verdict)},
                      {"verdict", verdict_json(o.verdict)}});
  }
  for (const LeftOut& out : results.left_out) {
    left_out.push_back({{"variant", out.name},
                        {"scene", out.scene},
                        {"round", round_json(out.round)},
                        {"coarse_edges", optional_json(out.unresolved.edges)},
                        {"narrow_shade", out.unresolved.shade}});
  }
  for (const MaskOutcome& mask : results.masks) {
    masks.push_back({{"painted", mask.name},
                     {"class", name_of(mask.fault)},
                     {"scene", mask.scene},
                     {"round", round_json(mask.round)},
                     {"pixels", mask.painted},
                     {"precision", optional_json(mask.precision())},
                     {"recall", optional_json(mask.recall())}});
  }
  OrderedJson causes = OrderedJson::array();
  for (const CauseOutcome& outcome : results.causes) {
    causes.push_back({{"fault", outcome.name},
                      {"scene", outcome.scene},
                      {"class", outcome.fault ? OrderedJson(name_of(*outcome.fault)) : OrderedJson(nullptr)},
                      {"best", outcome.best},
                      {"removed", outcome.removed},
                      {"undone", outcome.undone},
                      {"tried", tried_json(outcome)},
                      {"right", outcome.is_right()}});
  }
  OrderedJson hardening = OrderedJson::array();
  for (const HardeningOutcome& outcome : results.hardening) {
    hardening.push_back({{"scene", outcome.scene},
                         {"penumbrae", outcome.penumbrae},
                         {"profiles", outcome.exact.profiles},
                         {"octaves", outcome.exact.octaves},
                         {"slope", optional_json(outcome.exact.slope)},
                         {"margin", optional_json(outcome.exact.slope_margin)}});
  }
  const OrderedJson object = {{"schema", kSelftestSchema},
                              {"passes", results.passes()},
                              {"found", results.found()},
                              {"right", results.right()},
                              {"false_alarms", results.false_alarms()},
                              {"faults", faults},
                              {"benign", benign},
                              {"left_out", left_out},
                              {"masks", masks},
                              {"right_causes", results.right_causes()},
                              {"causes", causes},
                              {"telling_hardening", results.telling_hardening()},
                              {"hardening", hardening}};
  return object.dump(2);
}

}  // namespace umbrameter
