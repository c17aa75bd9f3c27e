// Databases of SQLite, as far as it takes to fill one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

struct sqlite3;

namespace hodt {

/// Bytes as a value.
struct SqlBlob {
  std::string_view bytes;
};

/// A value of a row: nothing (NULL), a number, words in UTF-8, or bytes.
using SqlValue = std::variant<std::monostate, std::int64_t, double, std::string_view, SqlBlob>;

/// Fills in the next row, or returns false if there is none. What the values name has to live until
/// the next call.
using NextRow = std::function<bool(std::span<SqlValue> row)>;

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
  /// Runs an INSERT that ends before its values ("INSERT INTO pits (depth, volume)"), for all rows
  /// at once: a statement for each row would take twice as long. Throws what `next` throws.
  void insert(const std::string& statement, std::size_t columns, const NextRow& next);
  /// Everything is in the file, which is closed.
  void close();

 private:
  [[noreturn]] void fail();

  sqlite3* handle_ = nullptr;
  std::filesystem::path shown_;
};

/// The words in the first column of a query's rows, from a file that stays as it is. Empty if it is
/// no database, or has nothing like that.
std::vector<std::string> words_in_database(const std::filesystem::path& path,
                                           const std::string& query);

/// A name as SQL writes it: "layer ""a""".
std::string sql_name(std::string_view name);
/// Words as SQL writes them: 'it''s'.
std::string sql_text(std::string_view text);

}  // namespace hodt
