// Between numpy's arrays and the library's: without a copy where the layout allows it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include "hodt/base/ids.h"
#include "hodt/geometry/point_set.h"
#include "hodt/tin/tin.h"

namespace hodt::python {

namespace nb = nanobind;

/// Of any strides; the Python side makes numbers of other kinds doubles.
using DoubleArray = nb::ndarray<const double, nb::ndim<2>, nb::device::cpu>;
/// Rows of an array that is contiguous.
using IntegerArray = nb::ndarray<const std::int32_t, nb::ndim<2>, nb::c_contig, nb::device::cpu>;
using PlaceArray = nb::ndarray<const double, nb::shape<-1, 2>, nb::c_contig, nb::device::cpu>;
using HeightArray = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

/// Points of an array with two or three columns, as a view of the array itself if it is (n, 2) and
/// contiguous. The array must stay.
class InputPoints {
 public:
  explicit InputPoints(const DoubleArray& array);
  PointView view() const { return view_; }
  /// A copy of what is not copied already.
  PointSet set() &&;

 private:
  PointView view_;
  PointSet copied_;
};

/// The rows of an array as elements of type T.
template <class T, class Array>
std::span<const T> rows_of(const Array& array) {
  return {reinterpret_cast<const T*>(array.data()), array.shape(0)};
}
template <class T>
std::vector<T> copy_of(std::span<const T> elements) {
  return {elements.begin(), elements.end()};
}

using Triangles = std::vector<std::array<Index, 3>>;

/// A numpy array with memory that `owner`, a vector or a Buffer, holds: it moves into the array.
template <class Scalar, class Owner>
nb::object owned(Owner owner, std::initializer_list<std::size_t> shape) {
  auto* const kept = new Owner(std::move(owner));
  const nb::capsule capsule(kept, [](void* p) noexcept { delete static_cast<Owner*>(p); });
  auto* const data = reinterpret_cast<Scalar*>(kept->data());
  return nb::cast(nb::ndarray<nb::numpy, Scalar>(data, shape.size(), shape.begin(), capsule));
}
/// Of records of `columns` numbers without sign, as int32.
template <class Owner>
nb::object integers(Owner owner, std::size_t columns) {
  const std::size_t rows = owner.size() * sizeof(*owner.data()) / (sizeof(Index) * columns);
  return owned<std::int32_t>(std::move(owner), {rows, columns});
}
template <class Owner>
nb::object integers(Owner owner) {
  const std::size_t size = owner.size();
  return owned<std::int32_t>(std::move(owner), {size});
}
nb::object places(std::vector<Point> points);
nb::object doubles(std::vector<double> values);

/// (xy, z or None, triangles) of a mesh, and back. What comes from Python has been looked at there:
/// every corner is a vertex.
nb::tuple tin_arrays(Tin tin);
Tin tin_of(const PlaceArray& xy, const std::optional<HeightArray>& z,
           const IntegerArray& triangles);

}  // namespace hodt::python
