// SPDX-License-Identifier: Apache-2.0
#include "scenes/obj/obj_lines.h"

#include "core/error.h"

#include <algorithm>
#include <cstring>

namespace umbrameter {
namespace {

constexpr size_t kBlockBytes = size_t{1} << 20;
constexpr size_t kMaxStatementBytes = size_t{64} << 20;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// Length of the first line of `text` with its end; 0 when the end is not in it. The first `known` bytes have none.
size_t line_length(std::string_view text, size_t known) {
  const size_t newline = text.find('\n', known);
  const size_t carriage_return = text.substr(0, newline).find('\r', known);
  if (carriage_return != std::string_view::npos) {
    if (carriage_return + 1 == text.size()) return 0;  // a '\n' may follow
    return carriage_return + (carriage_return + 1 == newline ? 2 : 1);
  }
  return newline == std::string_view::npos ? 0 : newline + 1;
}

}  // namespace

ObjLines::ObjLines(std::unique_ptr<ByteSource> source, std::string file)
    : source_(std::move(source)), file_(std::move(file)), buffer_(2 * kBlockBytes) {}

bool ObjLines::read_more() {
  std::memmove(buffer_.data(), buffer_.data() + next_, end_ - next_);
  end_ -= next_;
  next_ = 0;
  if (buffer_.size() - end_ < kBlockBytes) buffer_.resize(2 * buffer_.size());
  const size_t count = source_->read({buffer_.data() + end_, kBlockBytes});
  end_ += count;
  return count > 0;
}

size_t ObjLines::find_line() {
  size_t known = 0;
  while (true) {
    const std::string_view unread(buffer_.data() + next_, end_ - next_);
    const size_t length = line_length(unread, known);
    if (length > 0) return length;
    if (unread.size() > kMaxStatementBytes)
      fail_input(fmt::format("a line of over {} MiB", kMaxStatementBytes >> 20), {file_, line_ + 1},
                 "this is not an OBJ text file");
    known = unread.empty() ? 0 : unread.size() - 1;  // it may end in '\r'
    if (!read_more()) return end_ - next_;
  }
}

void ObjLines::skip_byte_order_mark() {
  if (line_ == 0 && std::string_view(buffer_.data() + next_, end_ - next_).starts_with(kByteOrderMark))
    next_ += kByteOrderMark.size();
}

bool ObjLines::take_line() {
  size_t length = find_line();
  const size_t start = next_;
  skip_byte_order_mark();
  if (next_ != start) length = find_line();
  if (length == 0) return false;
  text_ = {buffer_.data() + next_, length};
  next_ += length;
  ++line_;
  while (text_.ends_with('\n') || text_.ends_with('\r')) text_.remove_suffix(1);
  has_line_end_ = text_.size() < length;
  return true;
}

/// The statement that starts in text_, with the lines it goes on in.
std::string_view ObjLines::join_lines() {
  pieces_.assign(1, {0, line_});
  if (!is_continued(text_)) return text_;
  joined_.clear();
  do {
    joined_.append(text_, 0, text_.rfind('\\'));
    joined_ += ' ';
    if (joined_.size() > kMaxStatementBytes)
      fail_input(fmt::format("a statement of over {} MiB", kMaxStatementBytes >> 20),
                 {file_, statement_line_});
    if (!take_line()) return joined_;
    pieces_.push_back({joined_.size(), line_});
  } while (is_continued(text_));
  joined_ += text_;
  return joined_;
}

ObjLines::int_type ObjLines::underflow() {
  if (!take_line()) return traits_type::eof();
  statement_line_ = line_;
  const std::string_view written = join_lines();
  const std::string_view statement = without_comment(written);
  const ObjText text{statement, file_, pieces_, !has_line_end_};
  const bool is_repaired = check_obj_statement(text, repairs_, repaired_);
  const bool is_one_line = pieces_.size() == 1 && statement.size() == written.size() && has_line_end_;
  if (!is_repaired && is_one_line) {
    char* begin = buffer_.data() + (statement.data() - buffer_.data());
    setg(begin, begin, buffer_.data() + next_);
  } else {
    if (!is_repaired) repaired_ = statement;
    repaired_ += '\n';
    setg(repaired_.data(), repaired_.data(), repaired_.data() + repaired_.size());
  }
  return traits_type::to_int_type(*gptr());
}

}  // namespace umbrameter
