// SPDX-License-Identifier: Apache-2.0
#include "lab/stored_runs.h"

#include "results/metadata.h"

#include <fmt/format.h>
#include <algorithm>
#include <map>
#include <tuple>

namespace umbrameter {

namespace {

/// What a person would call the same run.
std::string identity_of(const RunRecord& record) {
  const RecordHead& head = record.head;
  return fmt::format("{}\n{}\n{}\n{}\n{}\n{}x{}\n{}\n{}\n{}", head.scene, head.camera, head.light,
                     record.result.technique, to_text(record.result.parameters), head.picture.width_px,
                     head.picture.height_px, head.picture.samples_per_pixel,
                     head.picture.target_se.value_or(0.0), head.picture.seed);
}

auto order_of(const RunRecord& record) {
  const RecordHead& head = record.head;
  return std::tie(head.scene, head.camera, record.result.label, head.picture.seed, head.picture.width_px,
                  head.picture.height_px, head.picture.samples_per_pixel, head.started);
}

/// Of the same run, a sweep's entry is worth more than a validation's: it has a baseline.
bool is_newer(const RunRecord& run, const RunRecord& other) {
  const auto order = [](const RunRecord& record) {
    return std::pair(record.head.started, record.result.picture_file.empty());
  };
  return order(run) > order(other);
}

std::vector<RunRecord> newest(std::vector<RunRecord> runs) {
  std::map<std::string, RunRecord> by_identity;
  for (RunRecord& run : runs) {
    const std::string identity = identity_of(run);
    const auto kept = by_identity.find(identity);
    if (kept == by_identity.end())
      by_identity.emplace(identity, std::move(run));
    else if (is_newer(run, kept->second))
      kept->second = std::move(run);
  }
  std::vector<RunRecord> all;
  for (auto& [identity, run] : by_identity) all.push_back(std::move(run));
  return all;
}

}  // namespace

void keep_record(Store& store, const std::string& key, const RunRecord& record) {
  store.put({key, EntryKind::run, to_json_text(record)});
}

std::optional<RunRecord> find_record(Store& store, const std::string& key) {
  const auto json = store.find(key);
  return json ? parse_run_record(*json) : std::nullopt;
}

StoredRuns stored_runs(Store& store, bool all) {
  StoredRuns found;
  for (const Entry& entry : store.entries(EntryKind::run)) {
    if (auto run = parse_run_record(entry.json)) {
      run->key = entry.key;
      found.runs.push_back(std::move(*run));
    } else {
      ++found.foreign;
    }
  }
  const size_t stored = found.runs.size();
  if (!all) found.runs = newest(std::move(found.runs));
  found.older = stored - found.runs.size();
  std::ranges::sort(found.runs,
                    [](const RunRecord& a, const RunRecord& b) { return order_of(a) < order_of(b); });
  return found;
}

}  // namespace umbrameter
