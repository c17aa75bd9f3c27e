// What there is to know of a mesh, from the mesh alone.
// Tested by tests/app/command_test.cpp.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "hodt/base/ids.h"
#include "hodt/order/mesh_order.h"
#include "hodt/tin/embedding.h"
#include "hodt/tin/extrema.h"
#include "hodt/tin/quality.h"
#include "hodt/tin/tin.h"

namespace hodt {

/// Order and quality are known of embedded meshes only, extrema only of those with heights.
struct MeshFindings {
  Embedding embedding;
  std::optional<MeshOrder> order;
  std::optional<Quality> quality;
  std::optional<ExtremaCount> extrema;
};

/// Counts no point beyond the walls, which are edges between vertices, nor beyond the mesh's own
/// border.
MeshFindings examine_mesh(Tin tin, std::vector<std::array<Index, 2>> walls = {});

}  // namespace hodt
