#include "hodt/io/sqlite.h"

#include <cerrno>
#include <cstring>
#include <utility>

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

Statement::Statement(Database& database, const std::string& text) : database_(database) {
  check(sqlite3_prepare_v2(database.handle_, text.c_str(), -1, &handle_, nullptr));
}

Statement::~Statement() {
  sqlite3_finalize(handle_);
}

void Statement::check(int result) {
  if (result != SQLITE_OK) database_.fail();
}

void Statement::bind(int place, std::int64_t value) {
  check(sqlite3_bind_int64(handle_, place, value));
}

void Statement::bind(int place, double value) {
  check(sqlite3_bind_double(handle_, place, value));
}

void Statement::bind_null(int place) {
  check(sqlite3_bind_null(handle_, place));
}

void Statement::bind_text(int place, std::string_view text) {
  check(sqlite3_bind_text64(handle_, place, text.data(), text.size(), SQLITE_STATIC, SQLITE_UTF8));
}

void Statement::bind_blob(int place, std::string_view bytes) {
  check(sqlite3_bind_blob64(handle_, place, bytes.data(), bytes.size(), SQLITE_STATIC));
}

void Statement::run() {
  if (sqlite3_step(handle_) != SQLITE_DONE) database_.fail();
  check(sqlite3_reset(handle_));
}

std::string sql_name(std::string_view name) {
  return quoted(name, '"');
}

std::string sql_text(std::string_view text) {
  return quoted(text, '\'');
}

}  // namespace hodt
