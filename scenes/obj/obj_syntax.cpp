// SPDX-License-Identifier: Apache-2.0
#include "scenes/obj/obj_syntax.h"

#include "core/error.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace umbrameter {
namespace {

constexpr size_t kMaxCorners = 1024;

constexpr std::array<std::string_view, 18> kIgnored = {
    "vt",     "vp",     "p",      "l",      "g",     "s",        "mg",       "o",          "lod",
    "usemtl", "mtllib", "usemap", "maplib", "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj"};

/// Splits a line at blanks and knows where it is, for messages.
struct LineCursor {
  std::string_view text;
  const std::string& file;
  int line;
  size_t position = 0;
  size_t token_start = 0;

  std::string_view next() {
    token_start = std::min(text.find_first_not_of(" \t", position), text.size());
    position = std::min(text.find_first_of(" \t", token_start), text.size());
    return text.substr(token_start, position - token_start);
  }
  [[noreturn]] void fail(const std::string& message, const std::string& hint = {}) const {
    fail_input(message, {file, line, static_cast<int>(token_start) + 1}, hint);
  }
};

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

size_t skip_digits(std::string_view text, size_t at) {
  while (at < text.size() && is_digit(text[at])) ++at;
  return at;
}

size_t skip_sign(std::string_view text, size_t at) {
  return at < text.size() && (text[at] == '+' || text[at] == '-') ? at + 1 : at;
}

/// Decimal number; "nan", "inf" and hexadecimal are not numbers here.
bool is_number(std::string_view text) {
  const size_t start = skip_sign(text, 0);
  size_t at = skip_digits(text, start);
  size_t digits = at - start;
  if (at < text.size() && text[at] == '.') {
    const size_t end = skip_digits(text, at + 1);
    digits += end - at - 1;
    at = end;
  }
  if (digits == 0) return false;
  if (at == text.size()) return true;
  if (text[at] != 'e' && text[at] != 'E') return false;
  const size_t exponent = skip_sign(text, at + 1);
  const size_t end = skip_digits(text, exponent);
  return end > exponent && end - exponent <= 4 && end == text.size();
}

/// Reads one index off the front of `text`.
bool take_index(std::string_view& text) {
  int index = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (error != std::errc{} || index == 0) return false;
  text.remove_prefix(static_cast<size_t>(end - text.data()));
  return true;
}

/// i, i/j, i//k or i/j/k.
bool is_corner(std::string_view text) {
  if (!take_index(text)) return false;
  if (text.empty()) return true;
  if (!text.starts_with('/')) return false;
  text.remove_prefix(1);
  if (!text.starts_with('/')) {
    if (!take_index(text)) return false;
    if (text.empty()) return true;
    if (!text.starts_with('/')) return false;
  }
  text.remove_prefix(1);
  return take_index(text) && text.empty();
}

void check_numbers(LineCursor& cursor, std::string_view keyword) {
  size_t count = 0;
  for (std::string_view token = cursor.next(); !token.empty(); token = cursor.next(), ++count) {
    if (!is_number(token)) cursor.fail(fmt::format("'{}' is not a finite number", token));
  }
  if (count < 3)
    cursor.fail(fmt::format("'{}' needs three numbers, not {}", keyword, count), "is the file cut off?");
}

void check_corners(LineCursor& cursor) {
  size_t count = 0;
  for (std::string_view token = cursor.next(); !token.empty(); token = cursor.next(), ++count) {
    if (!is_corner(token)) {
      cursor.fail(fmt::format("'{}' is not a corner of a face", token),
                  "i, i/j, i//k or i/j/k, counted from 1");
    }
  }
  if (count < 3)
    cursor.fail(fmt::format("a face needs three corners, not {}", count), "is the file cut off?");
  if (count > kMaxCorners) cursor.fail(fmt::format("a face of {} corners (at most {})", count, kMaxCorners));
}

}  // namespace

void check_obj_line(std::string_view text, const std::string& file, int line) {
  LineCursor cursor{text, file, line};
  if (text.find('\0') != std::string_view::npos) cursor.fail("a zero byte: this is not an OBJ text file");
  const std::string_view keyword = cursor.next();
  if (keyword.empty() || keyword.starts_with('#')) return;
  if (keyword == "v" || keyword == "vn") return check_numbers(cursor, keyword);
  if (keyword == "f") return check_corners(cursor);
  if (std::find(kIgnored.begin(), kIgnored.end(), keyword) != kIgnored.end()) return;
  cursor.fail(fmt::format("unknown OBJ statement '{}'", keyword.substr(0, 40)),
              "only polygons are read: v, vn, f, usemtl, g, o");
}

}  // namespace umbrameter
