// SPDX-License-Identifier: Apache-2.0
#include "scenes/mitsuba/mitsuba_tree.h"

#include "core/files.h"
#include "core/names.h"
#include "scenes/mitsuba/mitsuba_numbers.h"

#include <pugixml.hpp>

#include <algorithm>
#include <cctype>

namespace umbrameter {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMaxXmlBytes = size_t{256} << 20;
constexpr size_t kMaxIncludes = 1000;
constexpr size_t kMaxElements = 2'000'000;
constexpr int kDeepestElement = 64;

/// "toWorld" of Mitsuba 0.6 is "to_world" since 2.
std::string snake_case(const std::string& name) {
  std::string result;
  for (const char c : name) {
    const bool is_capital = std::isupper(static_cast<unsigned char>(c)) != 0;
    if (is_capital && !result.empty() && result.back() != '_') result += '_';
    result += is_capital ? static_cast<char>(std::tolower(static_cast<unsigned char>(c))) : c;
  }
  return result;
}

class TreeReader {
 public:
  MitsubaTree read(const fs::path& path) {
    tree_.root = read_document(path, {});
    return std::move(tree_);
  }

 private:
  /// Where a file's lines begin.
  struct Source {
    std::string file;
    std::vector<size_t> line_starts{0};

    FileLocation at(ptrdiff_t offset) const {
      const auto after =
          std::ranges::upper_bound(line_starts, static_cast<size_t>(std::max<ptrdiff_t>(offset, 0)));
      return {file, static_cast<int>(after - line_starts.begin())};
    }
  };

  MitsubaNode read_document(const fs::path& path, const FileLocation& from) {
    std::error_code ignored;
    const fs::path whole = fs::weakly_canonical(path, ignored);
    if (std::ranges::find(open_, whole) != open_.end())
      fail_input(fmt::format("file '{}' includes itself", path.string()), from);
    const std::string bytes = read_file(path);
    if (bytes.size() > kMaxXmlBytes) fail_input("the file is larger than 256 MiB", {path.string()});
    Source source{path.string()};
    for (size_t i = 0; i < bytes.size(); ++i)
      if (bytes[i] == '\n') source.line_starts.push_back(i + 1);
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(bytes.data(), bytes.size());
    if (!parsed)
      fail_input(fmt::format("this is no XML: {}", parsed.description()), source.at(parsed.offset));
    const pugi::xml_node root = document.document_element();
    if (std::string_view(root.name()) != "scene")
      fail_input(fmt::format("this is no Mitsuba scene: its root is <{}>, not <scene>", root.name()),
                 source.at(root.offset_debug()));
    open_.push_back(whole);
    MitsubaNode node = read_element(root, source, 0);
    open_.pop_back();
    return node;
  }

  MitsubaNode read_element(const pugi::xml_node& xml, const Source& source, int depth) {
    MitsubaNode node;
    node.where = source.at(xml.offset_debug());
    if (depth > kDeepestElement) fail_input("elements are nested deeper than 64", node.where);
    if (++elements_ > kMaxElements) fail_input("the scene has more than 2,000,000 elements", node.where);
    node.tag = xml.name() == std::string_view("lookAt") ? "lookat" : xml.name();
    for (const pugi::xml_attribute& attribute : xml.attributes())
      node.attributes[attribute.name()] = filled_in(attribute.value(), node.where);
    if (const auto name = node.attributes.find("name"); name != node.attributes.end())
      name->second = snake_case(name->second);
    for (const pugi::xml_node& child : xml.children()) {
      if (child.type() == pugi::node_element) read_child(child, source, depth, node);
    }
    return node;
  }

  void read_child(const pugi::xml_node& xml, const Source& source, int depth, MitsubaNode& parent) {
    MitsubaNode child = read_element(xml, source, depth + 1);
    if (child.tag == "default") {
      parameters_.try_emplace(xml.attribute("name").value(), child.get("value"));
    } else if (child.tag == "include") {
      include(child, parent);
    } else {
      parent.children.push_back(std::move(child));
    }
  }

  void include(const MitsubaNode& node, MitsubaNode& parent) {
    const fs::path path = fs::path(node.where.file).parent_path() / node.get("filename");
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored))
      fail_input(fmt::format("the included file '{}' is not there", path.string()), node.where);
    if (tree_.files.size() == kMaxIncludes) fail_input("more than 1,000 files are included", node.where);
    tree_.files.push_back(path);
    MitsubaNode included = read_document(path, node.where);
    std::ranges::move(included.children, std::back_inserter(parent.children));
  }

  std::string filled_in(const std::string& text, const FileLocation& where) const {
    std::string result;
    for (size_t i = 0; i < text.size();) {
      if (text[i] != '$') {
        result += text[i++];
        continue;
      }
      size_t end = i + 1;
      while (end < text.size() &&
             (std::isalnum(static_cast<unsigned char>(text[end])) != 0 || text[end] == '_'))
        ++end;
      const std::string name = text.substr(i + 1, end - i - 1);
      const auto found = parameters_.find(name);
      if (found == parameters_.end()) fail_parameter(name, where);
      result += found->second;
      i = end;
    }
    return result;
  }

  [[noreturn]] void fail_parameter(const std::string& name, const FileLocation& where) const {
    std::vector<std::string> known;
    for (const auto& [parameter, value] : parameters_) known.push_back(parameter);
    fail_input(fmt::format("parameter '${}' has no value", name), where,
               known.empty() ? "give it one with <default>" : suggest_name(name, known));
  }

  MitsubaTree tree_;
  std::vector<fs::path> open_;
  std::map<std::string, std::string> parameters_;
  size_t elements_ = 0;
};

}  // namespace

const std::string& MitsubaNode::get(const std::string& attribute) const {
  static const std::string kAbsent;
  const auto found = attributes.find(attribute);
  return found == attributes.end() ? kAbsent : found->second;
}

const MitsubaNode* MitsubaNode::find(const std::string& name) const {
  const auto found =
      std::ranges::find_if(children, [&](const auto& child) { return child.get("name") == name; });
  return found == children.end() ? nullptr : &*found;
}

double MitsubaNode::number(const std::string& name, double fallback) const {
  const MitsubaNode* node = find(name);
  return node == nullptr ? fallback : mitsuba_number(node->get("value"), node->where);
}

bool MitsubaNode::boolean(const std::string& name, bool fallback) const {
  const MitsubaNode* node = find(name);
  if (node == nullptr) return fallback;
  const std::string& value = node->get("value");
  if (value == "true" || value == "false") return value == "true";
  fail_input(fmt::format("'{}' is '{}', neither true nor false", name, value), node->where);
}

std::string MitsubaNode::text(const std::string& name, const std::string& fallback) const {
  const MitsubaNode* node = find(name);
  return node == nullptr ? fallback : node->get("value");
}

MitsubaTree read_mitsuba_tree(const fs::path& path) {
  return TreeReader().read(path);
}

}  // namespace umbrameter
