// As many targets as possible served by edges that do not exclude each other.
#pragma once

#include <cstddef>
#include <vector>

#include "hodt/base/csr_lists.h"
#include "hodt/base/deadline.h"

namespace hodt {

struct SelectionProblem {
  CsrLists edges_of;          ///< the edges that serve a target, each of them one at least
  CsrLists targets_of;        ///< the same by edges
  CsrLists rivals;            ///< the edges that an edge excludes
  std::vector<Index> orders;  ///< of edges: the smaller the better, between equals
};

struct Selection {
  std::vector<Index> edges;  ///< chosen, ascending: no two are rivals
  /// Parts of the targets that cannot all be served.
  struct Part {
    std::vector<Index> targets;
    std::size_t unserved;  ///< at least, in any selection
  };
  std::vector<Part> contested;
};

/// Where some edge of a target has no rivals left, it is taken; where all that an edge excludes is
/// excluded by another edge of the target too, the other goes. What is left falls apart into parts,
/// each a program in zeros and ones: a variable for each edge and for each target that goes
/// without. A program's work is its variables and pairs of rivals: all programs of a part together
/// are allowed `most_work`, and each a quarter of what is left. On parts where that ends the
/// search, the selection may not be the best, and `unserved` not be reached. Throws TimeIsUp if the
/// deadline passes before there is any selection.
Selection select_edges(const SelectionProblem& problem, const Deadline& deadline,
                       std::size_t most_work);

}  // namespace hodt
