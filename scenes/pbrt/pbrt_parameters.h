// SPDX-License-Identifier: Apache-2.0
#pragma once
// The list behind a statement of pbrt: "type name" value or "type name" [ values ].

#include "scenes/pbrt/pbrt_tokens.h"

#include <glm/vec3.hpp>

#include <map>
#include <string>
#include <vector>

namespace umbrameter {

struct PbrtParameter {
  std::string type;
  std::vector<double> numbers;
  std::vector<std::string> texts;  // strings and booleans
  FileLocation where;
};

/// A finite number; Error{input} at its place for anything else.
double pbrt_number(const PbrtToken& token);

class PbrtParameters {
 public:
  /// Takes what follows a statement. Error{input} for values that are not finite numbers, strings or booleans.
  PbrtParameters(PbrtTokens& tokens, FileLocation where);

  const FileLocation& where() const { return where_; }
  const PbrtParameter* find(const std::string& name) const;
  double number(const std::string& name, double fallback) const;
  bool boolean(const std::string& name, bool fallback) const;
  std::string text(const std::string& name, const std::string& fallback) const;
  /// Numbers in threes; none when absent. Error{input} when some are left over.
  std::vector<glm::dvec3> points(const std::string& name) const;
  glm::dvec3 point(const std::string& name, const glm::dvec3& fallback) const;

 private:
  FileLocation where_;
  std::map<std::string, PbrtParameter> parameters_;
};

}  // namespace umbrameter
