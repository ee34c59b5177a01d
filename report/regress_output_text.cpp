// SPDX-License-Identifier: Apache-2.0
#include "report/regress_output.h"
#include "results/format.h"
#include "results/table_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace umbrameter {
namespace {

using Row = std::vector<std::string>;

std::string rmse_cell(const std::optional<BaselineRun>& run) {
  return run ? format_interval(rmse_of(run->numbers)) : kNotApplicable;
}

std::string effort(const RegressCase& one) {
  if (one.samples_per_pixel == 0) return kNotApplicable;
  std::string text = fmt::format("{} samples per pixel", one.samples_per_pixel);
  if (one.added_samples_per_pixel > 0) text += fmt::format(" ({} added)", one.added_samples_per_pixel);
  return one.pictures > 1 ? text + fmt::format(", {} seeds", one.pictures) : text;
}

std::string gate_cell(const RegressCase& one) {
  return one.verdict.gate.measures.empty() ? kNotApplicable
                                           : fmt::format("{:.2f}", worst_severity(one.verdict.gate));
}

std::string verdict_cell(const RegressCase& one) {
  const std::string outcome(name_of(one.verdict.outcome));
  return one.verdict.kind.empty() ? outcome : outcome + ": " + one.verdict.kind;
}

std::string remarks(const RegressCase& one) {
  std::string text = one.verdict.message;
  for (const std::string& note : one.notes) text += (text.empty() ? "" : "; ") + note;
  return text;
}

const Row kHeadings = {
    "scene", "run",    "verdict", "RMSE before [95 %]", "RMSE now [95 %]", "nearest to a gate",
    "truth", "remarks"};

std::vector<Row> rows_of(const RegressResults& results) {
  std::vector<Row> rows;
  for (const RegressCase& one : results.cases) {
    rows.push_back({one.scene, one.label, verdict_cell(one), rmse_cell(one.before), rmse_cell(one.now),
                    gate_cell(one), effort(one), remarks(one)});
  }
  return rows;
}

std::string summary(const RegressResults& results) {
  return fmt::format("{}: {} cases, {} pass, {} better, {} undecided, {} fail; {} x {} px, seed {}",
                     results.suite, results.cases.size(), results.count(CaseOutcome::pass),
                     results.count(CaseOutcome::better), results.count(CaseOutcome::undecided),
                     results.count(CaseOutcome::fail), results.width_px, results.height_px, results.seed);
}

}  // namespace

std::string regress_text(const RegressResults& results) {
  std::string text;
  for (const RegressCase& one : results.cases) {
    const bool is_plain = one.verdict.outcome == CaseOutcome::pass && one.notes.empty();
    if (is_plain && one.added_samples_per_pixel == 0) continue;
    text += fmt::format("{}, {}: {}", one.scene, one.label, verdict_cell(one));
    if (!remarks(one).empty()) text += ": " + remarks(one);
    if (one.added_samples_per_pixel > 0 || one.pictures > 1) text += " [" + effort(one) + "]";
    text += '\n';
  }
  for (const Skip& skip : results.skipped)
    text += fmt::format("{}, {}: skipped: {}\n", skip.scene, skip.technique, skip.reason);
  return text + summary(results) + '\n';
}

std::string regress_markdown(const RegressResults& results) {
  const auto line = [](const Row& cells) {
    std::string text = "|";
    for (const std::string& cell : cells) text += " " + markdown_cell(cell) + " |";
    return text + '\n';
  };
  std::string text = "# Regression\n\n" + summary(results) + "\n\n" + line(kHeadings);
  text += line(Row(kHeadings.size(), "---"));
  for (const Row& row : rows_of(results)) text += line(row);
  return text;
}

std::string github_annotations(const RegressResults& results) {
  const auto message = [](const std::string& text) {
    return escaped(escaped(escaped(text, '%', "%25"), '\r', "%0D"), '\n', "%0A");
  };
  const auto property = [&](const std::string& text) {
    return escaped(escaped(message(text), ':', "%3A"), ',', "%2C");
  };
  std::string text;
  for (const RegressCase& one : results.cases) {
    const bool fails = one.verdict.outcome == CaseOutcome::fail;
    if (!fails && one.verdict.outcome != CaseOutcome::undecided) continue;
    text += fmt::format("::{} title={}::{}\n", fails ? "error" : "warning",
                        property(fmt::format("{}, {}: {}", one.scene, one.label, one.verdict.kind)),
                        message(remarks(one)));
  }
  return text;
}

std::string proof_markdown(std::span<const ProvedFault> faults) {
  std::string text = "| fault | scene | verdict | pictures | |\n|---|---|---|---|---|\n";
  size_t found = 0, named = 0;
  for (const ProvedFault& fault : faults) {
    const char* mark = fault.is_named() ? "" : fault.is_found() ? "other class" : "missed";
    const CaseVerdict& verdict = fault.found.verdict;
    text += fmt::format("| {} | {} | {} | {} | {} |\n", fault.name, fault.scene,
                        verdict.kind.empty() ? "pass" : verdict.kind, fault.found.pictures, mark);
    found += fault.is_found() ? 1 : 0;
    named += fault.is_named() ? 1 : 0;
  }
  return text + fmt::format("\nfound {} of {} faults, {} by their class\n", found, faults.size(), named);
}

}  // namespace umbrameter
