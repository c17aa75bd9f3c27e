// Edges as pairs of vertices, such as `hodt edges` lists.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "hodt/base/ids.h"
#include "hodt/io/input_text.h"

namespace hodt {

struct EdgePairs {
  /// The two ends of each edge, which differ: data rows of the points, from 0. Whether there are as
  /// many rows is for the caller to check.
  std::vector<std::array<Index, 2>> edges;
  std::vector<std::size_t> lines;  ///< of the file, of each edge
  std::string source;              ///< what messages call the file

  /// Where an edge comes from, for messages: "edges.csv, line 3".
  std::string place(std::size_t edge) const;
};

/// Reads a table of edges, at least one (docs/lines.md says how it may look); "-" is standard
/// input. Throws FileError if the file cannot be read, InputError, naming the line, if it cannot be
/// used.
EdgePairs read_edge_pairs(const std::filesystem::path& path);

/// The same in memory.
EdgePairs parse_edge_pairs(InputText input);

}  // namespace hodt
