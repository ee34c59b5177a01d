// SPDX-License-Identifier: Apache-2.0
#include "scenes/obj/obj_lines.h"

#include "core/error.h"
#include "scenes/obj/obj_syntax.h"

#include <cstring>

namespace umbrameter {
namespace {

constexpr size_t kBlockBytes = size_t{1} << 20;
constexpr size_t kMaxLineBytes = size_t{1} << 16;

/// Length of the first line of `text` with its end; 0 when the end is not in it.
size_t line_length(std::string_view text) {
  const size_t newline = text.find('\n');
  const size_t carriage_return = text.substr(0, newline).find('\r');
  if (carriage_return != std::string_view::npos) {
    if (carriage_return + 1 == text.size()) return 0;  // a '\n' may follow
    return carriage_return + (carriage_return + 1 == newline ? 2 : 1);
  }
  return newline == std::string_view::npos ? 0 : newline + 1;
}

}  // namespace

ObjLines::ObjLines(std::unique_ptr<ByteSource> source, std::string file)
    : source_(std::move(source)), file_(std::move(file)), buffer_(kBlockBytes + kMaxLineBytes) {}

bool ObjLines::read_more() {
  std::memmove(buffer_.data(), buffer_.data() + next_, end_ - next_);
  end_ -= next_;
  next_ = 0;
  const size_t count = source_->read({buffer_.data() + end_, buffer_.size() - end_});
  end_ += count;
  return count > 0;
}

size_t ObjLines::find_line() {
  while (true) {
    const std::string_view unread(buffer_.data() + next_, end_ - next_);
    const size_t length = line_length(unread);
    const size_t known = length > 0 ? length : unread.size();
    if (known > kMaxLineBytes)
      fail_input(fmt::format("a line of over {} bytes", kMaxLineBytes), {file_, line_ + 1});
    if (length > 0) return length;
    if (!read_more()) return end_ - next_;
  }
}

ObjLines::int_type ObjLines::underflow() {
  const size_t length = find_line();
  if (length == 0) return traits_type::eof();
  char* begin = buffer_.data() + next_;
  next_ += length;
  ++line_;
  std::string_view text(begin, length);
  while (text.ends_with('\n') || text.ends_with('\r')) text.remove_suffix(1);
  check_obj_line(text, file_, line_);
  setg(begin, begin, begin + length);
  return traits_type::to_int_type(*begin);
}

}  // namespace umbrameter
