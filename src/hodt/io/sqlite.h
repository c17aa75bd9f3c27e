// Databases of SQLite, as far as it takes to fill one.
// Tested by tests/io/feature_file_test.cpp.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace hodt {

/// A new database in a file of its own, which nobody else sees: without a journal and without
/// waiting for the disk. Everything throws FileError that names `shown` in place of the path.
class Database {
 public:
  Database(const std::filesystem::path& path, std::filesystem::path shown);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  /// Runs statements that return nothing.
  void run(const std::string& statements);
  /// The first value of a query's first row; 0 if it has none.
  std::int64_t number(const std::string& query);
  /// Everything is in the file, which is closed.
  void close();

 private:
  friend class Statement;
  [[noreturn]] void fail();

  sqlite3* handle_ = nullptr;
  std::filesystem::path shown_;
};

/// A statement with places for values, numbered from 1, which is run time after time. Values stay
/// until they are bound again.
class Statement {
 public:
  Statement(Database& database, const std::string& text);
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  void bind(int place, std::int64_t value);
  void bind(int place, double value);
  void bind_null(int place);
  /// What these name has to live until the next run() is over.
  void bind_text(int place, std::string_view text);
  void bind_blob(int place, std::string_view bytes);
  void run();

 private:
  void check(int result);

  Database& database_;
  sqlite3_stmt* handle_ = nullptr;
};

/// A name as SQL writes it: "layer ""a""".
std::string sql_name(std::string_view name);
/// Words as SQL writes them: 'it''s'.
std::string sql_text(std::string_view text);

}  // namespace hodt
