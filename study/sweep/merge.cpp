#include "study/sweep/merge.h"

#include "core/error.h"
#include "study/sweep/record.h"

namespace umbrameter {
namespace {

bool is_failed(const std::string& json) {
  const auto run = parse_run_record(json);
  return run && run->result.failure;
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
  for (const EntryKind kind :
       {EntryKind::scene, EntryKind::reference, EntryKind::parity, EntryKind::run, EntryKind::verdict}) {
    for (const Entry& entry : from.entries(kind)) {
      const auto present = into.find(entry.key);
      if (present && (!is_failed(*present) || is_failed(entry.json))) {
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
