// Damaged LAS and LAZ files: one clear line, or the points. What bytes announce is never believed.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "las_writer.h"
#include "temporary_directory.h"
#include <gtest/gtest.h>

#include "hodt/base/error.h"
#include "hodt/io/las/arithmetic_decoder.h"
#include "hodt/io/las/las_reader.h"

namespace hodt {
namespace {

using test::content_of;
using test::input_of;
using test::LasWriter;
using test::message_of;

std::vector<std::string> fixtures() {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(HODT_TEST_FILES) / "las"))
    paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> contents;
  for (const std::filesystem::path& path : paths) contents.push_back(content_of(path));
  return contents;
}

bool same_points(const PointSet& a, const PointSet& b) {
  return a.xy == b.xy && a.z == b.z;
}

/// Reads all points, or says why not.
std::string problem_of(const std::string& bytes, PointSet* points = nullptr) {
  try {
    LasPoints las = read_las(input_of(bytes), parse_las_choice("all", ""));
    for (std::size_t i = 0; i < las.points.size(); ++i)
      EXPECT_TRUE(std::isfinite(las.points.xy[i].x) && std::isfinite(las.points.xy[i].y) &&
                  std::isfinite(las.points.z[i]));
    if (points) *points = std::move(las.points);
    return {};
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find("cloud.las: "), 0u) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
}

TEST(LasDamage, FilesCutShortAreRefusedWhereverTheyAreCut) {
  for (const std::string& whole : fixtures()) {
    PointSet wanted;
    ASSERT_EQ(problem_of(whole, &wanted), "");
    std::size_t read = 0;
    for (std::size_t size = 4; size < whole.size(); ++size) {
      PointSet found;
      if (!problem_of(whole.substr(0, size), &found).empty()) continue;
      ++read;
      EXPECT_TRUE(same_points(found, wanted)) << size;
    }
    EXPECT_LE(read, 4u) << "the last bytes of a stream may not be needed";
  }
}

TEST(LasDamage, FlippedBitsAreRefusedOrReadButNeverMore) {
  std::mt19937 random(1);
  std::size_t refused = 0, tried = 0;
  for (const std::string& whole : fixtures()) {
    for (int i = 0; i < 300; ++i) {
      std::string bytes = whole;
      for (int flips = i % 3; flips >= 0; --flips)
        bytes[4 + random() % (bytes.size() - 4)] ^= static_cast<char>(1u << random() % 8);
      refused += problem_of(bytes).empty() ? 0 : 1;
      ++tried;
    }
  }
  EXPECT_GT(refused, tried / 3);
}

std::string with(std::string bytes, std::size_t at, std::uint64_t number, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) bytes[at + i] = static_cast<char>(number >> (8 * i) & 255);
  return bytes;
}

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 4; i-- > 0;)
    number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
  return number;
}

std::string fixture(const char* name) {
  return content_of(std::filesystem::path(HODT_TEST_FILES) / "las" / name);
}

TEST(LasDamage, HeadersAreNotBelieved) {
  const std::string las = fixture("1.las"), las14 = fixture("6.las");
  const struct {
    std::string bytes;
    const char* problem;
  } cases[] = {
      {las.substr(0, 100), "its header ends at byte 100, and none is shorter than 227 bytes"},
      {with(las, 24, 2, 1), "LAS 2.2, and hodt reads LAS 1.0 to 1.4"},
      {with(las, 25, 5, 1), "LAS 1.5, and hodt reads LAS 1.0 to 1.4"},
      {with(las, 94, 226, 2), "the header of LAS 1.2 says that it has 226 bytes"},
      {with(las14, 94, 374, 2), "the header of LAS 1.4 says that it has 374 bytes"},
      {with(las, 96, 100, 4), "that points begin at byte 100; the file is damaged"},
      {with(las, 96, 0xFFFFFFFF, 4), "its points begin at byte 4294967295, and the file ends at"},
      {with(las, 100, 1, 4), "record 1 at byte 227 does not fit into the file"},
      {with(las, 104, 11, 1), "point format 11, and hodt reads formats 0 to 10"},
      {with(las, 105, 27, 2), "its points have 27 bytes, and those of format 1 at least 28"},
      {with(las, 107, 0, 4), "its header says that there is no point"},
      {with(las, 107, 201, 4),
       "its header says that there are 201 points, and the file ends in point 201 at byte"},
      {with(las, 107, 0xFFFFFFFF, 4), "that there are 4294967295 points"},
      {with(las14, 247, ~std::uint64_t{0}, 8), "that there are 18446744073709551615 points"},
      {with(las, 131, 0, 8), "its header gives x the scale 0 and the offset 400000"},
      {with(las, 155 + 16, 0x7FF0000000000000, 8), "its header gives z the scale 0.001 and the"},
      {with(with(las14, 243, 1, 4), 235, ~std::uint64_t{0}, 8), "record 1 at byte 184467440"},
      {with(las, 104, 128 + 1, 1), "its record 'laszip encoded' has only 0 bytes"},
  };
  for (const auto& c : cases)
    EXPECT_NE(problem_of(c.bytes).find(c.problem), std::string::npos) << c.problem << "\n"
                                                                      << problem_of(c.bytes);
}

TEST(LasDamage, RecordsOfCompressionAreNotBelieved) {
  const std::string laz = fixture("1.laz"), layered = fixture("6.laz");
  const std::size_t record = 227 + 54, begin = number_at(laz, 96);
  const std::size_t layered_begin = number_at(layered, 96);
  // The table stands behind the last chunk.
  const std::size_t table = number_at(laz, begin);
  const struct {
    std::string bytes;
    const char* problem;
  } cases[] = {
      {with(laz, record, 3, 2), "names compressor 3 with coder 0 for points of format 1"},
      {with(laz, record + 2, 1, 2), "names compressor 2 with coder 1"},
      {with(laz, record + 32, 9, 2), "announces 9 items, but ends before"},
      {with(laz, record + 32, 1, 2), "lacks items of a point of format 1"},
      {with(laz, record + 34, 8, 2), "names item 8 where a point of format 1 has none"},
      {with(laz, record + 36, 21, 2), "gives an item of kind 6 the size 21"},
      {with(laz, record + 38, 3, 2), "names version 3 of item 6"},
      {with(laz, 105, 29, 2), "has points of 28 bytes, and the header of 29"},
      {with(laz, record + 12, 63, 4),
       "after point 63: its points are decoded, and 12 of its bytes"},
      {with(laz, record + 12, 100, 4), "chunk 3 has 0 points, and all of them 200"},
      {with(laz, record + 12, 32, 4), "its chunks have 128 points, and the header says 200"},
      {with(laz, 107, 0xFFFFFFFF, 4), "its chunks have 256 points, and the header says 4294967295"},
      {with(laz, begin, 1000000, 8), "its table of chunks, which comes last, is not there"},
      {with(laz, begin, 0, 8), "its table of chunks, which comes last, is not there"},
      {with(laz, table, 1, 4), "its table of chunks cannot be read: it is of version 1"},
      {with(laz, table + 4, 0xFFFFFFFF, 4), "its table of chunks cannot be read: "},
      {with(laz, table + 4, 3, 4), "its chunks have 192 points, and the header says 200"},
      // The first layered chunk: a point, the number of points, the sizes of layers.
      {with(layered, layered_begin + 8 + number_at(layered, 105) % 65536, 65, 4),
       "it says that it has 65 points, and the table of chunks says 64"},
      {with(layered, layered_begin + 8 + number_at(layered, 105) % 65536 + 4, 1u << 31, 4),
       "its layer 1 does not fit into it"},
  };
  for (const auto& c : cases)
    EXPECT_NE(problem_of(c.bytes).find(c.problem), std::string::npos) << c.problem << "\n"
                                                                      << problem_of(c.bytes);
}

TEST(LasDamage, IsSaidToBeInItsFirstChunk) {
  const std::string laz = fixture("1.laz");
  const std::size_t begin = number_at(laz, 96), table = number_at(laz, begin);
  std::string bytes = laz;
  for (std::size_t i = begin + (table - begin) / 2; i < table; ++i) bytes[i] = '\xFF';
  const std::string problem = problem_of(bytes);
  EXPECT_NE(problem.find("chunk 2 of 4, which begins at byte"), std::string::npos) << problem;
  for (int i = 0; i < 10; ++i) EXPECT_EQ(problem_of(bytes), problem);
}

TEST(LasDamage, ATablesPlaceMayStandAtTheEnd) {
  const std::string laz = fixture("1.laz");
  const std::size_t begin = number_at(laz, 96), table = number_at(laz, begin);
  const std::string streamed =
      with(with(laz, begin, ~std::uint64_t{0}, 8) + std::string(8, '\0'), laz.size(), table, 8);
  PointSet wanted, found;
  EXPECT_EQ(problem_of(laz, &wanted), "");
  EXPECT_EQ(problem_of(streamed, &found), "");
  EXPECT_TRUE(same_points(found, wanted));
}

TEST(LasDamage, NoBytesMakeTheDecoderRunOn) {
  std::mt19937 random(2);
  for (int i = 0; i < 2000; ++i) {
    std::string bytes(4 + random() % 60, '\0');
    const int kind = i % 3;  // all zeros, all ones, anything
    for (char& c : bytes) c = static_cast<char>(kind == 0 ? 0 : kind == 1 ? 255 : random());
    const InputText input = input_of(bytes);
    las::SymbolModel<516> many;
    las::SymbolModel<3> few;
    las::BitModel bit;
    many.start(516);
    few.start(3);
    try {
      las::ArithmeticDecoder in(input.begin(), input.end());
      for (int symbols = 0;; ++symbols) {
        ASSERT_LT(symbols, 2000000);
        ASSERT_LT(in.symbol(many), 516u);
        ASSERT_LT(in.symbol(few), 3u);
        in.bit(bit);
        if (symbols % 4 == 0) in.bits(1 + random() % 32);
      }
    } catch (const las::Damage&) {
      // The only way out.
    }
  }
}

}  // namespace
}  // namespace hodt
