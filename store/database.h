// SPDX-License-Identifier: Apache-2.0
#pragma once
// SQLite with our errors: the only user of sqlite3.h. Not here: what is stored (store/store.h).

#include <cstdint>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

struct sqlite3;
struct sqlite3_stmt;

namespace umbrameter {

/// One prepared statement; its texts are bound in order.
class Statement {
 public:
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  void bind(std::initializer_list<std::string_view> texts);
  /// True while there is a row. Error{environment} for a full disk, a damaged page and the like.
  bool step();
  std::string text(int column) const;
  int64_t integer(int column) const;

 private:
  friend class Database;
  Statement(sqlite3* handle, sqlite3_stmt* statement, const std::filesystem::path& file);

  sqlite3* handle_;
  sqlite3_stmt* statement_;
  const std::filesystem::path& file_;
};

class Database {
 public:
  enum class Mode { write, read };

  /// Opens or (write) makes the file, with a write-ahead log and a minute's patience for other processes. A place that
  /// cannot be written to can still be read. Error{environment} saying why not.
  Database(const std::filesystem::path& file, Mode mode);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  Statement prepare(std::string_view sql);
  /// Runs statements without results.
  void run(std::string_view sql);
  /// Switches to a write-ahead log. Waits for others as run() does: two that make a file at once would each hold what the other
  /// needs, so that SQLite fails this statement at once instead of waiting.
  void use_write_ahead_log();

  /// Whether SQLite finds every page in order; a file that is no database is not. Never throws.
  static bool is_sound(const std::filesystem::path& file);

  /// Calls `row` with the texts of the `columns` of every row from 1 to `last` that can be read; what cannot is left
  /// out. Never throws.
  static void salvage(const std::filesystem::path& file, std::string_view table,
                      const std::vector<std::string>& columns, int64_t last,
                      const std::function<void(const std::vector<std::string>&)>& row);

 private:
  friend class Transaction;
  std::filesystem::path file_;
  sqlite3* handle_ = nullptr;
};

/// Everything until commit() happens, or nothing does.
class Transaction {
 public:
  explicit Transaction(Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  Database& database_;
  bool is_open_ = true;
};

}  // namespace umbrameter
