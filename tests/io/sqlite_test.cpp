#include "hodt/io/sqlite.h"

#include <stdexcept>
#include <string>
#include <vector>

#include "temporary_directory.h"
#include <gtest/gtest.h>

#include "hodt/base/error.h"

namespace hodt {
namespace {

using test::message_of;
using test::TemporaryDirectory;

class Sqlite : public testing::Test {
 protected:
  void SetUp() override { database_.run("CREATE TABLE t (a INTEGER PRIMARY KEY, b, c)"); }

  TemporaryDirectory directory_;
  Database database_{directory_ / "a.db", "shown.db"};
};

TEST_F(Sqlite, TakesRowsOfEveryKindOfValue) {
  const std::vector<SqlValue> values = {{},
                                        std::int64_t{-7},
                                        0.1,
                                        std::string_view("it's\0so", 7),
                                        SqlBlob{std::string_view("\0\xff", 2)},
                                        std::string_view(""),
                                        SqlBlob{}};
  std::size_t next = 0;
  database_.insert("INSERT INTO t (c, a)", 2, [&](std::span<SqlValue> row) {
    if (next == values.size()) return false;
    row[0] = values[next];
    row[1] = std::int64_t(next++);
    return true;
  });
  EXPECT_EQ(database_.number("SELECT count(*) FROM t"), 7);
  const char* const expected[] = {
      "c IS NULL",   "c = -7",
      "c = 0.1",     "hex(c) = '697427730073' || hex('o') AND typeof(c) = 'text'",
      "c = x'00ff'", "c = ''",
      "c = x''"};
  for (std::size_t i = 0; i < values.size(); ++i)
    EXPECT_EQ(database_.number("SELECT b IS NULL AND " + std::string(expected[i]) +
                               " FROM t WHERE a = " + std::to_string(i)),
              1)
        << i;
}

TEST_F(Sqlite, TakesNoRowsAndRowsTimeAfterTime) {
  for (std::int64_t round = 0; round < 3; ++round) {
    std::int64_t left = round;
    database_.insert("INSERT INTO t (b)", 1, [&](std::span<SqlValue> row) {
      row[0] = round;
      return left-- > 0;
    });
  }
  EXPECT_EQ(database_.number("SELECT sum(b * 10 + a) FROM t"), 10 + 1 + 20 + 2 + 20 + 3);
}

TEST_F(Sqlite, PassesFailuresOn) {
  const auto fail = [](std::span<SqlValue>) -> bool { throw std::runtime_error("no more rows"); };
  EXPECT_EQ(message_of<std::runtime_error>([&] { database_.insert("INSERT INTO t (b)", 1, fail); }),
            "no more rows");
  EXPECT_EQ(message_of<FileError>([&] { database_.insert("INSERT INTO gone (b)", 1, fail); }),
            "cannot write shown.db: no such table: gone");
  std::int64_t row_number = 5;
  const auto clash = [&](std::span<SqlValue> row) {
    row[0] = row_number / 2;
    return ++row_number < 10;
  };
  EXPECT_EQ(message_of<FileError>([&] { database_.insert("INSERT INTO t (a)", 1, clash); }),
            "cannot write shown.db: UNIQUE constraint failed: t.a");
}

}  // namespace
}  // namespace hodt
