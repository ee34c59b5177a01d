// SPDX-License-Identifier: Apache-2.0
#include "realtime/manifest/check_technique.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace umbrameter {
namespace {

/// Passes in the order of a frame; those of loops once.
std::vector<const PassDeclaration*> in_order(const std::vector<PassDeclaration>& passes) {
  std::vector<const PassDeclaration*> order;
  for (const PassDeclaration& pass : passes) {
    if (pass.kind != PassKind::loop) {
      order.push_back(&pass);
      continue;
    }
    const auto body = in_order(pass.body);
    order.insert(order.end(), body.begin(), body.end());
  }
  return order;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

/// Blending adds to what is there, and drawing triangles leaves it between them.
bool keeps_contents(const PassDeclaration& pass) {
  return !pass.state.clear && (leaves_texels_out(pass) || pass.state.blend != BlendMode::none);
}

[[noreturn]] void fail(const PassDeclaration& pass, std::string_view does, const std::string& name) {
  fail_input(
      fmt::format("pass '{}' {} '{}' as the frame before left it: a frame that is drawn again, to be timed, "
                  "would be another",
                  pass.id, does, name),
      pass.where,
      fmt::format("write '{0}' anew in each frame, before it is used; what the frame before wrote is "
                  "'previous.{0}'",
                  name));
}

}  // namespace

void check_frames(const Technique& technique) {
  const std::vector<const PassDeclaration*> order = in_order(technique.passes);
  std::set<std::string, std::less<>> of_this_frame;
  for (size_t i = 0; i < order.size(); ++i) {
    const PassDeclaration& pass = *order[i];
    if (pass.once) continue;
    const auto comes_from_before = [&](const std::string& name) {
      if (of_this_frame.contains(name)) return false;
      return std::any_of(order.begin() + static_cast<std::ptrdiff_t>(i), order.end(),
                         [&](const auto* later) { return !later->once && contains(later->writes, name); });
    };
    for (const std::string& name : pass.reads) {
      const bool is_own_level_below = contains(pass.writes, name);
      if (!is_own_level_below && comes_from_before(name)) fail(pass, "reads", name);
    }
    for (const std::string& name : pass.writes) {
      if (keeps_contents(pass) && comes_from_before(name)) fail(pass, "draws over", name);
    }
    of_this_frame.insert(pass.writes.begin(), pass.writes.end());
  }
}

}  // namespace umbrameter
