// SPDX-License-Identifier: Apache-2.0
#include "report/regress_output.h"
#include "results/json/json_optional.h"
#include "results/json/json_parts.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace umbrameter {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson numbers_json(const std::optional<BaselineRun>& run) {
  if (!run) return nullptr;
  const CaseNumbers& n = run->numbers;
  return {{"mse", interval_json(n.mse)}, {"rmse", interval_json(rmse_of(n))}, {"noise_sd", n.noise_sd},
          {"seed_sd", n.seed_sd},        {"scored_pixels", n.scored_pixels},  {"measures", n.measures},
          {"device", run->device},       {"parameters", run->parameters}};
}

OrderedJson gate_json(const GateVerdict& gate) {
  OrderedJson measures = OrderedJson::array();
  for (const GateMeasure& m : gate.measures) {
    measures.push_back({{"class", name_of(m.kind)},
                        {"value", optional_json(m.value)},
                        {"baseline", optional_json(m.baseline)},
                        {"allowed", m.allowed},
                        {"severity", m.value ? OrderedJson(m.severity()) : OrderedJson(nullptr)}});
  }
  return measures;
}

OrderedJson case_json(const RegressCase& one) {
  return {{"scene", one.scene},
          {"label", one.label},
          {"outcome", name_of(one.verdict.outcome)},
          {"kind", one.verdict.kind},
          {"message", one.verdict.message},
          {"samples_per_pixel", one.samples_per_pixel},
          {"added_samples_per_pixel", one.added_samples_per_pixel},
          {"pictures", one.pictures},
          {"notes", one.notes},
          {"before", numbers_json(one.before)},
          {"now", numbers_json(one.now)},
          {"gate", gate_json(one.verdict.gate)}};
}

std::string xml_escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_allowed = byte >= 0x20 || c == '\t' || c == '\n' || c == '\r';
    if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '"') {
      out += "&quot;";
    } else {
      out += is_allowed ? c : '?';
    }
  }
  return out;
}

// Bytes that are no UTF-8 would make the file unreadable; JSON's writer replaces them.
std::string as_utf8(const std::string& text) {
  const std::string written = OrderedJson(text).dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
  return OrderedJson::parse(written).get<std::string>();
}

std::string xml_text(const std::string& text) {
  return xml_escaped(as_utf8(text));
}

std::string test_case(const RegressCase& one) {
  std::string text =
      fmt::format("    <testcase classname=\"{}\" name=\"{}\">\n", xml_text(one.scene), xml_text(one.label));
  if (one.verdict.outcome == CaseOutcome::fail)
    text += fmt::format("      <failure type=\"{}\" message=\"{}\"></failure>\n", xml_text(one.verdict.kind),
                        xml_text(one.verdict.message));
  std::string notes =
      fmt::format("{}; {} samples per pixel, {} of them added; {} pictures", name_of(one.verdict.outcome),
                  one.samples_per_pixel, one.added_samples_per_pixel, one.pictures);
  if (one.verdict.outcome != CaseOutcome::fail && !one.verdict.message.empty())
    notes += "\n" + one.verdict.message;
  for (const std::string& note : one.notes) notes += "\n" + note;
  return text + "      <system-out>" + xml_text(notes) + "</system-out>\n    </testcase>\n";
}

}  // namespace

std::string regress_json(const RegressResults& results) {
  OrderedJson cases = OrderedJson::array(), scenes = OrderedJson::array();
  for (const RegressCase& one : results.cases) cases.push_back(case_json(one));
  for (const RegressScene& scene : results.scenes) {
    scenes.push_back({{"name", scene.name},
                      {"hash", scene.hash},
                      {"truth_hash", scene.truth.hash},
                      {"truth_device", scene.truth.device}});
  }
  return dump({{"schema", 1},
               {"suite", results.suite},
               {"width_px", results.width_px},
               {"height_px", results.height_px},
               {"seed", results.seed},
               {"passes", results.passes()},
               {"pass", results.count(CaseOutcome::pass)},
               {"better", results.count(CaseOutcome::better)},
               {"undecided", results.count(CaseOutcome::undecided)},
               {"fail", results.count(CaseOutcome::fail)},
               {"scenes", scenes},
               {"cases", cases},
               {"skipped", skips_json(results.skipped)}});
}

std::string junit_xml(const RegressResults& results) {
  std::vector<std::string> scenes;
  for (const RegressCase& one : results.cases) {
    if (std::ranges::find(scenes, one.scene) == scenes.end()) scenes.push_back(one.scene);
  }
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"{}\" tests=\"{}\" failures=\"{}\">\n",
      xml_text(results.suite), results.cases.size(), results.count(CaseOutcome::fail));
  for (const std::string& scene : scenes) {
    size_t tests = 0, failures = 0;
    std::string cases;
    for (const RegressCase& one : results.cases) {
      if (one.scene != scene) continue;
      ++tests;
      failures += one.verdict.outcome == CaseOutcome::fail ? 1 : 0;
      cases += test_case(one);
    }
    text += fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\">\n{}  </testsuite>\n",
                        xml_text(scene), tests, failures, cases);
  }
  return text + "</testsuites>\n";
}

}  // namespace umbrameter
