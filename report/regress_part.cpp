// SPDX-License-Identifier: Apache-2.0
#include "report/regress_part.h"

#include "core/html.h"
#include "report/html_table.h"
#include "report/side_files.h"
#include "report/table.h"
#include "study/format.h"
#include "study/run_json.h"

#include <fmt/format.h>

#include <algorithm>

namespace umbrameter {
namespace {

using Json = nlohmann::ordered_json;

std::string summary_text(const Json& check) {
  return fmt::format("{}: {} cases, {} pass, {} better, {} undecided, {} fail; {} x {} px, seed {}",
                     text_of(check, "suite"), check.at("cases").size(), check.at("pass").get<size_t>(),
                     check.at("better").get<size_t>(), check.at("undecided").get<size_t>(),
                     check.at("fail").get<size_t>(), check.at("width_px").get<int>(),
                     check.at("height_px").get<int>(), check.at("seed").get<uint64_t>());
}

/// Anchor of the case's run in this page; empty when it shows none.
std::string anchor_of(const Json& one, const Results& results) {
  for (size_t i = 0; i < results.scenes.size(); ++i) {
    if (results.scenes[i].name != text_of(one, "scene")) continue;
    const auto& runs = results.scenes[i].techniques;
    for (size_t k = 0; k < runs.size(); ++k) {
      if (runs[k].label == text_of(one, "label")) return run_anchor(i, k);
    }
  }
  return {};
}

std::string run_cell(const Json& one, const Results& results) {
  const std::string anchor = anchor_of(one, results);
  if (anchor.empty()) return text_cell(text_of(one, "label"));
  return fmt::format("<td><a href=\"#{}\">{}</a></td>", anchor, escape_html(text_of(one, "label")));
}

std::string rmse_cell(const char* column, const Json& numbers) {
  const auto rmse = numbers.is_null() ? std::nullopt : read_interval(numbers.at("rmse"));
  return number_cell(column, rmse ? std::optional(rmse->value) : std::nullopt, format_interval(rmse));
}

std::optional<double> number_of(const Json& value) {
  return value.is_null() ? std::nullopt : std::optional(value.get<double>());
}

std::string severity_cell(const Json& gate) {
  if (gate.empty()) return number_cell("severity", std::nullopt, kNotApplicable);
  double worst = 0.0;
  for (const Json& measure : gate) worst = std::max(worst, number_of(measure.at("severity")).value_or(0.0));
  return number_cell("severity", worst, fmt::format("{:.2f}", worst));
}

std::string remarks(const Json& one) {
  std::string text = text_of(one, "message");
  for (const Json& note : one.at("notes")) text += (text.empty() ? "" : "; ") + note.get<std::string>();
  return text;
}

std::string effort(const Json& one) {
  return fmt::format("{} samples a pixel, {} of them added; {} pictures",
                     one.at("samples_per_pixel").get<int>(), one.at("added_samples_per_pixel").get<int>(),
                     one.at("pictures").get<int>());
}

std::string case_row(const Json& one, const Results& results) {
  const std::string outcome = text_of(one, "outcome"), kind = text_of(one, "kind");
  return name_cell(text_of(one, "scene")) + run_cell(one, results) +
         text_cell(kind.empty() ? outcome : outcome + ": " + kind, "outcome " + escape_html(outcome)) +
         rmse_cell("rmse_before", one.at("before")) + rmse_cell("rmse_now", one.at("now")) +
         severity_cell(one.at("gate")) + text_cell(effort(one)) + text_cell(remarks(one));
}

std::string short_number(const std::optional<double>& value) {
  return value ? fmt::format("{:.4g}", *value) : kNotApplicable;
}

/// What the gate measured of a case, folded up.
std::string gate_details(const Json& one) {
  std::vector<std::string> rows;
  for (const Json& measure : one.at("gate")) {
    std::string cells = name_cell(text_of(measure, "class"));
    for (const char* key : {"baseline", "value", "allowed", "severity"}) {
      const auto value = number_of(measure.at(key));
      cells += number_cell(key, value, short_number(value));
    }
    rows.push_back(cells);
  }
  if (rows.empty()) return {};
  const std::string name = text_of(one, "scene") + ", " + text_of(one, "label");
  return fmt::format(
      "<details class=\"facts\"><summary>{}: gate</summary>{}</details>\n", escape_html(name),
      scroll_table("Gate of " + name,
                   {{"Class"}, {"Before", true}, {"Now", true}, {"Allowed", true}, {"Used", true}}, rows));
}

std::string check_html(const Json& check, const Results& results) {
  std::vector<std::string> rows;
  std::string details;
  for (const Json& one : check.at("cases")) {
    rows.push_back(case_row(one, results));
    details += gate_details(one);
  }
  return fmt::format("<p>{}</p>\n", escape_html(summary_text(check))) +
         scroll_table("Before and after",
                      {{"Scene"},
                       {"Run"},
                       {"Verdict"},
                       {"RMSE before [95 %]", true},
                       {"RMSE now [95 %]", true},
                       {"Nearest to a gate", true},
                       {"Effort"},
                       {"Remarks"}},
                      rows) +
         details;
}

}  // namespace

RegressPart regress_part(const std::filesystem::path& folder, const Results& results) {
  RegressPart part;
  for_side_files(folder, "regress", [&](const Json& check, const std::string&) {
    part.html += check_html(check, results);
    const bool passes = check.at("passes").get<bool>();
    part.verdict += fmt::format("<p{}><a href=\"#regress\">Regression</a> of {}</p>\n",
                                passes ? "" : " class=\"problem\"", escape_html(summary_text(check)));
  });
  if (part.html.empty()) return part;
  part.html =
      "<section id=\"regress\"><h2>Regression</h2>\n"
      "<p>Against the baseline, both against the truth. Nearest to a gate: the part of what the gate allows "
      "that its worst "
      "measure uses; above 1 it fails. Before and now of every measure are under the gates below the "
      "table.</p>\n" +
      part.html + "</section>\n";
  return part;
}

}  // namespace umbrameter
