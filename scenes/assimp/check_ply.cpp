// SPDX-License-Identifier: Apache-2.0
#include "scenes/assimp/check_ply.h"

#include "core/error.h"
#include "core/files.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {
namespace {

struct PlyProperty {
  size_t item_bytes = 0;
  size_t count_bytes = 0;  // of a list's length; 0: a single value
};

struct PlyElement {
  std::string name;
  uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

class PlyCheck {
 public:
  PlyCheck(const std::filesystem::path& path, std::string_view bytes) : path_(path), bytes_(bytes) {}

  void run() {
    if (next_line() != "ply") fail("this is no PLY file: it does not begin with 'ply'");
    read_header();
    for (const PlyElement& element : elements_) {
      for (uint64_t row = 0; row < element.count; ++row) {
        if (format_ == "ascii")
          check_line(element);
        else
          check_row(element);
      }
    }
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { fail_input(message, {path_.string(), line_}); }
  [[noreturn]] void fail_short(const PlyElement& element) const {
    fail_input(
        fmt::format("the file is cut off: its header promises {} of '{}'", element.count, element.name),
        {path_.string()});
  }

  std::string_view next_line() {
    ++line_;
    const size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
    std::string_view line = bytes_.substr(at_, end - at_);
    at_ = std::min(end + 1, bytes_.size());
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
  }

  void read_header() {
    for (;;) {
      if (at_ >= bytes_.size()) fail("the header has no end");
      std::istringstream words{std::string(next_line())};
      std::string word;
      words >> word;
      if (word == "end_header") break;
      if (word == "format") words >> format_;
      if (word == "element") add_element(words);
      if (word == "property") add_property(words);
    }
    if (format_ != "ascii" && format_ != "binary_little_endian" && format_ != "binary_big_endian")
      fail(fmt::format("format '{}' of PLY is not known", format_));
  }

  void add_element(std::istringstream& words) {
    PlyElement element;
    if (!(words >> element.name >> element.count)) fail("an element has no count");
    elements_.push_back(std::move(element));
  }

  void add_property(std::istringstream& words) {
    if (elements_.empty()) fail("a property stands before the first element");
    std::string type, count_type;
    words >> type;
    PlyProperty property;
    if (type == "list") {
      words >> count_type >> type;
      property.count_bytes = bytes_of(count_type);
    }
    property.item_bytes = bytes_of(type);
    elements_.back().properties.push_back(property);
  }

  size_t bytes_of(const std::string& type) const {
    for (const char* name : {"char", "uchar", "int8", "uint8"})
      if (type == name) return 1;
    for (const char* name : {"short", "ushort", "int16", "uint16"})
      if (type == name) return 2;
    for (const char* name : {"int", "uint", "int32", "uint32", "float", "float32"})
      if (type == name) return 4;
    if (type == "double" || type == "float64") return 8;
    fail(fmt::format("a property has type '{}', which is not known", type));
  }

  uint64_t list_length(size_t bytes) const {
    uint64_t length = 0;
    for (size_t i = 0; i < bytes; ++i) {
      const bool is_big = format_ == "binary_big_endian";
      const auto byte = static_cast<unsigned char>(bytes_[at_ + (is_big ? i : bytes - 1 - i)]);
      length = length << 8 | byte;
    }
    return length;
  }

  void check_row(const PlyElement& element) {
    for (const PlyProperty& property : element.properties) {
      const size_t left = bytes_.size() - at_;
      if (left < std::max(property.count_bytes, size_t{1})) fail_short(element);
      const uint64_t items = property.count_bytes > 0 ? list_length(property.count_bytes) : 1;
      if ((left - property.count_bytes) / property.item_bytes < items) fail_short(element);
      at_ += property.count_bytes + static_cast<size_t>(items) * property.item_bytes;
    }
  }

  /// A line has at least a digit and a space for each value; of a list that begins it the length is known.
  void check_line(const PlyElement& element) {
    if (at_ >= bytes_.size()) fail_short(element);
    std::string_view line = next_line();
    while (line.find_first_not_of(" \t") == std::string_view::npos && at_ < bytes_.size()) line = next_line();
    if (element.properties.empty()) return;
    uint64_t values = element.properties.size();
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    if (element.properties.front().count_bytes > 0) {
      uint64_t length = 0;
      const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), length);
      if (error != std::errc{} || length > line.size())
        fail(fmt::format("a list of '{}' is longer than its line", element.name));
      values += length;
    }
    if (line.size() + 1 < 2 * values) fail(fmt::format("a line of '{}' has too few values", element.name));
  }

  const std::filesystem::path& path_;
  std::string_view bytes_;
  size_t at_ = 0;
  int line_ = 0;
  std::string format_;
  std::vector<PlyElement> elements_;
};

}  // namespace

void check_ply(const std::filesystem::path& path) {
  const std::string bytes = read_file(path);
  PlyCheck(path, bytes).run();
}

}  // namespace umbrameter
