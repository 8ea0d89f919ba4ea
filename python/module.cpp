// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The extension behind the Python module delaunay_from_surface, whose docstrings say what it does.
// It needs no other library than Python's: the core needs none.

#include "Unlocked.h"
#include "Copied_points.h"
#include "interruptible.h"
#include "functions.h"
#include "numpy_ranges.h"

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/arrays/arrays_of_built.h>
#include <CGAL/Delaunay_from_surface_3/arrays/arrays_of_periodic.h>
#include <CGAL/Delaunay_from_surface_3/core/build.h>
#include <CGAL/Delaunay_from_surface_3/core/build_periodic.h>
#include <CGAL/Delaunay_from_surface_3/core/build_regular.h>
#include <CGAL/Delaunay_from_surface_3/core/threads/Marks.h>
#include <CGAL/Delaunay_from_surface_3/support/Thread_executor.h>
#include <CGAL/Delaunay_from_surface_3/surface/soup_edges.h>

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

namespace py = pybind11;
namespace core = CGAL::Delaunay_from_surface_3::core;

namespace {

using Arrays = CGAL::Delaunay_3_arrays<std::int32_t>;
using Periodic_arrays = CGAL::Periodic_3_arrays<std::int32_t>;

struct Stopped : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// Keeps the order of the last call. Only one call at a time may use it.
struct Kept
{
  CGAL::Delaunay_from_surface_3::Insertion_order order;
  std::atomic<bool> is_used{false};
  std::atomic<std::size_t> size{0}; // of the order; others may ask while a call changes it
};

class Use_of
{
public:
  explicit Use_of(Kept* kept)
    : m_kept(kept)
  {
    if (m_kept != nullptr && m_kept->is_used.exchange(true))
      throw py::value_error("order: another call uses it");
  }
  Use_of(const Use_of&) = delete;
  Use_of& operator=(const Use_of&) = delete;
  ~Use_of()
  {
    if (m_kept == nullptr)
      return;
    m_kept->size = m_kept->order.order.size();
    m_kept->is_used = false;
  }

private:
  Kept* m_kept;
};

// Returns views of the arrays, which live as long as the owner.
template <class A>
py::tuple views_of(const A* arrays, const py::capsule& owner, bool with_neighbors)
{
  const auto corners = py::ssize_t((std::max)(arrays->dimension(), 0) + 1);
  const auto view = [&](const std::int32_t* data) {
    const auto stride = py::ssize_t(arrays->stride() * sizeof(std::int32_t));
    return py::array_t<std::int32_t>({py::ssize_t(arrays->number_of_cells()), corners},
                                     {stride, py::ssize_t(sizeof(std::int32_t))}, data, owner);
  };
  const py::array_t<std::int32_t> vertices({py::ssize_t(arrays->number_of_points())},
                                           {py::ssize_t(sizeof(std::int32_t))},
                                           arrays->vertices_of_points().data(), owner);
  py::object neighbors = py::none();
  if (with_neighbors)
    neighbors = view(arrays->neighbors_data());
  return py::make_tuple(view(arrays->vertices_data()), neighbors, vertices, arrays->dimension());
}

// Returns views of the arrays, which live as long as one of the views.
py::tuple views_of(Arrays&& moved, bool with_neighbors)
{
  const auto* const arrays = new Arrays(std::move(moved));
  const py::capsule owner(arrays, [](void* p) { delete static_cast<const Arrays*>(p); });
  return views_of(arrays, owner, with_neighbors);
}

// Returns the same, with neighbours, and also the offsets, and whether they are a simplicial complex.
py::tuple views_of_periodic(Periodic_arrays&& moved)
{
  const auto* const arrays = new Periodic_arrays(std::move(moved));
  const py::capsule owner(arrays, [](void* p) { delete static_cast<const Periodic_arrays*>(p); });
  const py::ssize_t corners = arrays->dimension() < 0 ? 1 : 4;
  const py::array_t<std::int16_t> offsets(
      {py::ssize_t(arrays->number_of_cells()), corners, py::ssize_t(3)}, arrays->offsets_data(),
      owner);
  return py::make_tuple(views_of(arrays, owner, true), offsets, arrays->is_simplicial_complex());
}

// Returns the finite cells that the core makes of the points, if it was not stopped.
template <class Points>
Arrays arrays_of(Points& points, CGAL::Delaunay_from_surface_3::Insertion_order* kept,
                 unsigned int seed, core::Observer& observer, const core::Executor& executor)
{
  python::refuse_obstacle();
  core::Build_options options;
  options.seed = seed;
  options.adds_apex = true;
  const auto built = kept == nullptr
                         ? core::build(points, options, observer, executor)
                         : core::build_again(*kept, points, options, observer, executor);
  // Points on a line are sorted at once.
  if (built->outcome == core::Insertion_outcome::FLAT && points.points().size() > 0 &&
      !observer.go_further(0))
    return Arrays();
  return core::arrays_of_built<std::int32_t>(*built, points, executor, false);
}

// Refuses faces with indices that are not those of n points. The faces have no other use.
void check_faces(const py::object& faces, std::size_t n)
{
  if (!faces.is_none())
    python::with_faces(faces, [&](const auto& rows) {
      const python::Unlocked unlocked;
      CGAL::Delaunay_from_surface_3::internal::check_faces(rows, n);
    });
}

// Returns what make(observer, executor) does, unlocked, for n points.
template <class Make>
auto made(std::size_t n, const py::object& progress, std::size_t threads, const Make& make)
{
  const core::Rounding_to_nearest rounding;
  const core::Thread_executor executor((std::min)(threads, std::size_t(core::Marks::most_workers)));
  python::Interruptible_observer observer(n, progress, rounding);
  decltype(make(observer, executor)) arrays;
  try {
    const python::Unlocked unlocked;
    arrays = make(observer, executor);
  } catch (const CGAL::Delaunay_from_surface_3::Too_many_cells& error) {
    PyErr_SetString(PyExc_OverflowError, error.what());
    throw py::error_already_set();
  }
  observer.finish();
  if (observer.is_stopped())
    throw Stopped("progress returned False");
  return arrays;
}

template <class Points>
py::tuple triangulated(Points& points, const py::object& faces, bool neighbors, unsigned int seed,
                       const py::object& progress, std::size_t threads, Kept* kept)
{
  const Use_of use(kept);
  check_faces(faces, points.size());
  Arrays arrays = made(points.size(), progress, threads, [&](auto& observer, const auto& executor) {
    Arrays made =
        arrays_of(points, kept == nullptr ? nullptr : &kept->order, seed, observer, executor);
    if (!neighbors)
      made.drop_neighbors();
    return made;
  });
  return views_of(std::move(arrays), neighbors);
}

template <class Points>
py::tuple triangulated_in_box(Points& points, const std::array<double, 3>& box, unsigned int seed,
                              const py::object& progress, std::size_t threads)
{
  python::refuse_obstacle();
  core::Build_options options;
  options.seed = seed;
  return views_of_periodic(
      made(points.size(), progress, threads, [&](auto& observer, const auto& executor) {
        core::Built_in_box built = core::build_in_box(points.points(), weights_of(points),
                                                      box.data(), options, observer, executor);
        return core::arrays_of_box<std::int32_t>(built, points.points(), box);
      }));
}

// Calls make(points), of a class with weights if there are any.
template <class Make>
py::tuple with_points(const py::array& array, const py::object& weights, const Make& make)
{
  try {
    if (weights.is_none()) {
      python::Copied_points points(array);
      return make(points);
    }
    python::Copied_weighted_points points(array, weights.cast<py::array_t<double>>());
    return make(points);
  } catch (const std::bad_alloc&) {
    const std::string message =
        "there is not enough memory to triangulate " + std::to_string(array.shape(0)) + " points";
    PyErr_SetString(PyExc_MemoryError, message.c_str());
    throw py::error_already_set();
  }
}

py::tuple delaunay3(const py::array& array, const py::object& faces, bool neighbors,
                    unsigned int seed, const py::object& progress, std::size_t threads, Kept* kept,
                    const py::object& weights)
{
  return with_points(array, weights, [&](auto& points) {
    return triangulated(points, faces, neighbors, seed, progress, threads, kept);
  });
}

py::tuple periodic3(const py::array& array, const std::array<double, 3>& box, unsigned int seed,
                    const py::object& progress, std::size_t threads, const py::object& weights)
{
  return with_points(array, weights, [&](auto& points) {
    return triangulated_in_box(points, box, seed, progress, threads);
  });
}

} // namespace

// Calls share nothing here: without an interpreter's lock they are as safe as with one.
#if PYBIND11_VERSION_HEX >= 0x020d0000
PYBIND11_MODULE(_delaunay_from_surface, m, py::mod_gil_not_used())
#else
PYBIND11_MODULE(_delaunay_from_surface, m)
#endif
{
  py::register_exception<Stopped>(m, "Stopped").attr("__doc__") =
      "Raised when progress returns False, by delaunay3() and delaunay3_tiles().";
  m.attr("__version__") = DELAUNAY_FROM_SURFACE_3_VERSION;
  py::class_<Kept>(
      m, "InsertionOrder",
      "The order of insertion of the last call of delaunay3() that it was given to; of "
      "nothing at first.")
      .def(py::init<>())
      .def("__len__", [](const Kept& kept) { return kept.size.load(); })
      .def("__repr__", [](const Kept& kept) {
        return "<InsertionOrder of " + std::to_string(kept.size) + " points>";
      });
  for (const char* const name : {"Stopped", "InsertionOrder"})
    m.attr(name).attr("__module__") = "delaunay_from_surface"; // they are found there
  m.def("delaunay3", &delaunay3);
  m.def("periodic3", &periodic3);
  python::define_surface_functions(m);
  python::define_queries(m);
  python::define_cells(m);
  python::define_inside(m);
  python::define_interpolation(m);
  python::define_tiles(m);
  python::define_filtration(m);
  python::define_learning(m);
}
