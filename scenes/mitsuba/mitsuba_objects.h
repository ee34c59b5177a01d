// SPDX-License-Identifier: Apache-2.0
#pragma once
// Objects of a Mitsuba scene that others refer to by their id.

#include "scenes/mitsuba/mitsuba_tree.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {

class MitsubaObjects {
 public:
  /// `root` must outlive it. Error{input} where two objects have one id.
  explicit MitsubaObjects(const MitsubaNode& root);

  /// `node`, or what it refers to where it is a <ref>. Error{input} when that is not there.
  const MitsubaNode& resolve(const MitsubaNode& node) const;
  /// Of `node`'s children, and what they refer to, those that are <tag>.
  std::vector<const MitsubaNode*> nested(const MitsubaNode& node, std::string_view tag) const;

 private:
  void collect(const MitsubaNode& node);
  void add(const std::string& id, const MitsubaNode& node);

  std::map<std::string, const MitsubaNode*> by_id_;
};

}  // namespace umbrameter
