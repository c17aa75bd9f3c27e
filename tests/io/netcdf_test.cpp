#include "hodt/io/netcdf.h"

#include <bit>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "temporary_directory.h"
#include <gtest/gtest.h>

#include "hodt/base/error.h"
#include "hodt/io/bytes.h"

namespace hodt {
namespace {

using test::content_of;
using test::TemporaryDirectory;

/// Reads what the grammar of classic files says, and nothing else.
class Reader {
 public:
  explicit Reader(std::string bytes) : bytes_(std::move(bytes)) {}

  template <class T>
  T number() {
    T value = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i)
      value = T(value << 8) | static_cast<unsigned char>(bytes_.at(at_++));
    return value;
  }
  std::string text() {
    const auto size = number<std::uint32_t>();
    const std::string found = bytes_.substr(at_, size);
    at_ += (size + 3) / 4 * 4;
    return found;
  }
  std::map<std::string, std::string> attributes() {
    std::map<std::string, std::string> all;
    const auto tag = number<std::uint32_t>(), count = number<std::uint32_t>();
    EXPECT_EQ(tag, count ? 12u : 0u);
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::string name = text();
      if (number<std::uint32_t>() == 2) {
        all[name] = text();
      } else {
        EXPECT_EQ(number<std::uint32_t>(), 1u);
        all[name] = std::to_string(std::int32_t(number<std::uint32_t>()));
      }
    }
    return all;
  }
  std::size_t place() const { return at_; }
  void go(std::size_t place) { at_ = place; }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  std::size_t at_ = 0;
};

TEST(Netcdf, FollowsTheGrammar) {
  NetcdfContent content;
  content.dimensions = {{"five", 5}, {"two", 2}};
  content.attributes = {{"title", "abcde"}};
  content.variables = {
      {"numbers",
       NetcdfType::int32,
       {0},
       {},
       [](std::size_t i, char* to) { return put_big(to, std::int32_t(i) - 1); }},
      {"pairs",
       NetcdfType::float64,
       {0, 1},
       {{"empty", ""}, {"minus", -7}},
       [](std::size_t i, char* to) { return put_big(put_big(to, double(i) / 3), -double(i)); }},
      {"one", NetcdfType::int32, {}, {}, [](std::size_t, char* to) {
         return put_big(to, std::int32_t{258});
       }}};
  const TemporaryDirectory directory;
  atomic_write(directory / "a.nc", [&](OutputFile& file) { write_netcdf(content, file); });

  Reader reader(content_of(directory / "a.nc"));
  EXPECT_EQ(reader.number<std::uint32_t>(), 0x43444602u) << "CDF, 64-bit offsets";
  EXPECT_EQ(reader.number<std::uint32_t>(), 0u);
  EXPECT_EQ(reader.number<std::uint32_t>(), 10u);
  EXPECT_EQ(reader.number<std::uint32_t>(), 2u);
  EXPECT_EQ(reader.text(), "five");
  EXPECT_EQ(reader.number<std::uint32_t>(), 5u);
  EXPECT_EQ(reader.text(), "two");
  EXPECT_EQ(reader.number<std::uint32_t>(), 2u);
  EXPECT_EQ(reader.attributes(), (std::map<std::string, std::string>{{"title", "abcde"}}));
  EXPECT_EQ(reader.number<std::uint32_t>(), 11u);
  EXPECT_EQ(reader.number<std::uint32_t>(), 3u);
  std::vector<std::uint64_t> begins;
  const struct {
    const char* name;
    std::vector<std::uint32_t> dimensions;
    std::map<std::string, std::string> attributes;
    std::uint32_t type, size;
  } expected[] = {{"numbers", {0}, {}, 4, 20},
                  {"pairs", {0, 1}, {{"empty", ""}, {"minus", "-7"}}, 6, 80},
                  {"one", {}, {}, 4, 4}};
  for (const auto& variable : expected) {
    EXPECT_EQ(reader.text(), variable.name);
    EXPECT_EQ(reader.number<std::uint32_t>(), variable.dimensions.size());
    for (const std::uint32_t d : variable.dimensions) EXPECT_EQ(reader.number<std::uint32_t>(), d);
    EXPECT_EQ(reader.attributes(), variable.attributes);
    EXPECT_EQ(reader.number<std::uint32_t>(), variable.type);
    EXPECT_EQ(reader.number<std::uint32_t>(), variable.size);
    begins.push_back(reader.number<std::uint64_t>());
  }
  EXPECT_EQ(begins[0], reader.place());
  for (int i = 0; i < 5; ++i) EXPECT_EQ(std::int32_t(reader.number<std::uint32_t>()), i - 1);
  reader.go(begins[1]);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(std::bit_cast<double>(reader.number<std::uint64_t>()), double(i) / 3);
    EXPECT_EQ(std::bit_cast<double>(reader.number<std::uint64_t>()), -double(i));
  }
  EXPECT_EQ(begins[2], reader.place());
  EXPECT_EQ(reader.number<std::uint32_t>(), 258u);
  EXPECT_EQ(reader.place(), reader.bytes().size());
}

TEST(Netcdf, RefusesWhatIsTooLarge) {
  NetcdfContent content;
  content.dimensions = {{"faces", 357913942}, {"three", 3}};
  content.variables = {{"nodes", NetcdfType::int32, {0, 1}, {}, {}}};
  const TemporaryDirectory directory;
  const auto write = [&] {
    atomic_write(directory / "a.nc", [&](OutputFile& file) { write_netcdf(content, file); });
  };
  EXPECT_THROW(write(), InputError);
  content.dimensions = {{"nodes", std::size_t{1} << 31}, {"three", 3}};
  content.variables.clear();
  EXPECT_THROW(write(), InputError);
  EXPECT_EQ(directory.entries(), 0u);
}

}  // namespace
}  // namespace hodt
