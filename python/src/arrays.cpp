#include "arrays.h"

#include "hodt/base/parallel.h"
#include "hodt/delaunay/spatial_order.h"

namespace hodt::python {

namespace {

constexpr std::size_t kGrain = 1 << 15;

/// The address of an element, by the array's strides.
class Elements {
 public:
  explicit Elements(const DoubleArray& array)
      : data_(array.data()), row_(array.stride(0)), column_(array.stride(1)) {}
  double operator()(std::size_t row, int column) const {
    return data_[std::int64_t(row) * row_ + column * column_];
  }

 private:
  const double* data_;
  std::int64_t row_, column_;
};

}  // namespace

InputPoints::InputPoints(const DoubleArray& array) {
  const std::size_t n = array.shape(0);
  const bool has_heights = array.shape(1) == 3;
  if (!has_heights && (n <= 1 || array.stride(0) == 2) && array.stride(1) == 1) {
    view_ = {rows_of<Point>(array), {}};
    return;
  }
  if (n > kMaxPoints) {  // refused before they are copied
    view_ = {{rows_of<Point>(array).data(), n}, {}};
    return;
  }
  const Elements at(array);
  copied_.xy.resize(n);
  if (has_heights) copied_.z.resize(n);
  parallel_for(0, n, kGrain, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      copied_.xy[i] = {at(i, 0), at(i, 1)};
      if (has_heights) copied_.z[i] = at(i, 2);
    }
  });
  view_ = copied_;
}

PointSet InputPoints::set() && {
  if (copied_.xy.size() == view_.size()) return std::move(copied_);
  return {copy_of(view_.xy), copy_of(view_.z)};
}

nb::object places(std::vector<Point> points) {
  const std::size_t size = points.size();
  return owned<double>(std::move(points), {size, 2});
}

nb::object doubles(std::vector<double> values) {
  const std::size_t size = values.size();
  return owned<double>(std::move(values), {size});
}

nb::tuple tin_arrays(Tin tin) {
  nb::object z = nb::none();
  if (tin.points.has_heights()) z = doubles(std::move(tin.points.z));
  return nb::make_tuple(places(std::move(tin.points.xy)), z, integers(std::move(tin.triangles), 3));
}

Tin tin_of(const PlaceArray& xy, const std::optional<HeightArray>& z,
           const IntegerArray& triangles) {
  Tin tin;
  tin.points.xy = copy_of(rows_of<Point>(xy));
  if (z) tin.points.z.assign(z->data(), z->data() + z->shape(0));
  tin.triangles = copy_of(rows_of<std::array<Index, 3>>(triangles));
  return tin;
}

}  // namespace hodt::python
