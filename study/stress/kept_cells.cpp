// SPDX-License-Identifier: Apache-2.0
#include "study/stress/kept_cells.h"

#include "core/hash.h"
#include "store/code_hashes.h"
#include "study/stress/run.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace umbrameter {
namespace {

using enum StressOutcome;

/// A technique is judged beside itself at the nominal value, so that is in the key, too.
std::string key_of(const StressAxis& axis, const StressKeys& keys, const std::string& row, size_t value) {
  Hasher hasher;
  hasher.text("stress").text(kStressCodeHash).text(axis.name);
  hasher.text(axis.values[value].text).text(axis.values[axis.nominal].text);
  const std::string truth = reference_key("", 0, keys.picture, keys.makers);
  const auto run = std::ranges::find(keys.techniques, row, &TechniqueRun::label);
  const std::string picture = run == keys.techniques.end()
                                  ? parity_key(truth, keys.makers)
                                  : run_key(truth, *run, keys.picture.seed, {}, keys.makers);
  return hasher.text(row).text(picture).number(keys.has_oracle ? 1.0 : 0.0).hex();
}

std::vector<std::string> rows_of(const StressKeys& keys) {
  std::vector<std::string> rows = {std::string(kTruthRow)};
  for (const TechniqueRun& run : keys.techniques) rows.push_back(run.label);
  return rows;
}

bool is_of_the_machine(const StressCell& cell) {
  return cell.outcome == crash || cell.outcome == hang || cell.outcome == environment;
}

}  // namespace

std::vector<StressCell> kept_cells(Answers& answers, const StressAxis& axis, const StressKeys& keys) {
  std::vector<StressCell> cells;
  for (size_t value = 0; value < axis.values.size(); ++value) {
    for (const std::string& row : rows_of(keys)) {
      const auto read = [&](const nlohmann::json& json) {
        StressCell cell = read_cell(json);
        cell.value = value;  // of a suite that may have other values
        cells.push_back(std::move(cell));
      };
      answers.find(key_of(axis, keys, row, value), read);
    }
  }
  return cells;
}

void sort_cells(std::vector<StressCell>& cells, const StressAxis& axis, const StressKeys& keys) {
  const std::vector<std::string> rows = rows_of(keys);
  const std::vector<size_t> values = walking_order(axis);
  std::ranges::sort(cells, {}, [&](const StressCell& cell) {
    return std::pair(std::ranges::find(values, cell.value), std::ranges::find(rows, cell.row));
  });
}

void keep_cell(Answers& answers, const StressAxis& axis, const StressKeys& keys, const StressCell& cell) {
  if (!is_of_the_machine(cell)) answers.keep(key_of(axis, keys, cell.row, cell.value), cell_json(cell));
}

}  // namespace umbrameter
