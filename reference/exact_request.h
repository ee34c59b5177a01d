// SPDX-License-Identifier: Apache-2.0
#pragma once
// The file in which the program `umbrameter-exact` is asked: numbers of fixed size in this machine's byte order, so that
// every double arrives as it left. Lengths stand before what they count; the first eight bytes say format and version.

#include "reference/exact_answer.h"

#include <filesystem>

namespace umbrameter {

struct ExactRequest {
  Scene scene;  // triangles, their corners and one light; nothing else is sent
  std::vector<ExactReceiver> receivers;
  int threads = 0;
};

/// Error{environment} when the file cannot be written.
void write_exact_request(const std::filesystem::path& file, const Scene& scene,
                         std::span<const ExactReceiver> receivers, int threads);

/// Error{input} names what is wrong with a file that is cut short, of another version, or whose indices lead nowhere.
ExactRequest read_exact_request(const std::filesystem::path& file);

/// One line of the program's answer, and back; doubles as hexadecimal floats. Error{input} for other lines.
std::string to_line(size_t receiver, const ExactLight& answer);
std::pair<size_t, ExactLight> from_line(const std::string& line);

}  // namespace umbrameter
