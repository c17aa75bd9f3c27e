// The figures of docs/definitions.md, each a whole SVG document.
// Tested by tests/CMakeLists.txt.
#pragma once

#include <string>

namespace gallery {

std::string triangulation_orders();  ///< order 0, 1 and 2 of the same points
std::string kod_edges();             ///< Figure 2
std::string edge_order();            ///< the circle that counts; all edges at one vertex
std::string order_of_triangles();    ///< Figure 3
std::string useful_edge();           ///< Lemma 4 (Figure 4a)
std::string hull();                  ///< Figures 4b and 5
std::string crossing_edges();        ///< Figure 8
std::string fixed_edges();
std::string voronoi();            ///< Lemma 2
std::string artificial_dam();     ///< Figure 1
std::string extrema_cycle();      ///< Figure 7
std::string conflict_graph();     ///< Theorem 8
std::string constrained_order();  ///< what counts beside a breakline
std::string breaklines();

}  // namespace gallery
