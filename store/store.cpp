// SPDX-License-Identifier: Apache-2.0
#include "store/store.h"

#include "core/error.h"
#include "core/files.h"
#include "core/hash.h"
#include "store/objects.h"
#include "store/schema.h"

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <utility>

namespace umbrameter {

namespace fs = std::filesystem;

namespace {

constexpr std::array<std::string_view, 9> kEntryKinds{"run",    "reference", "parity", "verdict", "scene",
                                                      "device", "page",      "answer", "frame"};

/// Checked and repaired before anything is opened.
fs::path prepared(const fs::path& folder, Database::Mode mode, std::vector<std::string>& warnings) {
  if (mode == Database::Mode::write) create_folder(folder);
  if (mode == Database::Mode::read && !has_store(folder))
    fail_input(fmt::format("'{}' has no {}", folder.string(), kStoreFile), {},
               "give the --out folder of a sweep or validation");
  if (mode == Database::Mode::write) repair_if_damaged(folder, warnings);
  return folder / kStoreFile;
}

/// Size and time of change; both 0 for a missing file.
std::pair<std::string, std::string> stamp_of(const fs::path& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) != 0) return {"0", "0"};
  constexpr int64_t kNsPerSecond = 1000000000;
  return {std::to_string(status.st_size),
          std::to_string(int64_t{status.st_mtim.tv_sec} * kNsPerSecond + status.st_mtim.tv_nsec)};
}

}  // namespace

std::string_view to_text(EntryKind kind) {
  return kEntryKinds[static_cast<size_t>(kind)];
}

std::optional<EntryKind> read_kind(std::string_view text) {
  const auto found = std::ranges::find(kEntryKinds, text);
  if (found == kEntryKinds.end()) return std::nullopt;
  return static_cast<EntryKind>(found - kEntryKinds.begin());
}

bool has_store(const fs::path& folder) {
  return fs::is_regular_file(folder / kStoreFile);
}

std::vector<std::string> object_names(std::string_view json) {
  // Names hold nothing that JSON escapes, so that a text need not be parsed to find them: a quote before, one after.
  const std::string begin = fmt::format("\"{}/", kObjectsFolder);
  std::vector<std::string> names;
  for (size_t from = json.find(begin); from != json.npos; from = json.find(begin, from + 1)) {
    const std::string name(json.substr(from + 1, json.find('"', from + 1) - from - 1));
    if (is_object_name(name)) names.push_back(name);
  }
  return names;
}

Store::Store(const fs::path& folder, Database::Mode mode)
    : folder_(folder), mode_(mode), database_(prepared(folder, mode, warnings_), mode) {
  require_schema(database_, mode, folder / kStoreFile);
}

std::optional<std::string> Store::find(const std::string& key) {
  std::string json, hash;
  {
    Statement query = database_.prepare("SELECT json, hash FROM entries WHERE key = ?");
    query.bind({key});
    if (!query.step()) return std::nullopt;
    json = query.text(0);
    hash = query.text(1);
  }
  if (hash_text(json) != hash) {
    drop(key, "was altered");
    return std::nullopt;
  }
  if (has_intact_images(json)) return json;
  drop(key, "has lost an image, or its image was altered");
  return std::nullopt;
}

void Store::put(const Entry& entry) {
  Transaction transaction(database_);
  Statement insert = database_.prepare("INSERT OR REPLACE INTO entries VALUES(?, ?, ?, ?)");
  insert.bind({entry.key, to_text(entry.kind), entry.json, hash_text(entry.json)});
  insert.step();
  for (const std::string& object : object_names(entry.json)) remember(object);
  transaction.commit();
}

std::string Store::keep(const fs::path& image) {
  return keep_object(folder_, image);
}

std::vector<Entry> Store::entries(EntryKind kind) {
  std::vector<std::string> keys;
  {
    Statement query = database_.prepare("SELECT key FROM entries WHERE kind = ? ORDER BY key");
    query.bind({to_text(kind)});
    while (query.step()) keys.push_back(query.text(0));
  }
  std::vector<Entry> all;
  for (const std::string& key : keys) {
    if (auto json = find(key)) all.push_back({key, kind, std::move(*json)});
  }
  return all;
}

std::vector<std::string> Store::take_warnings() {
  return std::exchange(warnings_, {});
}

/// Bytes are read again only when size or time of change are not those remembered.
bool Store::has_intact_images(const std::string& json) {
  for (const std::string& object : object_names(json)) {
    if (is_remembered(object)) continue;
    if (!is_intact(folder_, object)) {
      // Gone, so that the one made again takes its place.
      std::error_code ignored;
      if (mode_ == Database::Mode::write) fs::remove(folder_ / object, ignored);
      return false;
    }
    if (mode_ == Database::Mode::write) remember(object);
  }
  return true;
}

bool Store::is_remembered(const std::string& object) {
  const auto [bytes, mtime_ns] = stamp_of(folder_ / object);
  Statement query = database_.prepare("SELECT bytes, mtime_ns FROM objects WHERE name = ?");
  query.bind({object});
  return query.step() && query.text(0) == bytes && query.text(1) == mtime_ns;
}

void Store::remember(const std::string& object) {
  const auto [bytes, mtime_ns] = stamp_of(folder_ / object);
  Statement insert = database_.prepare("INSERT OR REPLACE INTO objects VALUES(?, ?, ?)");
  insert.bind({object, bytes, mtime_ns});
  insert.step();
}

void Store::drop(const std::string& key, std::string_view why) {
  warnings_.push_back(fmt::format("the stored entry {} {}; it is made again", key, why));
  if (mode_ == Database::Mode::read) return;
  Statement remove = database_.prepare("DELETE FROM entries WHERE key = ?");
  remove.bind({key});
  remove.step();
}

}  // namespace umbrameter
