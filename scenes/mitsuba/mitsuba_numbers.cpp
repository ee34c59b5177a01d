// SPDX-License-Identifier: Apache-2.0
#include "scenes/mitsuba/mitsuba_numbers.h"

#include "scenes/mitsuba/mitsuba_tree.h"
#include "scenes/rotation.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

namespace umbrameter {
namespace {

using glm::dmat4;
using glm::dvec3;

/// Separated by commas and white space.
std::vector<double> numbers_of(const std::string& text, const FileLocation& where) {
  constexpr const char* kBetween = ", \t\r\n";
  std::vector<double> numbers;
  for (size_t at = text.find_first_not_of(kBetween); at != std::string::npos;) {
    const size_t end = std::min(text.find_first_of(kBetween, at), text.size());
    numbers.push_back(mitsuba_number(text.substr(at, end - at), where));
    at = text.find_first_not_of(kBetween, end);
  }
  return numbers;
}

dvec3 three(const std::vector<double>& numbers, const std::string& what, const FileLocation& where) {
  if (numbers.size() == 1) return dvec3(numbers[0]);
  if (numbers.size() == 3) return {numbers[0], numbers[1], numbers[2]};
  fail_input(fmt::format("'{}' has {} numbers, not 3", what, numbers.size()), where);
}

dvec3 point_of(const MitsubaNode& node, const std::string& attribute) {
  return three(numbers_of(node.get(attribute), node.where), attribute, node.where);
}

dvec3 unit(const dvec3& v, const MitsubaNode& node) {
  const double length = glm::length(v);
  if (length > 0.0 && std::isfinite(length)) return v / length;
  fail_input(fmt::format("<{}> has a vector without a direction", node.tag), node.where);
}

/// x to the left, y up, z ahead.
dmat4 look_at(const MitsubaNode& node) {
  const dvec3 origin = point_of(node, "origin");
  const dvec3 ahead = unit(point_of(node, "target") - origin, node);
  const dvec3 up = node.get("up").empty() ? dvec3(0, 1, 0) : point_of(node, "up");
  const dvec3 left = unit(glm::cross(up, ahead), node);
  return {glm::dvec4(left, 0), glm::dvec4(glm::cross(ahead, left), 0), glm::dvec4(ahead, 0),
          glm::dvec4(origin, 1)};
}

/// In rows.
dmat4 matrix(const MitsubaNode& node) {
  const std::vector<double> n = numbers_of(node.get("value"), node.where);
  if (n.size() == 9)
    return glm::transpose(dmat4(n[0], n[1], n[2], 0, n[3], n[4], n[5], 0, n[6], n[7], n[8], 0, 0, 0, 0, 1));
  if (n.size() != 16) fail_input(fmt::format("<matrix> has {} numbers, not 16 or 9", n.size()), node.where);
  if (n[12] != 0.0 || n[13] != 0.0 || n[14] != 0.0 || n[15] != 1.0)
    fail_input("<matrix> has another last row than 0 0 0 1", node.where);
  return glm::transpose(glm::make_mat4(n.data()));
}

dmat4 step(const MitsubaNode& node) {
  dmat4 m(1.0);
  if (node.tag == "translate") {
    m[3] = glm::dvec4(mitsuba_vector(node, 0.0), 1.0);
    return m;
  }
  if (node.tag == "scale") {
    const dvec3 scale = mitsuba_vector(node, 1.0);
    for (int axis = 0; axis < 3; ++axis) m[axis][axis] = scale[axis];
    return m;
  }
  if (node.tag == "rotate")
    return dmat4(
        rotation(unit(mitsuba_vector(node, 0.0), node), mitsuba_number(node.get("angle"), node.where)));
  if (node.tag == "lookat") return look_at(node);
  if (node.tag == "matrix") return matrix(node);
  fail_input(fmt::format("<{}> is no step of a transform", node.tag), node.where,
             "translate, scale, rotate, lookat and matrix are");
}

}  // namespace

double mitsuba_number(const std::string& text, const FileLocation& where) {
  const char* begin = text.data();
  const char* end = begin + text.size();
  while (begin != end && (*begin == ' ' || *begin == '+')) ++begin;
  while (begin != end && end[-1] == ' ') --end;
  double value = 0.0;
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error == std::errc{} && stop == end && std::isfinite(value)) return value;
  fail_input(fmt::format("'{}' is no finite number", text), where);
}

dvec3 mitsuba_vector(const MitsubaNode& node, double fallback) {
  if (const std::string& value = node.get("value"); !value.empty())
    return three(numbers_of(value, node.where), node.tag, node.where);
  dvec3 result(fallback);
  int axis = 0;
  for (const char* name : {"x", "y", "z"}) {
    const std::string& text = node.get(name);
    if (!text.empty()) result[axis] = mitsuba_number(text, node.where);
    ++axis;
  }
  return result;
}

dmat4 mitsuba_transform(const MitsubaNode& node, const std::string& name) {
  dmat4 result(1.0);
  const MitsubaNode* transform = node.find(name);
  if (transform == nullptr) return result;
  for (const MitsubaNode& child : transform->children) result = step(child) * result;
  const double* values = glm::value_ptr(result);
  if (std::ranges::all_of(values, values + 16, [](double value) { return std::isfinite(value); }))
    return result;
  fail_input("the transform is not finite", transform->where);
}

}  // namespace umbrameter
