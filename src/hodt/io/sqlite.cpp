#include "hodt/io/sqlite.h"

#include <cerrno>
#include <cstring>
#include <exception>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <sqlite3.h>

#include "hodt/base/error.h"

namespace hodt {

namespace {

std::string quoted(std::string_view text, char quote) {
  std::string result(1, quote);
  for (const char c : text) {
    if (c == quote) result += c;
    result += c;
  }
  return result + quote;
}

/// No table can be called like this: names that begin so belong to SQLite.
constexpr const char* kRowTable = "sqlite_hodt_rows";

/// Rows that somebody makes, in SQLite's eyes a table to select from, once and from first to last
/// (a virtual table that is there without having been created).
class RowTable {
 public:
  static const sqlite3_module kModule;

  RowTable(std::size_t columns, const NextRow& next) : next_(next), row_(columns) {}

  /// Throws what could not be thrown through SQLite.
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  struct Table : sqlite3_vtab {
    RowTable* rows;
  };
  struct Cursor : sqlite3_vtab_cursor {};

  static RowTable& rows_of(sqlite3_vtab_cursor* cursor) {
    return *static_cast<Table*>(cursor->pVtab)->rows;
  }

  static int connect(sqlite3* database, void* rows, int, const char* const*, sqlite3_vtab** made,
                     char**) {
    std::string columns = "column0";
    for (std::size_t i = 1; i < static_cast<RowTable*>(rows)->row_.size(); ++i)
      columns += fmt::format(", column{}", i);
    *made = new Table{{}, static_cast<RowTable*>(rows)};
    return sqlite3_declare_vtab(database, fmt::format("CREATE TABLE rows ({})", columns).c_str());
  }
  static int disconnect(sqlite3_vtab* table) {
    delete static_cast<Table*>(table);
    return SQLITE_OK;
  }
  static int plan(sqlite3_vtab*, sqlite3_index_info*) { return SQLITE_OK; }
  static int open(sqlite3_vtab*, sqlite3_vtab_cursor** cursor) {
    *cursor = new Cursor{};
    return SQLITE_OK;
  }
  static int close(sqlite3_vtab_cursor* cursor) {
    delete static_cast<Cursor*>(cursor);
    return SQLITE_OK;
  }
  static int start(sqlite3_vtab_cursor* cursor, int, const char*, int, sqlite3_value**) {
    return step(cursor);
  }
  static int step(sqlite3_vtab_cursor* cursor) {
    RowTable& rows = rows_of(cursor);
    try {
      rows.at_end_ = !rows.next_(rows.row_);
      return SQLITE_OK;
    } catch (...) {
      rows.failure_ = std::current_exception();
      return SQLITE_ABORT;
    }
  }
  static int at_end(sqlite3_vtab_cursor* cursor) { return rows_of(cursor).at_end_ ? 1 : 0; }
  static int column(sqlite3_vtab_cursor* cursor, sqlite3_context* to, int i) {
    const SqlValue& value = rows_of(cursor).row_[static_cast<std::size_t>(i)];
    if (const auto* const whole = std::get_if<std::int64_t>(&value))
      sqlite3_result_int64(to, *whole);
    else if (const auto* const real = std::get_if<double>(&value))
      sqlite3_result_double(to, *real);
    else if (const auto* const text = std::get_if<std::string_view>(&value))
      sqlite3_result_text64(to, there(*text), text->size(), SQLITE_STATIC, SQLITE_UTF8);
    else if (const auto* const blob = std::get_if<SqlBlob>(&value))
      sqlite3_result_blob64(to, there(blob->bytes), blob->bytes.size(), SQLITE_STATIC);
    return SQLITE_OK;  // nothing is what a column has by itself
  }
  /// Nothing at no address would be NULL.
  static const char* there(std::string_view bytes) { return bytes.empty() ? "" : bytes.data(); }
  static int row_id(sqlite3_vtab_cursor*, sqlite3_int64*) { return SQLITE_ERROR; }

  const NextRow& next_;
  std::vector<SqlValue> row_;
  bool at_end_ = false;
  std::exception_ptr failure_;
};

/// The name by which SQLite opens a file and makes none beside it: as one that nobody changes,
/// unless a journal says that somebody did.
std::string name_to_look_at(const std::filesystem::path& path) {
  std::string name = "file:";
  for (const char c : path.native()) name += fmt::format("%{:02x}", static_cast<unsigned char>(c));
  return name + (std::filesystem::exists(path.native() + "-wal") ? "?mode=ro" : "?immutable=1");
}

const sqlite3_module RowTable::kModule = [] {
  sqlite3_module module{};
  module.xConnect = connect;
  module.xBestIndex = plan;
  module.xDisconnect = disconnect;
  module.xDestroy = disconnect;
  module.xOpen = open;
  module.xClose = close;
  module.xFilter = start;
  module.xNext = step;
  module.xEof = at_end;
  module.xColumn = column;
  module.xRowid = row_id;
  return module;
}();

}  // namespace

Database::Database(const std::filesystem::path& path, std::filesystem::path shown)
    : shown_(std::move(shown)) {
  constexpr int flags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX;
  if (sqlite3_open_v2(path.c_str(), &handle_, flags, nullptr) != SQLITE_OK) fail();
  run("PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF; PRAGMA locking_mode = EXCLUSIVE");
}

Database::~Database() {
  sqlite3_close(handle_);
}

void Database::run(const std::string& statements) {
  if (sqlite3_exec(handle_, statements.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) fail();
}

std::int64_t Database::number(const std::string& query) {
  std::int64_t value = 0;
  const auto take = [](void* to, int, char** values, char**) {
    if (values[0] != nullptr) *static_cast<std::int64_t*>(to) = std::atoll(values[0]);
    return 0;
  };
  if (sqlite3_exec(handle_, query.c_str(), take, &value, nullptr) != SQLITE_OK) fail();
  return value;
}

void Database::insert(const std::string& statement, std::size_t columns, const NextRow& next) {
  RowTable rows(columns, next);
  if (sqlite3_create_module(handle_, kRowTable, &RowTable::kModule, &rows) != SQLITE_OK) fail();
  const std::string text = fmt::format("{} SELECT * FROM {}", statement, kRowTable);
  const int result = sqlite3_exec(handle_, text.c_str(), nullptr, nullptr, nullptr);
  rows.rethrow();
  if (result != SQLITE_OK) fail();
}

void Database::close() {
  if (sqlite3_close(handle_) != SQLITE_OK) fail();
  handle_ = nullptr;
}

void Database::fail() {
  const int error = handle_ != nullptr ? sqlite3_system_errno(handle_) : 0;
  const int code = sqlite3_extended_errcode(handle_);
  const char* why = code == SQLITE_FULL ? std::strerror(ENOSPC)
                    : error != 0        ? std::strerror(error)
                                        : sqlite3_errmsg(handle_);
  throw FileError(fmt::format("cannot write {}: {}", shown_.string(), why));
}

std::vector<std::string> words_in_database(const std::filesystem::path& path,
                                           const std::string& query) {
  std::vector<std::string> words;
  const auto take = [](void* to, int, char** values, char**) {
    if (values[0] != nullptr) static_cast<std::vector<std::string>*>(to)->emplace_back(values[0]);
    return 0;
  };
  sqlite3* database = nullptr;
  constexpr int flags = SQLITE_OPEN_READONLY | SQLITE_OPEN_URI;
  if (sqlite3_open_v2(name_to_look_at(path).c_str(), &database, flags, nullptr) == SQLITE_OK)
    sqlite3_exec(database, query.c_str(), take, &words, nullptr);
  sqlite3_close(database);
  return words;
}

std::string sql_name(std::string_view name) {
  return quoted(name, '"');
}

std::string sql_text(std::string_view text) {
  return quoted(text, '\'');
}

}  // namespace hodt
