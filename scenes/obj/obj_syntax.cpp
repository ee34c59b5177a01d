// SPDX-License-Identifier: Apache-2.0
#include "scenes/obj/obj_syntax.h"

#include "core/error.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace umbrameter {
namespace {

constexpr std::array<std::string_view, 17> kIgnored = {
    "vp",     "p",      "l",      "g",     "s",        "mg",       "o",          "lod",      "usemtl",
    "mtllib", "usemap", "maplib", "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj"};

constexpr std::string_view kBlank = " \t";
constexpr std::array<std::string_view, 7> kNumeric = {"v", "vn", "vt", "vp", "f", "l", "p"};

/// Splits a statement at blanks and knows where it is, for messages.
struct StatementCursor {
  const ObjText& source;
  std::string_view text = source.text;
  size_t position = 0;
  size_t token_start = 0;

  std::string_view next() {
    token_start = std::min(text.find_first_not_of(kBlank, position), text.size());
    position = std::min(text.find_first_of(kBlank, token_start), text.size());
    return text.substr(token_start, position - token_start);
  }
  int line() const { return source.pieces.front().line; }
  [[noreturn]] void fail(const std::string& message, const std::string& hint = {}) const {
    const auto after =
        std::upper_bound(source.pieces.begin(), source.pieces.end(), token_start,
                         [](size_t offset, const ObjPiece& piece) { return offset < piece.offset; });
    const ObjPiece& piece = *std::prev(after);
    fail_input(message, {source.file, piece.line, static_cast<int>(token_start - piece.offset) + 1}, hint);
  }
};

template <size_t count>
bool contains(const std::array<std::string_view, count>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

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

/// i/, i// or i/j/ without the slashes at the end, as modellers of subdivision surfaces write them; else unchanged.
std::string_view without_slashes(std::string_view corner) {
  const auto slashes = std::count(corner.begin(), corner.end(), '/');
  if (slashes > 2 || !corner.ends_with('/')) return corner;
  return corner.substr(0, corner.find_last_not_of('/') + 1);
}

/// "nan" and "inf" as C libraries print them: also "-nan(ind)", "1.#QNAN", "-1.#IND00".
bool is_not_finite(std::string_view text) {
  text.remove_prefix(skip_sign(text, 0));
  if (text.starts_with("1.#")) return true;
  constexpr std::array<std::string_view, 7> kNames = {"nan", "NaN", "NAN", "inf", "Inf", "INF", "infinity"};
  return contains(kNames, text.substr(0, text.find('(')));
}

void check_position(StatementCursor& cursor) {
  size_t count = 0;
  for (std::string_view token = cursor.next(); !token.empty(); token = cursor.next(), ++count) {
    if (!is_number(token)) cursor.fail(fmt::format("'{}' is not a finite number", token));
  }
  if (count < 3) cursor.fail(fmt::format("'v' needs three numbers, not {}", count), "is the file cut off?");
}

/// False when the normal is not finite.
bool check_normal(StatementCursor& cursor) {
  size_t count = 0;
  bool is_finite = true;
  for (std::string_view token = cursor.next(); !token.empty(); token = cursor.next(), ++count) {
    if (is_number(token)) continue;
    if (!is_not_finite(token)) cursor.fail(fmt::format("'{}' is not a number", token));
    is_finite = false;
  }
  if (count < 3) cursor.fail(fmt::format("'vn' needs three numbers, not {}", count), "is the file cut off?");
  return is_finite;
}

struct FaceCount {
  size_t corners = 0;
  size_t slashes = 0;  // corners with slashes at their ends
};

FaceCount check_corners(StatementCursor& cursor) {
  FaceCount count;
  for (std::string_view token = cursor.next(); !token.empty(); token = cursor.next(), ++count.corners) {
    const std::string_view corner = without_slashes(token);
    if (!is_corner(corner)) {
      cursor.fail(fmt::format("'{}' is not a corner of a face", token),
                  "i, i/j, i//k or i/j/k, counted from 1");
    }
    count.slashes += corner.size() < token.size() ? 1 : 0;
  }
  if (count.corners < 3 && cursor.source.is_last)
    cursor.fail(fmt::format("a face needs three corners, not {}", count.corners), "is the file cut off?");
  return count;
}

std::string face_without_slashes(std::string_view text, const ObjText& source) {
  StatementCursor cursor{source, text};
  std::string face(cursor.next());
  for (std::string_view token = cursor.next(); !token.empty(); token = cursor.next()) {
    face += ' ';
    face += without_slashes(token);
  }
  return face;
}

bool repair_face(StatementCursor& cursor, ObjRepairs& repairs, std::string& repaired) {
  const FaceCount count = check_corners(cursor);
  if (count.corners < 3) {
    repairs.add(ObjRepair::small_face, cursor.line());
    repaired.clear();
    return true;
  }
  if (count.slashes == 0) return false;
  repairs.add(ObjRepair::trailing_slash, cursor.line(), count.slashes);
  repaired = face_without_slashes(cursor.text, cursor.source);
  return true;
}

bool repair_normal(StatementCursor& cursor, ObjRepairs& repairs, std::string& repaired) {
  if (check_normal(cursor)) return false;
  repairs.add(ObjRepair::normal_not_finite, cursor.line());
  repaired = "vn 0 0 0";  // keeps the count; no face can use it
  return true;
}

/// One to three numbers; only cut-outs ask for them.
bool repair_texture_point(StatementCursor& cursor, ObjRepairs& repairs, std::string& repaired) {
  size_t count = 0;
  bool is_fine = true;
  for (std::string_view token = cursor.next(); !token.empty(); token = cursor.next(), ++count)
    is_fine &= is_number(token);
  if (is_fine && count > 0) return false;
  repairs.add(ObjRepair::texture_not_finite, cursor.line());
  repaired = "vt 0 0";
  return true;
}

std::string_view keyword_of(std::string_view statement) {
  const size_t start = std::min(statement.find_first_not_of(kBlank), statement.size());
  return statement.substr(start, statement.find_first_of(kBlank, start) - start);
}

/// "1.#IND" is how one C library prints what is not a number.
size_t comment_after_numbers(std::string_view statement) {
  size_t at = statement.find('#');
  while (at != std::string_view::npos && at > 0 && statement[at - 1] == '.') at = statement.find('#', at + 1);
  return at;
}

/// Where the comment of a statement that holds names starts: at a "#" between blanks.
size_t comment_after_names(std::string_view statement) {
  for (size_t at = statement.find('#'); at != std::string_view::npos; at = statement.find('#', at + 1)) {
    const bool starts_word = at == 0 || kBlank.find(statement[at - 1]) != std::string_view::npos;
    const bool ends_word =
        at + 1 == statement.size() || kBlank.find(statement[at + 1]) != std::string_view::npos;
    if (starts_word && ends_word) return at;
  }
  return std::string_view::npos;
}

}  // namespace

std::string_view without_comment(std::string_view statement) {
  if (statement.find('#') == std::string_view::npos) return statement;
  const std::string_view keyword = keyword_of(statement);
  if (keyword.starts_with('#')) return {};
  const std::string_view number_keyword = keyword.substr(0, keyword.find('#'));
  if (contains(kNumeric, number_keyword)) return statement.substr(0, comment_after_numbers(statement));
  return statement.substr(0, comment_after_names(statement));
}

bool is_continued(std::string_view line) {
  const size_t last = line.find_last_not_of(kBlank);
  if (last == std::string_view::npos || line[last] != '\\') return false;
  return without_comment(line).size() > last;
}

bool check_obj_statement(const ObjText& text, ObjRepairs& repairs, std::string& repaired) {
  StatementCursor cursor{text};
  if (text.text.find('\0') != std::string_view::npos)
    cursor.fail("a zero byte: this is not an OBJ text file", "UTF-16 and binary files are not read");
  const std::string_view keyword = cursor.next();
  if (keyword.empty()) return false;
  if (keyword == "f") return repair_face(cursor, repairs, repaired);
  if (keyword == "vn") return repair_normal(cursor, repairs, repaired);
  if (keyword == "vt") return repair_texture_point(cursor, repairs, repaired);
  if (keyword == "v") check_position(cursor);
  if (keyword == "v" || contains(kIgnored, keyword)) return false;
  cursor.fail(fmt::format("unknown OBJ statement '{}'", keyword.substr(0, 40)),
              "only polygons are read: v, vn, f, usemtl, g, o");
}

}  // namespace umbrameter
