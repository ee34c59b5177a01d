// SPDX-License-Identifier: Apache-2.0
#include "realtime/harness/shader_source.h"

#include "core/files.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

namespace umbrameter {

namespace {

namespace fs = std::filesystem;

constexpr size_t kMaxIncludeDepth = 16;

/// The word after '#', and what follows it; nothing for lines that are no directive.
struct Directive {
  std::string_view name;
  std::string_view rest;
};

std::string_view trim(std::string_view text) {
  const size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::optional<Directive> parse_directive(std::string_view line) {
  const std::string_view text = trim(line);
  if (text.empty() || text.front() != '#') return std::nullopt;
  const std::string_view body = trim(text.substr(1));
  const size_t end = std::min(body.find_first_of(" \t\"<"), body.size());
  return Directive{body.substr(0, end), trim(body.substr(end))};
}

/// Whether a /* comment is still open after `line`.
bool comment_stays_open(std::string_view line, bool is_open) {
  for (size_t i = 0; i + 1 < line.size(); ++i) {
    const std::string_view two = line.substr(i, 2);
    if (!is_open && two == "//") return false;
    if (two != (is_open ? "*/" : "/*")) continue;
    is_open = !is_open;
    ++i;
  }
  return is_open;
}

class Resolver {
 public:
  explicit Resolver(std::span<const fs::path> search_folders) : search_folders_(search_folders) {}

  void add_prelude(std::string_view prelude, const fs::path& file) {
    source_.files.push_back("prelude of " + file.string());
    source_.text = "#version 450 core\n#line 1 0\n";
    add_lines(prelude, 0, fs::path());
  }

  void add_file(const fs::path& file, const FileLocation& included_at) {
    const fs::path identity = fs::weakly_canonical(file);
    if (std::find(chain_.begin(), chain_.end(), identity) != chain_.end()) {
      fail_input("#include goes in a circle: " + describe_chain(file), included_at);
    }
    if (chain_.size() >= kMaxIncludeDepth) {
      fail_input(
          fmt::format("#include goes deeper than {} files: {}", kMaxIncludeDepth, describe_chain(file)),
          included_at);
    }
    std::vector<fs::path>& seen = source_.dependencies;
    const auto is_same = [&](const fs::path& other) { return fs::weakly_canonical(other) == identity; };
    if (std::any_of(seen.begin(), seen.end(), is_same)) return;
    const std::string text = read_file(file);
    seen.push_back(file);
    const size_t number = source_.files.size();
    source_.files.push_back(file.string());
    chain_.push_back(identity);
    mark_line(1, number);
    add_lines(text, number, file.parent_path());
    chain_.pop_back();
  }

  ShaderSource take() { return std::move(source_); }

 private:
  void mark_line(int line, size_t number) { source_.text += fmt::format("#line {} {}\n", line, number); }

  std::string describe_chain(const fs::path& last) const {
    std::string chain;
    for (const fs::path& file : chain_) chain += file.filename().string() + " > ";
    return chain + last.filename().string();
  }

  void add_lines(std::string_view text, size_t number, const fs::path& folder) {
    int line_number = 0;
    bool is_in_comment = false;
    while (!text.empty()) {
      const size_t end = std::min(text.find('\n'), text.size());
      add_line(text.substr(0, end), {source_.files[number], ++line_number, 0}, number, folder, is_in_comment);
      is_in_comment = comment_stays_open(text.substr(0, end), is_in_comment);
      text.remove_prefix(std::min(end + 1, text.size()));
    }
  }

  void add_line(std::string_view line, const FileLocation& where, size_t number, const fs::path& folder,
                bool is_in_comment) {
    const std::optional<Directive> directive = is_in_comment ? std::nullopt : parse_directive(line);
    if (directive && directive->name == "version") {
      fail_input("#version is not allowed in a shader file", where, "it is added: #version 450 core");
    }
    const bool is_for_cpp =
        directive && ((directive->name == "include" && directive->rest.starts_with('<')) ||
                      (directive->name == "pragma" && directive->rest == "once"));
    if (directive && directive->name == "include" && !is_for_cpp) {
      add_file(find_include(directive->rest, where, folder), where);
      mark_line(where.line + 1, number);
      return;
    }
    if (!is_for_cpp) source_.text += line.substr(0, line.find('\r'));
    source_.text += '\n';
  }

  fs::path find_include(std::string_view quoted, const FileLocation& where, const fs::path& folder) const {
    const size_t close = quoted.size() < 3 ? std::string_view::npos : quoted.find('"', 1);
    if (close == std::string_view::npos || quoted.front() != '"') {
      fail_input(fmt::format("#include {} is not understood", quoted), where, "write #include \"file.glsl\"");
    }
    const fs::path name(std::string(quoted.substr(1, close - 1)));
    std::vector<std::string> tried;
    if (!folder.empty()) tried.push_back(folder.string());
    for (const fs::path& search : search_folders_) tried.push_back(search.string());
    for (const std::string& candidate : tried) {
      const fs::path file = (fs::path(candidate) / name).lexically_normal();
      if (fs::is_regular_file(file)) return file;
    }
    fail_input(fmt::format("#include \"{}\" is not found", name.string()), where,
               fmt::format("looked in {}", fmt::join(tried, ", ")));
  }

  std::span<const fs::path> search_folders_;
  ShaderSource source_;
  std::vector<fs::path> chain_;  // files being read, outermost first
};

}  // namespace

ShaderSource load_shader_source(const fs::path& file, std::string_view prelude,
                                std::span<const fs::path> search_folders) {
  Resolver resolver(search_folders);
  resolver.add_prelude(prelude, file);
  resolver.add_file(file, {});
  return resolver.take();
}

}  // namespace umbrameter
