// SPDX-License-Identifier: Apache-2.0
#pragma once
// Feeds an OBJ file to tinyobjloader line by line, checking each line and knowing its number.

#include "scenes/obj/byte_source.h"

#include <streambuf>
#include <string>
#include <vector>

namespace umbrameter {

/// The get area is always exactly one line with its end ("\n", "\r\n" or "\r"). Bad lines throw Error{input}
/// from underflow(); set exceptions(badbit) on the stream so that they pass through.
class ObjLines final : public std::streambuf {
 public:
  ObjLines(std::unique_ptr<ByteSource> source, std::string file);
  /// 1-based number of the line in the get area.
  int line() const { return line_; }
  const std::string& file() const { return file_; }

 protected:
  int_type underflow() override;

 private:
  /// Length of the line at next_ with its end; 0 at the end of the file.
  size_t find_line();
  bool read_more();

  std::unique_ptr<ByteSource> source_;
  std::string file_;
  std::vector<char> buffer_;
  size_t next_ = 0;  // unread bytes are buffer_[next_, end_)
  size_t end_ = 0;
  int line_ = 0;
};

}  // namespace umbrameter
