// SPDX-License-Identifier: Apache-2.0
#include "scenes/pbrt/pbrt_parameters.h"

#include <charconv>
#include <cmath>

namespace umbrameter {
namespace {

void add_value(const PbrtToken& token, PbrtParameter& parameter) {
  if (token.is_string || token.text == "true" || token.text == "false")
    parameter.texts.push_back(token.text);
  else
    parameter.numbers.push_back(pbrt_number(token));
}

}  // namespace

double pbrt_number(const PbrtToken& token) {
  const char* begin = token.text.data();
  const char* end = begin + token.text.size();
  if (begin != end && *begin == '+') ++begin;
  double value = 0.0;
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (!token.is_string && error == std::errc{} && stop == end && std::isfinite(value)) return value;
  fail_input(fmt::format("'{}' is no finite number", token.text), token.where);
}

PbrtParameters::PbrtParameters(PbrtTokens& tokens, FileLocation where) : where_(std::move(where)) {
  while (const PbrtToken* ahead = tokens.peek()) {
    if (!ahead->is_string) return;
    const PbrtToken head = *tokens.next();
    const size_t type_end = std::min(head.text.find_first_of(" \t"), head.text.size());
    const size_t name = std::min(head.text.find_first_not_of(" \t", type_end), head.text.size());
    const size_t name_end = std::min(head.text.find_first_of(" \t", name), head.text.size());
    if (name == name_end) fail_input(fmt::format("'{}' is no type and name", head.text), head.where);
    PbrtParameter parameter{head.text.substr(0, type_end), {}, {}, head.where};
    auto value = tokens.next();
    if (!value || value->text == "]")
      fail_input(fmt::format("parameter '{}' has no value", head.text), head.where);
    if (value->is_string || value->text != "[") {
      add_value(*value, parameter);
    } else {
      for (value = tokens.next(); value && (value->is_string || value->text != "]"); value = tokens.next())
        add_value(*value, parameter);
      if (!value) fail_input(fmt::format("the values of parameter '{}' have no end", head.text), head.where);
    }
    parameters_[head.text.substr(name, name_end - name)] = std::move(parameter);
  }
}

const PbrtParameter* PbrtParameters::find(const std::string& name) const {
  const auto found = parameters_.find(name);
  return found == parameters_.end() ? nullptr : &found->second;
}

double PbrtParameters::number(const std::string& name, double fallback) const {
  const PbrtParameter* parameter = find(name);
  if (parameter == nullptr) return fallback;
  if (parameter->numbers.size() == 1) return parameter->numbers.front();
  fail_input(fmt::format("parameter '{}' is not one number", name), parameter->where);
}

bool PbrtParameters::boolean(const std::string& name, bool fallback) const {
  return text(name, fallback ? "true" : "false") == "true";
}

std::string PbrtParameters::text(const std::string& name, const std::string& fallback) const {
  const PbrtParameter* parameter = find(name);
  if (parameter == nullptr) return fallback;
  if (parameter->texts.size() == 1) return parameter->texts.front();
  fail_input(fmt::format("parameter '{}' is not one string", name), parameter->where);
}

std::vector<glm::dvec3> PbrtParameters::points(const std::string& name) const {
  const PbrtParameter* parameter = find(name);
  if (parameter == nullptr) return {};
  const std::vector<double>& n = parameter->numbers;
  if (n.size() % 3 != 0)
    fail_input(fmt::format("parameter '{}' has {} numbers, no multiple of 3", name, n.size()),
               parameter->where);
  std::vector<glm::dvec3> points;
  for (size_t i = 0; i < n.size(); i += 3) points.emplace_back(n[i], n[i + 1], n[i + 2]);
  return points;
}

glm::dvec3 PbrtParameters::point(const std::string& name, const glm::dvec3& fallback) const {
  const auto all = points(name);
  return all.empty() ? fallback : all.front();
}

}  // namespace umbrameter
