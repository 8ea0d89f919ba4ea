// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_NUMPY_ROWS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_NUMPY_ROWS_H

// The arrays of a result: points and simplices are read in place, and new arrays are made.

#include "numpy_ranges.h"

#include <CGAL/Delaunay_from_surface_3/support/Executor.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace python {

using Index = std::int32_t;
using Numbers = py::array_t<Index>;
using Points = py::array; // of shape (n, 3), float64 or float32

// Returns the coordinates of a point, which are read in place.
struct Point_of
{
  Points_view view;

  std::array<double, 3> operator()(std::size_t i) const
  {
    return {view(i, 0), view(i, 1), view(i, 2)};
  }
};

// A matrix of numbers whose rows are contiguous, as the module makes them; others are copied.
class Rows
{
public:
  explicit Rows(const Numbers& numbers)
    : m_numbers(has_rows(numbers) ? numbers
                                  : Numbers(py::array_t<Index, py::array::c_style>(numbers)))
  {
  }

  const Index* data() const { return m_numbers.data(); }
  std::size_t size() const { return std::size_t(m_numbers.shape(0)); }
  std::size_t corners() const { return std::size_t(m_numbers.shape(1)); }
  std::size_t stride() const
  {
    return size() < 2 ? corners() : std::size_t(m_numbers.strides(0)) / sizeof(Index);
  }

  Index entry(std::size_t i, std::size_t k) const { return m_data[i * m_stride + k]; }

  // Returns the same, but throws if it is not one of 0, …, n-1.
  Index number(std::size_t i, std::size_t k, std::size_t n) const
  {
    const Index v = entry(i, k);
    if (v < 0 || std::size_t(v) >= n)
      throw std::out_of_range("simplices: " + std::to_string(v) + " is not one of the " +
                              std::to_string(n) + " points");
    return v;
  }

private:
  static bool has_rows(const Numbers& numbers)
  {
    if (numbers.ndim() != 2)
      throw py::value_error("simplices: expected an array of shape (m, d + 1)");
    const py::ssize_t size = sizeof(Index), row = numbers.strides(0);
    return numbers.strides(1) == size && row >= size * numbers.shape(1) && row % size == 0;
  }

  Numbers m_numbers;
  const Index* m_data = m_numbers.data();
  std::size_t m_stride = stride();
};

// Returns a new array, which takes the contents of the vector.
template <class T>
py::array_t<T> array_from(std::vector<T>&& vector, std::vector<py::ssize_t> shape)
{
  auto owned = std::make_unique<std::vector<T>>(std::move(vector));
  const T* const data = owned->data();
  const py::capsule owner(owned.get(), [](void* p) { delete static_cast<std::vector<T>*>(p); });
  owned.release();
  return py::array_t<T>(std::move(shape), data, owner);
}

// Copies numbers from 0 to n-1, so that nothing is read that another thread writes meanwhile.
inline std::vector<Index> checked_copy(const Rows& rows, std::size_t n)
{
  std::vector<Index> copy;
  copy.reserve(rows.corners() * rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t k = 0; k < rows.corners(); ++k)
      copy.push_back(rows.number(i, k, n));
  return copy;
}

// Renumbers points 0, …, n-1 in the order in which they are met as corners, and the rest after
// them, so that points that are near in space are near in memory. Negative numbers stay. Returns
// the old numbers.
inline std::vector<Index>
number_as_met(Index* corners, std::size_t number_of_corners, std::size_t n,
              const CGAL::Delaunay_from_surface_3::core::Executor& executor)
{
  CGAL::Delaunay_from_surface_3::core::Steps step(executor);
  std::vector<Index> number_of(n, -1), met;
  met.reserve(n);
  const auto number = [&](Index v) {
    if (number_of[std::size_t(v)] < 0) {
      number_of[std::size_t(v)] = Index(met.size());
      met.push_back(v);
    }
    return number_of[std::size_t(v)];
  };
  for (std::size_t i = 0; i < number_of_corners; ++i, step())
    corners[i] = corners[i] < 0 ? corners[i] : number(corners[i]);
  for (std::size_t i = 0; i < n; ++i)
    number(Index(i));
  return met;
}

} // namespace python

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_NUMPY_ROWS_H
