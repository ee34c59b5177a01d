// SPDX-License-Identifier: Apache-2.0
#include "store/database.h"

#include "core/error.h"

#include <fmt/ranges.h>
#include <sqlite3.h>

#include <unistd.h>

#include <chrono>
#include <thread>

namespace umbrameter {
namespace {

constexpr int kBusyTimeout_ms = 60000;

[[noreturn]] void fail_database(sqlite3* handle, const std::filesystem::path& file) {
  const int code = sqlite3_errcode(handle) & 0xff;  // the primary code
  const std::string hint = code == SQLITE_FULL || code == SQLITE_IOERR
                               ? "is the disk full? what is stored already stays; make room and run again"
                           : code == SQLITE_READONLY || code == SQLITE_CANTOPEN
                               ? "check the permissions of the folder"
                           : code == SQLITE_BUSY ? "another process holds it; run again when it is done"
                           : code == SQLITE_CORRUPT || code == SQLITE_NOTADB
                               ? "run again: the store is checked and repaired when it is opened"
                               : "";
  fail_environment(fmt::format("the store '{}' fails: {}", file.string(), sqlite3_errmsg(handle)), hint);
}

/// A read-only place can hold no write-ahead log, and nobody changes the file behind our back.
std::string uri_of(const std::filesystem::path& file) {
  std::string uri = "file:";
  for (const char c : std::filesystem::absolute(file).string()) {
    const bool is_special = c == '%' || c == '?' || c == '#';
    uri += is_special ? fmt::format("%{:02x}", static_cast<int>(c)) : std::string(1, c);
  }
  return uri + "?immutable=1";
}

int open_database(const std::filesystem::path& file, Database::Mode mode, sqlite3** handle) {
  const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  if (mode == Database::Mode::read && access(folder.c_str(), W_OK) != 0)
    return sqlite3_open_v2(uri_of(file).c_str(), handle, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, nullptr);
  const int create = mode == Database::Mode::write ? SQLITE_OPEN_CREATE : 0;
  return sqlite3_open_v2(file.c_str(), handle, SQLITE_OPEN_READWRITE | create, nullptr);
}

std::string column_text(sqlite3_stmt* statement, int column) {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement, column));
  const auto size = static_cast<size_t>(sqlite3_column_bytes(statement, column));
  return text == nullptr ? std::string() : std::string(text, size);
}

}  // namespace

Statement::Statement(sqlite3* handle, sqlite3_stmt* statement, const std::filesystem::path& file)
    : handle_(handle), statement_(statement), file_(file) {}

Statement::~Statement() {
  sqlite3_finalize(statement_);
}

void Statement::bind(std::initializer_list<std::string_view> texts) {
  sqlite3_reset(statement_);
  int place = 0;
  for (const std::string_view text : texts) {
    if (sqlite3_bind_text64(statement_, ++place, text.data(), text.size(), SQLITE_TRANSIENT, SQLITE_UTF8) !=
        SQLITE_OK)
      fail_database(handle_, file_);
  }
}

bool Statement::step() {
  const int code = sqlite3_step(statement_);
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  fail_database(handle_, file_);
}

std::string Statement::text(int column) const {
  return column_text(statement_, column);
}

int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(statement_, column);
}

Database::Database(const std::filesystem::path& file, Mode mode) : file_(file) {
  const int code = open_database(file_, mode, &handle_);
  sqlite3_busy_timeout(handle_, kBusyTimeout_ms);
  if (code == SQLITE_OK) return;
  const std::string problem = sqlite3_errmsg(handle_);
  sqlite3_close(handle_);
  fail_environment(fmt::format("the store '{}' cannot be opened: {}", file_.string(), problem),
                   "check that the folder exists and its permissions");
}

Database::~Database() {
  sqlite3_close(handle_);
}

Statement Database::prepare(std::string_view sql) {
  sqlite3_stmt* statement = nullptr;
  if (sqlite3_prepare_v2(handle_, sql.data(), static_cast<int>(sql.size()), &statement, nullptr) != SQLITE_OK)
    fail_database(handle_, file_);
  return {handle_, statement, file_};
}

void Database::run(std::string_view sql) {
  if (sqlite3_exec(handle_, std::string(sql).c_str(), nullptr, nullptr, nullptr) != SQLITE_OK)
    fail_database(handle_, file_);
}

void Database::use_write_ahead_log() {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(kBusyTimeout_ms);
  for (;;) {
    const int code = sqlite3_exec(handle_, "PRAGMA journal_mode = WAL", nullptr, nullptr, nullptr);
    if (code == SQLITE_OK) return;
    if (code != SQLITE_BUSY || std::chrono::steady_clock::now() > deadline) fail_database(handle_, file_);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

bool Database::is_sound(const std::filesystem::path& file) {
  sqlite3* handle = nullptr;
  sqlite3_stmt* statement = nullptr;
  bool sound = open_database(file, Mode::read, &handle) == SQLITE_OK;
  if (sound) {
    sqlite3_busy_timeout(handle, kBusyTimeout_ms);
    sound = sqlite3_prepare_v2(handle, "PRAGMA quick_check(1)", -1, &statement, nullptr) == SQLITE_OK &&
            sqlite3_step(statement) == SQLITE_ROW &&
            std::string_view(reinterpret_cast<const char*>(sqlite3_column_text(statement, 0))) == "ok";
  }
  sqlite3_finalize(statement);
  sqlite3_close(handle);
  return sound;
}

void Database::salvage(const std::filesystem::path& file, std::string_view table,
                       const std::vector<std::string>& columns, int64_t last,
                       const std::function<void(const std::vector<std::string>&)>& row) {
  sqlite3* handle = nullptr;
  sqlite3_stmt* statement = nullptr;
  const std::string sql =
      fmt::format("SELECT {} FROM {} NOT INDEXED WHERE rowid = ?", fmt::join(columns, ", "), table);
  if (open_database(file, Mode::read, &handle) == SQLITE_OK &&
      sqlite3_prepare_v2(handle, sql.c_str(), -1, &statement, nullptr) == SQLITE_OK) {
    for (int64_t id = 1; id <= last; ++id) {
      sqlite3_reset(statement);
      sqlite3_bind_int64(statement, 1, id);
      if (sqlite3_step(statement) != SQLITE_ROW) continue;
      std::vector<std::string> texts;
      for (size_t i = 0; i < columns.size(); ++i)
        texts.push_back(column_text(statement, static_cast<int>(i)));
      row(texts);
    }
  }
  sqlite3_finalize(statement);
  sqlite3_close(handle);
}

Transaction::Transaction(Database& database) : database_(database) {
  database_.run("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
  if (is_open_) sqlite3_exec(database_.handle_, "ROLLBACK", nullptr, nullptr, nullptr);
}

void Transaction::commit() {
  database_.run("COMMIT");
  is_open_ = false;
}

}  // namespace umbrameter
