// SPDX-License-Identifier: Apache-2.0
#pragma once
// The file through which a worker tells what it does, so that a crash or a hang is an outcome and not the end: a line when
// a task starts, a line with its cell when it is done.

#include "results/stress/outcome.h"

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace umbrameter {

/// A cell that was started.
struct StressTask {
  std::string row;
  size_t value = 0;
};

struct JournalState {
  std::vector<StressCell> cells;
  std::optional<StressTask> open;  // started and not done

  const StressCell* find(const std::string& row, size_t value) const;
};

/// An empty state when there is no file. A line that was cut off is left out.
JournalState read_journal(const std::filesystem::path& file);

/// Reads a journal while it grows.
class JournalTail {
 public:
  explicit JournalTail(std::filesystem::path file) : file_(std::move(file)) {}
  /// The cells of lines that have come since it was last asked.
  std::vector<StressCell> take();

 private:
  std::filesystem::path file_;
  std::streamoff read_ = 0;  // bytes of whole lines
};

/// Appends; every line reaches the file before the call returns.
class JournalWriter {
 public:
  explicit JournalWriter(const std::filesystem::path& file);
  void start(const StressTask& task);
  void finish(const StressCell& cell);

 private:
  void write(const nlohmann::ordered_json& line);
  std::filesystem::path path_;
  std::ofstream file_;
};

}  // namespace umbrameter
