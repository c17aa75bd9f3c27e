#include "hodt/io/edge_pairs_file.h"

#include <string>
#include <vector>

#include "temporary_directory.h"
#include <gtest/gtest.h>

#include "hodt/base/error.h"
#include "hodt/io/gzip.h"

namespace hodt {
namespace {

using test::message_of;
using test::TemporaryDirectory;

using Edges = std::vector<std::array<Index, 2>>;

EdgePairs read(const std::string& text) {
  const TemporaryDirectory directory;
  return read_edge_pairs(directory.file("edges.csv", text));
}

Edges edges_of(const std::string& text) {
  return read(text).edges;
}

/// What is said after the name of the file.
std::string refusal_of(const std::string& text) {
  const std::string message = message_of<InputError>([&] { read(text); });
  const std::string name = "edges.csv";
  const std::size_t at = message.find(name);
  return at == message.npos ? message : message.substr(at + name.size());
}

TEST(EdgePairsFile, reads_what_edges_writes) {
  const EdgePairs pairs = read("u,v,order\n1,2,0\n0,7,3\n");
  EXPECT_EQ(pairs.edges, Edges({{1, 2}, {0, 7}}));
  EXPECT_EQ(pairs.lines, std::vector<std::size_t>({2, 3}));
  EXPECT_TRUE(pairs.source.ends_with("edges.csv"));
  EXPECT_EQ(pairs.place(1), pairs.source + ", line 3");
}

TEST(EdgePairsFile, reads_other_tables) {
  const Edges expected = {{1, 2}, {4, 3}};
  for (const char* text : {"1,2\n4,3",
                           "1 2\n4 3\n",
                           "1\t2\n4\t3\n",
                           "1;2\n4;3\n",
                           "  1   2  \n\t4 3\n",
                           "1, 2\n4, 3\n",
                           "\"1\",\"2\"\n\"4\",\"3\"\n",
                           "1,2\r\n4,3\r\n",
                           "1,2\r4,3\r",
                           "\xEF\xBB\xBF"
                           "1,2\n4,3\n",
                           "\xEF\xBB\xBFu,v\n1,2\n4,3\n",
                           "from,to\n1,2\n4,3\n",
                           "V,U\n2,1\n3,4\n",
                           "name;v;u;length\na;2;1;0.5\nb;3;4;1e9\n",
                           "sep=;\nu;v\n1;2\n4;3\n",
                           "# edges\n\n1 2\n% more\n4 3\n",
                           "u,v,\n1,2,\n4,3,,\n,,\n",
                           "+1,02\n4,3\n",
                           "u,v,w\n1,2\n4,3\n",
                           "u,v,w\n1,2,\"a,b\"\n4,3,\r\r\n",
                           "u v w\n1 2  3\n4 3 \t7\n"})
    EXPECT_EQ(edges_of(text), expected) << text;
  EXPECT_EQ(edges_of("0,4294967294"), Edges({{0, 4294967294}}));
  const Buffer<char> packed = gzip("u,v\n1,2\n4,3\n");
  EXPECT_EQ(edges_of({packed.data(), packed.size()}), expected);
}

TEST(EdgePairsFile, knows_the_lines_of_edges) {
  EXPECT_EQ(read("sep=;\n# ends\nu;v\n\n1;2\n;\n# more\n4;3").lines,
            std::vector<std::size_t>({5, 8}));
  // The layout is read off the first hundred rows, the edges off all.
  std::string text = "u v\n";
  for (int i = 0; i < 1000; ++i) text += std::to_string(i) + " " + std::to_string(i + 1) + "\n";
  const EdgePairs pairs = read(text);
  ASSERT_EQ(pairs.edges.size(), 1000u);
  EXPECT_EQ(pairs.edges[999], (std::array<Index, 2>{999, 1000}));
  EXPECT_EQ(pairs.lines[999], 1001u);
}

TEST(EdgePairsFile, refuses_what_is_no_vertex) {
  for (const char* field : {"1.5", "1.0", "1e3", "x", "NA", "1 2", "0x10", "1,5", "--1", "+"})
    EXPECT_EQ(refusal_of("u;v\n1;2\n3;" + std::string(field) + "\n"),
              ", line 3: '" + std::string(field) +
                  "' for v is no whole number; vertices are numbers of rows")
        << field;
  for (const char* field : {"-3", "-0", "-99999999999999999999"})
    EXPECT_EQ(refusal_of("1,2\n" + std::string(field) + ",7\n").substr(0, 60),
              (", line 2: '" + std::string(field) +
               "' for u is negative; vertices are numbered from 0, the first row of points")
                  .substr(0, 60))
        << field;
  for (const char* field : {"4294967295", "4294967296", "18446744073709551617"})
    EXPECT_EQ(refusal_of("1,2\n3," + std::string(field) + "\n"),
              ", line 2: '" + std::string(field) +
                  "' for v is too large; no vertex has a number above 4294967294")
        << field;
  EXPECT_EQ(refusal_of("1,2\n3,4\r5\n"),
            ", line 2: '4?5' for v is no whole number; vertices are numbers of rows");
  EXPECT_EQ(refusal_of("u,v\n1,2\n7,7\n"), ", line 3: both ends are vertex 7; an edge needs two");
  EXPECT_EQ(refusal_of("u,v\n1,2\n,7\n"), ", line 3: no value for u; give both ends");
}

TEST(EdgePairsFile, refuses_rows_of_other_lengths) {
  EXPECT_EQ(refusal_of("5\n6\n"), ", line 1: no value for v; give both ends");
  EXPECT_EQ(refusal_of("1,2\n6\n"), ", line 2: no value for v; give both ends");
  EXPECT_EQ(refusal_of("order,u,v\n1,2\n"), ", line 2: no value for v; give both ends");
  const std::string three =
      ": the row has 3 values, not two; name the columns of the edges' ends u and v on a first "
      "line";
  EXPECT_EQ(refusal_of("1,2,0\n"), ", line 1" + three);
  EXPECT_EQ(refusal_of("1,2\n3,4,0\n"), ", line 2" + three);
  // R writes names of rows, and none above them.
  EXPECT_EQ(refusal_of("\"u\",\"v\"\n\"1\",5,6\n"),
            ", line 2: the row has 3 values and the header 2; correct one of them");
}

TEST(EdgePairsFile, refuses_headers_that_do_not_tell) {
  EXPECT_EQ(refusal_of("id,from,to\n1,2,3\n"),
            ", line 1: no columns u and v, but 'id', 'from', 'to'; name those of the edges' ends u "
            "and v");
  EXPECT_EQ(refusal_of("u\n1\n"),
            ", line 1: no columns u and v, but 'u'; name those of the edges' ends u and v");
  EXPECT_EQ(refusal_of("u,v,u\n1,2,3\n"),
            ", line 1: two columns 'u'; name only the edges' ends u and v");
}

TEST(EdgePairsFile, refuses_files_without_an_edge) {
  EXPECT_EQ(refusal_of(""), " is empty");
  for (const char* text : {"u,v,order\n", "# nothing\n", "\n\n", ",,\n"})
    EXPECT_EQ(refusal_of(text), " holds no edge; a row is its two ends u and v") << text;
  EXPECT_NE(refusal_of(R"({"type": "LineString", "coordinates": []})").find("GeoJSON"),
            std::string::npos);
  EXPECT_THROW(read_edge_pairs("no/such/file.csv"), FileError);
}

}  // namespace
}  // namespace hodt
