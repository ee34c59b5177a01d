// SPDX-License-Identifier: Apache-2.0
#include "scenes/pbrt/pbrt_transforms.h"

#include "scenes/pbrt/pbrt_parameters.h"
#include "scenes/rotation.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace umbrameter {
namespace {

using glm::dmat4;
using glm::dvec3;

/// Arguments of one statement.
class TransformArguments {
 public:
  TransformArguments(PbrtTokens& tokens, const FileLocation& where) : tokens_(tokens), where_(where) {}

  double number() {
    const auto token = tokens_.next();
    if (!token) fail_input("the file ends within a statement", where_);
    return pbrt_number(*token);
  }

  dvec3 vector() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }

  /// 16 numbers, with or without brackets, column by column.
  dmat4 matrix() {
    const bool has_brackets = tokens_.peek() != nullptr && tokens_.peek()->text == "[";
    if (has_brackets) tokens_.next();
    std::array<double, 16> n{};
    for (double& value : n) value = number();
    if (has_brackets) {
      const auto end = tokens_.next();
      if (!end || end->text != "]") fail_input("a matrix has more than 16 numbers", where_);
    }
    if (n[3] != 0.0 || n[7] != 0.0 || n[11] != 0.0 || n[15] != 1.0)
      fail_input("a matrix has another last row than 0 0 0 1", where_);
    return glm::make_mat4(n.data());
  }

  dvec3 unit(const dvec3& v) const {
    const double length = glm::length(v);
    if (length > 0.0 && std::isfinite(length)) return v / length;
    fail_input("a vector has no direction", where_);
  }

  /// What it makes of camera space: x right, y up, z ahead.
  dmat4 look_at() {
    const dvec3 eye = vector(), at = vector(), up = vector();
    const dvec3 ahead = unit(at - eye), right = unit(glm::cross(unit(up), ahead));
    return glm::inverse(dmat4(glm::dvec4(right, 0), glm::dvec4(glm::cross(ahead, right), 0),
                              glm::dvec4(ahead, 0), glm::dvec4(eye, 1)));
  }

  dmat4 translation() {
    dmat4 m(1.0);
    m[3] = glm::dvec4(vector(), 1.0);
    return m;
  }
  dmat4 scale() {
    const dvec3 s = vector();
    return {s.x, 0, 0, 0, 0, s.y, 0, 0, 0, 0, s.z, 0, 0, 0, 0, 1};
  }
  dmat4 turn() {
    const double angle_deg = number();
    return dmat4(rotation(unit(vector()), angle_deg));
  }

 private:
  PbrtTokens& tokens_;
  const FileLocation& where_;
};

}  // namespace

std::optional<dmat4> read_pbrt_transform(const std::string& statement, const dmat4& ctm,
                                         const PbrtSystems& systems, PbrtTokens& tokens,
                                         const FileLocation& where) {
  TransformArguments arguments(tokens, where);
  dmat4 next = ctm;
  if (statement == "Identity") {
    next = dmat4(1.0);
  } else if (statement == "Translate") {
    next = ctm * arguments.translation();
  } else if (statement == "Scale") {
    next = ctm * arguments.scale();
  } else if (statement == "Rotate") {
    next = ctm * arguments.turn();
  } else if (statement == "LookAt") {
    next = ctm * arguments.look_at();
  } else if (statement == "Transform") {
    next = arguments.matrix();
  } else if (statement == "ConcatTransform") {
    next = ctm * arguments.matrix();
  } else if (statement == "CoordSysTransform") {
    const std::string name = pbrt_word(tokens, where);
    const auto found = systems.find(name);
    if (found == systems.end()) fail_input(fmt::format("no coordinate system is called '{}'", name), where);
    next = found->second;
  } else {
    return std::nullopt;
  }
  const double* values = glm::value_ptr(next);
  if (std::ranges::all_of(values, values + 16, [](double value) { return std::isfinite(value); }))
    return next;
  fail_input("the transform is not finite", where);
}

std::string pbrt_word(PbrtTokens& tokens, const FileLocation& where) {
  const auto token = tokens.next();
  if (!token || !token->is_string) fail_input("a name in quotes is missing", where);
  return token->text;
}

}  // namespace umbrameter
