// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_NUMPY_RANGES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_NUMPY_RANGES_H

// Reads Python's objects as ranges: NumPy's arrays of usual types are read in place.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace python {

namespace py = pybind11;

// The range of item(0), …, item(n - 1).
template <class Item>
class Indexed_range
{
  using Value = std::decay_t<decltype(std::declval<const Item&>()(std::size_t()))>;

public:
  class iterator
  {
  public:
    using iterator_category = std::random_access_iterator_tag;
    using value_type = Value;
    using difference_type = std::ptrdiff_t;
    using pointer = const Value*;
    using reference = Value;

    iterator() = default;
    iterator(const Item& item, std::size_t i)
      : m_item(&item)
      , m_i(i)
    {
    }

    Value operator*() const { return (*m_item)(m_i); }
    Value operator[](std::ptrdiff_t d) const { return *(*this + d); }
    iterator& operator+=(std::ptrdiff_t d)
    {
      m_i += std::size_t(d);
      return *this;
    }
    iterator& operator-=(std::ptrdiff_t d) { return *this += -d; }
    iterator& operator++() { return *this += 1; }
    iterator& operator--() { return *this += -1; }
    iterator operator++(int) { return std::exchange(*this, *this + 1); }
    iterator operator--(int) { return std::exchange(*this, *this + -1); }

    friend iterator operator+(iterator it, std::ptrdiff_t d) { return it += d; }
    friend iterator operator+(std::ptrdiff_t d, iterator it) { return it += d; }
    friend iterator operator-(iterator it, std::ptrdiff_t d) { return it -= d; }
    friend std::ptrdiff_t operator-(const iterator& a, const iterator& b)
    {
      return std::ptrdiff_t(a.m_i) - std::ptrdiff_t(b.m_i);
    }
    friend bool operator==(const iterator& a, const iterator& b) { return a.m_i == b.m_i; }
    friend bool operator!=(const iterator& a, const iterator& b) { return a.m_i != b.m_i; }
    friend bool operator<(const iterator& a, const iterator& b) { return a.m_i < b.m_i; }
    friend bool operator>(const iterator& a, const iterator& b) { return b < a; }
    friend bool operator<=(const iterator& a, const iterator& b) { return !(b < a); }
    friend bool operator>=(const iterator& a, const iterator& b) { return !(a < b); }

  private:
    const Item* m_item = nullptr;
    std::size_t m_i = 0;
  };
  using const_iterator = iterator;

  Indexed_range(std::size_t n, Item item)
    : m_size(n)
    , m_item(std::move(item))
  {
  }
  iterator begin() const { return iterator(m_item, 0); }
  iterator end() const { return iterator(m_item, m_size); }
  std::size_t size() const { return m_size; }

private:
  std::size_t m_size;
  Item m_item;
};

// A matrix of any strides with entries of type Wide or Narrow.
template <class Wide, class Narrow>
class Matrix_view
{
public:
  // Views the rows from `first` on.
  explicit Matrix_view(const py::array& array, std::size_t first = 0)
    : m_data(static_cast<const char*>(array.data()) + std::ptrdiff_t(first) * array.strides(0))
    , m_row_stride(array.strides(0))
    , m_column_stride(array.strides(1))
    , m_is_wide(array.itemsize() == sizeof(Wide))
  {
  }

  Wide operator()(std::size_t row, std::size_t column) const
  {
    const char* const entry =
        m_data + std::ptrdiff_t(row) * m_row_stride + std::ptrdiff_t(column) * m_column_stride;
    return m_is_wide ? read<Wide>(entry) : Wide(read<Narrow>(entry));
  }

private:
  template <class Entry>
  static Entry read(const char* place) // the place need not be aligned
  {
    Entry entry;
    std::memcpy(&entry, place, sizeof(entry));
    return entry;
  }

  const char* m_data;
  std::ptrdiff_t m_row_stride, m_column_stride;
  bool m_is_wide;
};

inline std::string shape_of(const py::array& array)
{
  return std::string(py::str(array.attr("shape")));
}

// Refuses masked arrays, and lists with such rows: NumPy would hand over entries under the mask.
inline void refuse_mask(const std::string& name, const py::object& object)
{
  const py::object masked_array = py::module_::import("numpy.ma").attr("MaskedArray");
  bool is_masked = py::isinstance(object, masked_array);
  if (py::isinstance<py::list>(object) || py::isinstance<py::tuple>(object))
    for (const py::handle row : object)
      is_masked = is_masked || py::isinstance(row, masked_array);
  if (is_masked)
    throw py::value_error(name + ": a masked array is not read; leave out what is masked");
}

inline bool is_tensor(const py::object& object)
{
  return py::hasattr(object, "detach") && py::hasattr(object, "cpu");
}

// Returns what lies in the host's memory. A tensor of PyTorch that requires a gradient or is on a
// device, and an array of CuPy, do not let NumPy read them: the values are taken, and copied where
// they are not in this memory. The object itself is returned if it is no such thing.
inline py::object on_host(const py::object& object)
{
  if (is_tensor(object))
    return object.attr("detach")().attr("cpu")();
  if (py::hasattr(object, "__cuda_array_interface__") && py::hasattr(object, "get"))
    return object.attr("get")();
  return object;
}

// Returns what NumPy makes of an object on the host. An object that can be read only once is put
// into a list first, and one that has only the protocol of DLPack is read by that.
inline py::object array_or_alike(const py::object& object)
{
  if (is_tensor(object))
    return object.attr("numpy")();
  const py::module_ numpy = py::module_::import("numpy");
  if (py::isinstance<py::iterator>(object))
    return numpy.attr("asanyarray")(py::list(object));
  if (py::hasattr(object, "__dlpack__") && !py::hasattr(object, "__array__") &&
      py::hasattr(numpy, "from_dlpack"))
    return numpy.attr("from_dlpack")(object);
  const py::object array = numpy.attr("asanyarray")(object);
  if (array.attr("dtype").attr("names").is_none())
    return array;
  // Records, such as those of fields x, y and z.
  return py::module_::import("numpy.lib.recfunctions").attr("structured_to_unstructured")(array);
}

// Returns the same as an array; if there is none, the exception has the reason as its cause. What a
// device reports is passed on as it is.
inline py::array array_from_any(const std::string& name, const py::object& given,
                                const std::string& what)
{
  const py::object object = on_host(given);
  try {
    return py::array(array_or_alike(object));
  } catch (py::error_already_set& error) {
    if (!error.matches(PyExc_TypeError) && !error.matches(PyExc_ValueError) &&
        !error.matches(PyExc_RuntimeError) && !error.matches(PyExc_BufferError))
      throw;
    py::raise_from(error, PyExc_TypeError, (name + ": expected an array of " + what).c_str());
    throw py::error_already_set();
  }
}

// Returns an array of kinds[0] with entries of 4 or 8 bytes; others of `kinds` are converted.
inline py::array array_of(const std::string& name, const py::object& object,
                          const std::string& kinds, const std::string& what, const char* converted)
{
  const py::array array = array_from_any(name, object, what);
  const char kind = array.dtype().kind();
  if (kinds.find(kind) == std::string::npos)
    throw py::type_error(name + ": expected " + what + ", got entries of type " +
                         std::string(py::str(array.dtype())));
  const bool is_native = array.dtype().attr("isnative").cast<bool>();
  const bool is_usual =
      kind == kinds[0] && is_native && (array.itemsize() == 4 || array.itemsize() == 8);
  return is_usual ? array : py::array(array.attr("astype")(converted));
}

// Returns an array of shape (n, 3); an empty sequence stands for no points.
inline py::array array_of_points(const py::object& object, const std::string& name = "points")
{
  refuse_mask(name, object);
  const py::array array = array_of(name, object, "fiu", "numbers", "float64");
  if (array.ndim() == 1 && array.size() == 0)
    return py::array(array.attr("reshape")(0, 3));
  if (array.ndim() != 2 || array.shape(1) != 3)
    throw py::value_error(name + ": expected an array of shape (n, 3), got " + shape_of(array));
  return array;
}

// The points of such an array.
using Points_view = Matrix_view<double, float>;

// Copies their coordinates one after the other, as doubles, and refuses those that are not finite.
// The first point has number `first`.
template <class Vector>
void copy_points(const Points_view& view, std::size_t n, const char* name, Vector& coordinates,
                 std::size_t first = 0)
{
  coordinates.resize(3 * n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const double x = view(i, c);
      if (!std::isfinite(x))
        throw py::value_error(std::string(name) + " " + std::to_string(first + i) + ": its " +
                              "xyz"[c] + " coordinate is not a finite number");
      coordinates[3 * i + c] = x;
    }
}

// Returns the weights of n points, or of any number, as a contiguous array of doubles, and refuses
// those that are not finite.
inline py::array_t<double> array_of_weights(const py::object& object, std::optional<std::size_t> n)
{
  refuse_mask("weights", object);
  const py::array array = array_of("weights", object, "fiu", "numbers", "float64");
  if (array.ndim() != 1 || (n.has_value() && std::size_t(array.shape(0)) != *n))
    throw py::value_error("weights: expected an array of shape (" +
                          (n.has_value() ? std::to_string(*n) : "n") +
                          ",), one for each point, got " + shape_of(array));
  const py::array_t<double> weights(py::array(array.attr("astype")("float64", "C"))); // a copy
  for (std::size_t i = 0; i < std::size_t(weights.size()); ++i)
    if (!std::isfinite(weights.data()[i]))
      throw py::value_error("weights: that of point " + std::to_string(i) +
                            " is not a finite number");
  return weights;
}

// Refuses indices that were at least 2^63 before they were converted.
template <class View>
void refuse_wrapped(const View& view, std::size_t rows, std::size_t columns)
{
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < columns; ++j)
      if (view(i, j) < 0)
        throw py::value_error("faces: face " + std::to_string(i) + ": the index " +
                              std::to_string(std::uint64_t(view(i, j))) + " is too large");
}

// Reads faces as VTK has them in one array, where each face's number of indices precedes these.
inline std::vector<std::vector<std::int64_t>> faces_of_vtk(const py::array& array)
{
  const auto n = std::size_t(array.shape(0));
  const py::array row = py::array(array.attr("reshape")(1, -1).attr("copy")("C"));
  const Matrix_view<std::int64_t, std::int32_t> view(row);
  std::vector<std::vector<std::int64_t>> faces;
  for (std::size_t i = 0; i < n;) {
    const std::int64_t size = view(0, i);
    if (size < 1 || std::uint64_t(size) >= n - i)
      throw py::value_error("faces: expected an array of shape (m, k), got " + shape_of(array) +
                            "; nor is it one of VTK's, with the number of indices before those of "
                            "each face: face " +
                            std::to_string(faces.size()) + " would have " + std::to_string(size));
    faces.emplace_back();
    for (++i; faces.back().size() < std::size_t(size); ++i)
      faces.back().push_back(view(0, i));
  }
  return faces;
}

// Returns whether an object is an array, or is read as one.
inline bool is_array_alike(const py::object& object)
{
  for (const char* const name : {"__array__", "__array_interface__", "__dlpack__", "detach"})
    if (py::hasattr(object, name))
      return true;
  return py::isinstance<py::memoryview>(object);
}

// Calls f(faces) with a range of ranges of indices.
template <class F>
auto with_faces(const py::object& object, const F& f)
{
  refuse_mask("faces", object);
  if (is_array_alike(object)) {
    const py::array array = array_of("faces", object, "iu", "integers", "int64");
    if (array.ndim() == 1)
      return f(faces_of_vtk(array));
    if (array.ndim() != 2)
      throw py::value_error("faces: expected an array of shape (m, k), got " + shape_of(array));
    // The array is copied, so that nothing is read that another thread writes meanwhile.
    const py::array rows = py::array(array.attr("copy")("C"));
    const Matrix_view<std::int64_t, std::int32_t> view(rows);
    const auto n = std::size_t(array.shape(0)), k = std::size_t(array.shape(1));
    if (array_from_any("faces", object, "integers").dtype().kind() == 'u')
      refuse_wrapped(view, n, k);
    return f(Indexed_range(n, [=](std::size_t row) {
      return Indexed_range(k, [=](std::size_t column) { return view(row, column); });
    }));
  }
  std::vector<std::vector<std::int64_t>> faces;
  try {
    for (const py::handle face : object) {
      faces.emplace_back();
      for (const py::handle index : face)
        faces.back().push_back(
            py::int_(py::reinterpret_borrow<py::object>(index.attr("__index__")()))
                .cast<std::int64_t>());
    }
  } catch (const py::error_already_set& error) {
    if (!error.matches(PyExc_TypeError) && !error.matches(PyExc_AttributeError))
      throw; // it is the caller's own
    throw py::type_error("faces: face " + std::to_string(faces.empty() ? 0 : faces.size() - 1) +
                         ": expected sequences of integers");
  } catch (const py::cast_error&) {
    throw py::value_error("faces: face " + std::to_string(faces.size() - 1) +
                          ": an index is too large");
  }
  return f(faces);
}

} // namespace python

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PYTHON_NUMPY_RANGES_H
