// SPDX-License-Identifier: Apache-2.0
#include "report/regress_output.h"
#include "results/json/json_optional.h"
#include "results/json/json_parts.h"
#include "results/json/schemas.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include <algorithm>
#include <map>
#include <span>
#include <sstream>

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
    measures.push_back({{"class", name_of(m)},
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

// Bytes that are no UTF-8 would make the file unreadable; JSON's writer replaces them.
std::string as_utf8(const std::string& text) {
  const std::string written = OrderedJson(text).dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
  return OrderedJson::parse(written).get<std::string>();
}

/// XML has no other control characters, even escaped.
std::string xml_text(const std::string& text) {
  std::string out = as_utf8(text);
  const auto is_forbidden = [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 && c != '\t' && c != '\n' && c != '\r';
  };
  std::ranges::replace_if(out, is_forbidden, '?');
  return out;
}

void set(pugi::xml_node node, const char* name, const std::string& value) {
  node.append_attribute(name).set_value(xml_text(value).c_str());
}

void set_counts(pugi::xml_node node, std::span<const RegressCase> cases) {
  const auto fails = [](const RegressCase& one) { return one.verdict.outcome == CaseOutcome::fail; };
  set(node, "tests", std::to_string(cases.size()));
  set(node, "failures", std::to_string(std::ranges::count_if(cases, fails)));
}

void add_case(const RegressCase& one, pugi::xml_node suite) {
  pugi::xml_node test = suite.append_child("testcase");
  set(test, "classname", one.scene);
  set(test, "name", one.label);
  if (one.verdict.outcome == CaseOutcome::fail) {
    pugi::xml_node failure = test.append_child("failure");
    set(failure, "type", one.verdict.kind);
    set(failure, "message", one.verdict.message);
  }
  std::string notes =
      fmt::format("{}; {} samples per pixel, {} of them added; {} pictures", name_of(one.verdict.outcome),
                  one.samples_per_pixel, one.added_samples_per_pixel, one.pictures);
  if (one.verdict.outcome != CaseOutcome::fail && !one.verdict.message.empty())
    notes += "\n" + one.verdict.message;
  for (const std::string& note : one.notes) notes += "\n" + note;
  test.append_child("system-out").text().set(xml_text(notes).c_str());
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
  return dump({{"schema", kRegressSchema.number},
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
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  set(declaration, "version", "1.0");
  set(declaration, "encoding", "UTF-8");
  pugi::xml_node suites = document.append_child("testsuites");
  set(suites, "name", results.suite);
  set_counts(suites, results.cases);
  std::map<std::string, std::vector<RegressCase>> cases;
  std::vector<std::string> scenes;
  for (const RegressCase& one : results.cases) {
    if (!cases.contains(one.scene)) scenes.push_back(one.scene);
    cases[one.scene].push_back(one);
  }
  for (const std::string& scene : scenes) {
    pugi::xml_node suite = suites.append_child("testsuite");
    set(suite, "name", scene);
    set_counts(suite, cases[scene]);
    for (const RegressCase& one : cases[scene]) add_case(one, suite);
  }
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

}  // namespace umbrameter
