// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a reader did not carry over, counted by kind.

#include <string>
#include <vector>

namespace umbrameter {

class Tally {
 public:
  /// Both follow a number: "shape of type 'hair' is left out", "shapes of type 'hair' are left out".
  void add(const std::string& one, const std::string& many);
  /// "<noun> of type '<type>' is left out" and its plural.
  void leave_out(const std::string& noun, const std::string& type);

  /// A sentence a kind, in order of first appearance.
  std::vector<std::string> lines() const;

 private:
  struct Kind {
    std::string one, many;
    size_t count = 0;
  };
  std::vector<Kind> kinds_;
};

}  // namespace umbrameter
