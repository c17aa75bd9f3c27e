// Measures of one's own: functions of numpy arrays, asked for many triangles at a time.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include <nanobind/nanobind.h>

#include "hodt/base/ids.h"
#include "hodt/geometry/point_set.h"
#include "hodt/optimize/objective.h"

namespace hodt::python {

namespace nb = nanobind;

/// The objective that a name or a hodt.Measure stands for, or the objectives that names do. The
/// library asks measures for one triangle at a time, and Python answers for a million in no more
/// than some thousand times that. So prepare() asks for all triangles that a triangulation of the
/// order can have, and keeps the answers; any other question goes to Python by itself. Edges are
/// asked for as the search comes to them, and their answers are kept likewise.
class OwnMeasure {
 public:
  explicit OwnMeasure(nb::handle objective);
  ~OwnMeasure();
  OwnMeasure(const OwnMeasure&) = delete;
  OwnMeasure& operator=(const OwnMeasure&) = delete;

  const Objective& objective() const { return objective_; }
  /// Those after the first.
  const std::vector<Objective>& then() const { return then_; }
  /// Without Python's lock. The points must stay. Throws ParameterError if Python's answer is none.
  void prepare(const PointSet& points, Index order) const;

 private:
  class Answers;
  class EdgeAnswers;

  nb::object function_;  // the measure's, which may get another one meanwhile
  Objective objective_;
  std::vector<Objective> then_;
  OwnTriangleMeasure triangle_measure_;
  OwnEdgeMeasure edge_measure_;
  std::unique_ptr<Answers> answers_;           // of a measure of triangles
  std::unique_ptr<EdgeAnswers> edge_answers_;  // of one across edges
};

}  // namespace hodt::python
