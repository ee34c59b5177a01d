// SPDX-License-Identifier: Apache-2.0
#include "study/regress/suite_file.h"

#include "core/files.h"
#include "core/names.h"
#include "results/regress/case_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace umbrameter {
namespace {

constexpr std::array<std::pair<const char*, GateLimit GateLimits::*>, 8> kGateLimitNames = {
    {{"fault", &GateLimits::fault},
     {"resolution", &GateLimits::resolution},
     {"softness", &GateLimits::softness},
     {"hardening", &GateLimits::hardening},
     {"offset", &GateLimits::offset},
     {"noise", &GateLimits::noise},
     {"banding", &GateLimits::banding},
     {"error", &GateLimits::error}}};

double at_least(TomlReader& reader, const std::string& key, double least, double fallback) {
  const double value = reader.number(key, fallback);
  if (value < least) reader.fail(key, fmt::format("'{}' is {}, less than {}", key, value, least));
  return value;
}

GateLimit read_limit(const TomlNode& table, const std::string& name, const GateLimit& fallback) {
  TomlReader reader(table, fmt::format("[gates.worse_by.{}]", name));
  const GateLimit limit = {at_least(reader, "excess", 0.0, fallback.excess),
                           at_least(reader, "share", 0.0, fallback.share)};
  if (limit.excess == 0.0)
    reader.fail("excess", "'excess' is 0, which any noise exceeds", "a positive number");
  reader.finish();
  return limit;
}

FurtherLimit read_further(const TomlNode& table, const Metric& metric) {
  return {metric.better, read_limit(table, metric.key, metric.gate ? metric.gate->limit : GateLimit{})};
}

GateLimits read_worse_by(const TomlNode& table) {
  TomlReader reader(table, "[gates.worse_by]");
  GateLimits limits = gate_limits();
  for (const auto& [name, member] : kGateLimitNames) {
    if (const TomlNode* node = reader.find(name)) limits.*member = read_limit(*node, name, limits.*member);
  }
  for (const Metric& metric : metric_catalogue()) {
    const TomlNode* node = is_gate_measure(metric) ? reader.find(metric.key) : nullptr;
    if (node != nullptr) limits.further[metric.key] = read_further(*node, metric);
  }
  reader.finish();
  return limits;
}

std::map<std::string, double> read_at_most(const TomlNode& table) {
  TomlReader reader(table, "[gates.at_most]");
  std::map<std::string, double> limits;
  for (const std::string& name : measure_names()) {
    if (!reader.has(name)) continue;
    limits[name] = reader.number(name);
    if (limits[name] <= 0.0) reader.fail(name, fmt::format("'{}' is {}, not positive", name, limits[name]));
  }
  reader.finish();
  return limits;
}

RegressGates read_gates(const TomlNode& table) {
  TomlReader reader(table, "[gates]");
  RegressGates gates;
  if (const TomlNode* node = reader.find("worse_by")) gates.worse_by = read_worse_by(*node);
  if (const TomlNode* node = reader.find("at_most")) gates.at_most = read_at_most(*node);
  gates.ratchet = reader.boolean("ratchet", gates.ratchet);
  gates.same_share = at_least(reader, "same_share", 0.0, gates.same_share);
  gates.same_rmse = at_least(reader, "same_rmse", 0.0, gates.same_rmse);
  gates.sigmas = at_least(reader, "sigmas", 1.0, gates.sigmas);
  if (reader.has("time_ratio")) gates.time_ratio = at_least(reader, "time_ratio", 1.0, 1.0);
  reader.finish();
  return gates;
}

void require_no_study(const StudyFile& study) {
  if (!study.claims.empty())
    fail_input("a suite has no [[claim]]", study.claims.front().where,
               "claims belong to studies, which 'bench' runs");
  if (study.seeds.size() > 1)
    fail_input("a suite has one seed", study.where, "undecided cases get further ones by themselves");
}

// The keys of a suite alone are taken out; what is left is a study.
RegressSuite read_suite(TomlNode root) {
  RegressSuite suite;
  constexpr std::array<std::string_view, 2> kOwnKeys = {"gates", "most_samples_per_pixel"};
  TomlNode own, study;
  own.where = study.where = root.where;
  for (auto& entry : root.entries) {
    TomlNode& home = std::ranges::find(kOwnKeys, entry.name) == kOwnKeys.end() ? study : own;
    home.entries.push_back(std::move(entry));
  }
  suite.study = read_study(study);
  require_no_study(suite.study);
  TomlReader reader(own, "the suite");
  if (const TomlNode* gates = reader.find("gates")) suite.gates = read_gates(*gates);
  const int64_t most = reader.integer("most_samples_per_pixel", 0);
  if (most < 0 || most > std::numeric_limits<int>::max())
    reader.fail("most_samples_per_pixel",
                fmt::format("'most_samples_per_pixel' is {}, no number of samples", most));
  suite.most_samples_per_pixel = static_cast<int>(most);
  return suite;
}

}  // namespace

RegressSuite parse_suite(std::string_view document, const std::string& file) {
  return read_suite(parse_toml(document, file));
}

RegressSuite load_suite(const std::filesystem::path& path) {
  return read_suite(parse_toml_file(path));
}

}  // namespace umbrameter
