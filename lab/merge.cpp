// SPDX-License-Identifier: Apache-2.0
#include "lab/merge.h"

#include "core/error.h"
#include "results/json/record.h"

namespace umbrameter {
namespace {

/// A result is worth more than a failure, and one with times more than one without.
int worth(const std::string& json) {
  const auto run = parse_run_record(json);
  if (!run) return 1;  // no run
  if (run->result.failure) return 0;
  return run->result.pass_times.empty() ? 1 : 2;
}

void copy_entry(const Entry& entry, const Store& from, Store& into) {
  for (const std::string& object : object_names(entry.json)) {
    const std::string name = into.keep(from.path_of(object));
    UMBRAMETER_ASSERT(name == object, "the image '{}' became '{}'", object, name);
  }
  into.put(entry);
}

}  // namespace

MergeCounts merge_store(Store& from, Store& into) {
  MergeCounts counts;
  // Devices and pages are of one machine.
  for (const EntryKind kind : {EntryKind::scene, EntryKind::reference, EntryKind::parity, EntryKind::run,
                               EntryKind::verdict, EntryKind::answer, EntryKind::frame}) {
    for (const Entry& entry : from.entries(kind)) {
      const auto present = into.find(entry.key);
      if (present && (kind != EntryKind::run || worth(*present) >= worth(entry.json))) {
        ++counts.present;
        continue;
      }
      copy_entry(entry, from, into);
      ++counts.added;
    }
  }
  return counts;
}

}  // namespace umbrameter
