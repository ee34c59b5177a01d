// SPDX-License-Identifier: Apache-2.0
#include "report/page_cache.h"

#include "core/files.h"
#include "core/hash.h"
#include "report/side_files.h"
#include "store/file_stamp.h"

#include <fmt/format.h>

namespace umbrameter {
namespace {

namespace fs = std::filesystem;

std::string key_of(const fs::path& out) {
  return Hasher().text("page").text(fs::absolute(out).string()).hex();
}

/// What the page is made of and what it was when it was made. Another program may make another page.
std::string state_of(const fs::path& out, const std::string& json) {
  Hasher others;
  for (const fs::path& file : side_files(out)) others.text(file.filename().string()).text(file_stamp(file));
  return fmt::format(R"({{"results": "{}", "others": "{}", "program": "{}", "page": "{}"}})", hash_text(json),
                     others.hex(), file_stamp("/proc/self/exe"), file_stamp(out / "report.html"));
}

}  // namespace

bool is_page_current(LazyStore& store, const fs::path& out, const std::string& json) {
  const auto known = store.find(key_of(out));
  if (!known || *known != state_of(out, json)) return false;
  const fs::path file = out / "results.json";
  return fs::is_regular_file(file) && read_file(file) == json;
}

void keep_page(LazyStore& store, const fs::path& out, const std::string& json) {
  store.store().put({key_of(out), EntryKind::page, state_of(out, json)});
}

}  // namespace umbrameter
