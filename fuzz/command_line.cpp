// SPDX-License-Identifier: Apache-2.0
// Command lines, words parted by line breaks: any of them is a verb to run or a message, and nothing is run.

#include "fuzz/fuzz_file.h"

#include "cli/command_line.h"

#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace umbrameter;
  std::vector<std::string> words = {"umbrameter", ""};
  for (size_t i = 0; i < size; ++i) {
    if (data[i] == '\n')
      words.emplace_back();
    else if (data[i] != 0)
      words.back() += static_cast<char>(data[i]);
  }
  std::vector<const char*> argv;
  for (const std::string& word : words) argv.push_back(word.c_str());
  fuzz::expect_answer_or_sentence([&] {
    CLI::App app;
    CommandLine line;
    parse_command_line(static_cast<int>(argv.size()), argv.data(), app, line);
  });
  return 0;
}
