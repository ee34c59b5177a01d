// SPDX-License-Identifier: Apache-2.0
#include "scenes/mitsuba/mitsuba_objects.h"

#include "core/names.h"

namespace umbrameter {

MitsubaObjects::MitsubaObjects(const MitsubaNode& root) {
  collect(root);
  for (const MitsubaNode& node : root.children) {
    if (node.tag == "alias") add(node.get("as"), resolve(node));
  }
}

void MitsubaObjects::add(const std::string& id, const MitsubaNode& node) {
  if (!by_id_.emplace(id, &node).second) fail_input(fmt::format("two objects have id '{}'", id), node.where);
}

void MitsubaObjects::collect(const MitsubaNode& node) {
  const bool is_reference = node.tag == "ref" || node.tag == "alias";
  if (const std::string& id = node.get("id"); !id.empty() && !is_reference) add(id, node);
  for (const MitsubaNode& child : node.children) collect(child);
}

const MitsubaNode& MitsubaObjects::resolve(const MitsubaNode& node) const {
  if (node.tag != "ref" && node.tag != "alias") return node;
  const std::string& id = node.get("id");
  const auto found = by_id_.find(id);
  if (found != by_id_.end()) return *found->second;
  std::vector<std::string> known;
  for (const auto& [name, object] : by_id_) known.push_back(name);
  fail_input(fmt::format("no object has id '{}'", id), node.where, suggest_name(id, known));
}

std::vector<const MitsubaNode*> MitsubaObjects::nested(const MitsubaNode& node, std::string_view tag) const {
  std::vector<const MitsubaNode*> found;
  for (const MitsubaNode& child : node.children) {
    const MitsubaNode& object = resolve(child);
    if (object.tag == tag) found.push_back(&object);
  }
  return found;
}

}  // namespace umbrameter
