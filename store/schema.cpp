// SPDX-License-Identifier: Apache-2.0
#include "store/schema.h"

#include "core/error.h"
#include "core/files.h"
#include "core/hash.h"
#include "store/store.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace umbrameter {

namespace fs = std::filesystem;

namespace {

constexpr const char* kTables = R"(
CREATE TABLE IF NOT EXISTS meta(name TEXT PRIMARY KEY, value TEXT NOT NULL);
CREATE TABLE IF NOT EXISTS entries(key TEXT PRIMARY KEY, kind TEXT NOT NULL, json TEXT NOT NULL, hash TEXT NOT NULL);
CREATE TABLE IF NOT EXISTS objects(name TEXT PRIMARY KEY, bytes INTEGER NOT NULL, mtime_ns INTEGER NOT NULL);
CREATE VIEW IF NOT EXISTS runs AS SELECT key,
  json_extract(json, '$.scene') AS scene,
  json_extract(json, '$.result.technique') AS technique,
  json_extract(json, '$.result.label') AS label,
  json_extract(json, '$.seed') AS seed,
  json_extract(json, '$.result.error.rmse.value') AS rmse,
  json_extract(json, '$.result.error.rmse.low') AS rmse_low,
  json_extract(json, '$.result.error.rmse.high') AS rmse_high,
  json_extract(json, '$.result.pass_times[#-1].median_ms') AS time_ms,
  json_extract(json, '$.result.pass_times[#-1].mad_ms') AS mad_ms,
  json_extract(json, '$.status') AS status,
  json_extract(json, '$.result.failure.message') AS failure,
  json_extract(json, '$.started') AS started,
  json_extract(json, '$.duration_s') AS duration_s
FROM entries WHERE kind = 'run' AND json_valid(json);
CREATE VIEW IF NOT EXISTS measurements AS SELECT entries.key AS key,
  json_extract(entries.json, '$.scene') AS scene,
  json_extract(entries.json, '$.result.label') AS label,
  number.key AS metric,
  number.value AS value
FROM entries, json_each(CASE WHEN json_valid(entries.json) THEN entries.json ELSE '{}' END, '$.result.measurements') AS number WHERE kind = 'run';
)";

/// Held while this lives; the kernel lets go when the process dies.
class FolderLock {
 public:
  explicit FolderLock(const fs::path& file)
      : descriptor_(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
    if (descriptor_ >= 0) flock(descriptor_, LOCK_EX);
  }
  ~FolderLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

/// Row by row, so that a damaged page costs its own rows alone; altered rows are left out, too.
std::vector<Entry> salvage(const fs::path& damaged) {
  constexpr uintmax_t kLeastRowBytes = 64;  // a key and a hash alone
  std::vector<Entry> saved;
  const auto last = static_cast<int64_t>(fs::file_size(damaged) / kLeastRowBytes);
  Database::salvage(damaged, "entries", {"key", "kind", "json", "hash"}, last,
                    [&](const std::vector<std::string>& row) {
                      const auto kind = read_kind(row[1]);
                      if (kind && hash_text(row[2]) == row[3]) saved.push_back({row[0], *kind, row[2]});
                    });
  return saved;
}

}  // namespace

void require_schema(Database& database, Database::Mode mode, const fs::path& file) {
  if (mode == Database::Mode::write) {
    database.use_write_ahead_log();
    database.run("PRAGMA synchronous = NORMAL;");
    Transaction transaction(database);
    database.run(kTables);
    database.run(fmt::format("INSERT OR IGNORE INTO meta VALUES('schema', '{}');", kStoreSchema));
    transaction.commit();
  }
  Statement schema = database.prepare("SELECT value FROM meta WHERE name = 'schema'");
  const std::string found = schema.step() ? schema.text(0) : "none";
  if (found == std::to_string(kStoreSchema)) return;
  fail_input(fmt::format("a store of schema {}; this version reads {}", found, kStoreSchema), {file.string()},
             "choose another folder");
}

void repair_if_damaged(const fs::path& folder, std::vector<std::string>& warnings) {
  const fs::path file = folder / kStoreFile;
  if (!fs::exists(file) || fs::file_size(file) == 0) return;
  const FolderLock lock(folder / ".store.lock");
  if (Database::is_sound(file)) return;
  const std::vector<Entry> saved = salvage(file);
  const fs::path aside = folder / fmt::format("{}.damaged", kStoreFile);
  for (const char* part : {"-wal", "-shm"}) {
    std::error_code ignored;
    fs::remove(file.string() + part, ignored);
  }
  rename_into_place(file, aside);
  Database database(file, Database::Mode::write);
  require_schema(database, Database::Mode::write, file);
  Transaction transaction(database);
  Statement insert = database.prepare("INSERT OR REPLACE INTO entries VALUES(?, ?, ?, ?)");
  for (const Entry& entry : saved) {
    insert.bind({entry.key, to_text(entry.kind), entry.json, hash_text(entry.json)});
    insert.step();
  }
  transaction.commit();
  warnings.push_back(
      fmt::format("the store '{}' was damaged: {} entries could be read and are kept, the rest is made "
                  "again; the damaged file is '{}'",
                  file.string(), saved.size(), aside.string()));
}

}  // namespace umbrameter
