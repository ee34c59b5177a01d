// SPDX-License-Identifier: Apache-2.0
#include "results/stress/journal.h"

#include "core/error.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace umbrameter {

using OrderedJson = nlohmann::ordered_json;

const StressCell* JournalState::find(const std::string& row, size_t value) const {
  const auto found = std::ranges::find_if(
      cells, [&](const StressCell& cell) { return cell.row == row && cell.value == value; });
  return found == cells.end() ? nullptr : &*found;
}

JournalState read_journal(const std::filesystem::path& file) {
  JournalState state;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    const OrderedJson json = OrderedJson::parse(line, nullptr, false);
    if (json.is_discarded()) continue;
    if (json.contains("start")) {
      state.open = StressTask{json.at("start"), json.at("value")};
      continue;
    }
    state.cells.push_back(read_cell(json));
    state.open.reset();
  }
  return state;
}

std::vector<StressCell> JournalTail::take() {
  std::vector<StressCell> cells;
  std::ifstream in(file_);
  in.seekg(read_);
  for (std::string line; std::getline(in, line) && !in.eof();) {
    read_ = in.tellg();
    const OrderedJson json = OrderedJson::parse(line, nullptr, false);
    if (!json.is_discarded() && !json.contains("start")) cells.push_back(read_cell(json));
  }
  return cells;
}

JournalWriter::JournalWriter(const std::filesystem::path& file) : path_(file), file_(file, std::ios::app) {
  if (!file_) fail_input("cannot be written", {file.string()});
  file_ << '\n';  // ends a line that was cut off
}

void JournalWriter::start(const StressTask& task) {
  write({{"start", task.row}, {"value", task.value}});
}

void JournalWriter::finish(const StressCell& cell) {
  write(cell_json(cell));
}

void JournalWriter::write(const OrderedJson& line) {
  file_ << line.dump(-1, ' ', false, OrderedJson::error_handler_t::replace) << std::endl;
  if (!file_) fail_environment(fmt::format("'{}' cannot be written", path_.string()), "is the disk full?");
}

}  // namespace umbrameter
