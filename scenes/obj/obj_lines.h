// SPDX-License-Identifier: Apache-2.0
#pragma once
// Feeds an OBJ file to tinyobjloader statement by statement: checked, repaired, and each knowing its line.

#include "scenes/obj/byte_source.h"
#include "scenes/obj/obj_repairs.h"
#include "scenes/obj/obj_syntax.h"

#include <streambuf>
#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {

/// The get area is always exactly one statement with its line end. Lines that end in "\" are joined with the next, a byte
/// order mark and comments are cut off, and obj_syntax.h repairs the rest. Lines end in "\n", "\r\n" or "\r". Bad
/// statements throw Error{input} from underflow(); set exceptions(badbit) on the stream so that they pass through.
class ObjLines final : public std::streambuf {
 public:
  ObjLines(std::unique_ptr<ByteSource> source, std::string file);
  /// 1-based number of the line where the statement in the get area starts.
  int line() const { return statement_line_; }
  const std::string& file() const { return file_; }
  ObjRepairs& repairs() { return repairs_; }

 protected:
  int_type underflow() override;

 private:
  /// Length of the line at next_ with its end; 0 at the end of the file.
  size_t find_line();
  bool read_more();
  bool take_line();
  void skip_byte_order_mark();
  std::string_view join_lines();

  std::unique_ptr<ByteSource> source_;
  std::string file_;
  ObjRepairs repairs_;
  std::vector<char> buffer_;
  size_t next_ = 0;  // unread bytes are buffer_[next_, end_)
  size_t end_ = 0;
  int line_ = 0;
  int statement_line_ = 0;
  std::string_view text_;         // of the last line, without its end
  bool has_line_end_ = false;     // of the last line; false at the end of a file that is cut off
  std::string joined_;            // a statement over several lines
  std::vector<ObjPiece> pieces_;  // where the parts of a statement come from
  std::string repaired_;
};

}  // namespace umbrameter
