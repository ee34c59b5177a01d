// SPDX-License-Identifier: Apache-2.0
#include "scenes/pbrt/pbrt_tokens.h"

#include "core/files.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace umbrameter {
namespace {

constexpr size_t kMaxPbrtFiles = 1000;
constexpr std::string_view kPbrtBlank = " \t\r\n";
constexpr std::string_view kEndsWord = " \t\r\n\"[]#";

}  // namespace

void PbrtTokens::open(const std::filesystem::path& path, const FileLocation& from) {
  std::error_code ignored;
  const std::filesystem::path whole = std::filesystem::weakly_canonical(path, ignored);
  if (std::ranges::find(open_, whole, &Source::whole) != open_.end())
    fail_input(fmt::format("file '{}' includes itself", path.string()), from);
  if (!from.file.empty() && !std::filesystem::is_regular_file(path, ignored))
    fail_input(fmt::format("the included file '{}' is not there", path.string()), from);
  if (files_.size() > kMaxPbrtFiles) fail_input("more than 1,000 files are included", from);
  files_.push_back(path);
  open_.push_back({path, whole, read_file(path)});
}

std::optional<PbrtToken> PbrtTokens::next() {
  if (peeked_) return std::exchange(peeked_, std::nullopt);
  while (!open_.empty()) {
    if (auto token = read(open_.back())) return token;
    open_.pop_back();
  }
  return std::nullopt;
}

const PbrtToken* PbrtTokens::peek() {
  if (!peeked_) peeked_ = next();
  return peeked_ ? &*peeked_ : nullptr;
}

std::optional<PbrtToken> PbrtTokens::read(Source& source) const {
  const std::string& bytes = source.bytes;
  size_t& at = source.at;
  while (at < bytes.size()) {
    if (bytes[at] == '#') {
      at = std::min(bytes.find('\n', at), bytes.size());
    } else if (kPbrtBlank.find(bytes[at]) != std::string_view::npos) {
      source.line += bytes[at] == '\n' ? 1 : 0;
      ++at;
    } else {
      break;
    }
  }
  if (at == bytes.size()) return std::nullopt;
  PbrtToken token{{}, bytes[at] == '"', {source.path.string(), source.line}};
  if (token.is_string) {
    const size_t end = bytes.find_first_of("\"\n", at + 1);
    if (end == std::string::npos || bytes[end] == '\n') fail_input("a string has no end", token.where);
    token.text = bytes.substr(at + 1, end - at - 1);
    at = end + 1;
    return token;
  }
  const bool is_bracket = bytes[at] == '[' || bytes[at] == ']';
  const size_t end = is_bracket ? at + 1 : std::min(bytes.find_first_of(kEndsWord, at), bytes.size());
  token.text = bytes.substr(at, end - at);
  at = end;
  return token;
}

}  // namespace umbrameter
