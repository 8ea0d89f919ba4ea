// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The C interface of the core. scripts/amalgamate joins this and all that it includes into one
// file, in which it writes DELAUNAY_3_THROW, _TRY and _CATCH for C++'s words: so it also compiles
// with -fno-exceptions. With DELAUNAY_3_ONE_THREAD defined it uses no threads.

#include "delaunay_3.h"

#if defined(__cpp_exceptions) || defined(_CPPUNWIND)
#define DELAUNAY_3_THROW(...) throw __VA_ARGS__
#define DELAUNAY_3_TRY try
#define DELAUNAY_3_CATCH(...) catch (__VA_ARGS__)
#else
template <class Error>
[[noreturn]] void delaunay_3_end_call(const Error& error);
#define DELAUNAY_3_NO_EXCEPTIONS
#ifndef DELAUNAY_3_ONE_THREAD
#define DELAUNAY_3_ONE_THREAD // a call that ends early would leave its threads behind, too
#endif
#define DELAUNAY_3_THROW(...) delaunay_3_end_call(__VA_ARGS__)
#define DELAUNAY_3_TRY
#define DELAUNAY_3_CATCH(...) if (false)
#endif

#include <CGAL/Delaunay_from_surface_3/Delaunay_validity_level.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/arrays/Find_in_box.h>
#include <CGAL/Delaunay_from_surface_3/arrays/Find_simplex.h>
#include <CGAL/Delaunay_from_surface_3/arrays/arrays_of_built.h>
#include <CGAL/Delaunay_from_surface_3/arrays/arrays_of_periodic.h>
#include <CGAL/Delaunay_from_surface_3/arrays/is_valid_arrays.h>
#include <CGAL/Delaunay_from_surface_3/core/build.h>
#include <CGAL/Delaunay_from_surface_3/core/build_periodic.h>
#include <CGAL/Delaunay_from_surface_3/core/build_regular.h>
#include <CGAL/Delaunay_from_surface_3/inside/find_inside.h>
#include <CGAL/Delaunay_from_surface_3/support/Point_array.h>
#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>

#ifndef DELAUNAY_3_ONE_THREAD
#include <CGAL/Delaunay_from_surface_3/core/build_by_threads.h>
#include <CGAL/Delaunay_from_surface_3/core/threads/Marks.h>
#include <CGAL/Delaunay_from_surface_3/support/Thread_executor.h>
#endif

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#if defined(DELAUNAY_3_NO_EXCEPTIONS) && !defined(__wasm__)
#include <csetjmp>
#endif

namespace core = CGAL::Delaunay_from_surface_3::core;

namespace {

using Arrays = CGAL::Delaunay_3_arrays<std::int32_t>;
using Periodic_arrays = CGAL::Periodic_3_arrays<std::int32_t>;
using Box = std::array<double, 3>;

} // namespace

struct delaunay_3
{
  core::Point_array points;
  const double* weights; // null without
  Arrays arrays;         // unless it is periodic
  bool is_periodic = false;
  Box box = {};
  Periodic_arrays in_box = {};
};

namespace {

// The reason why a call ends early.
struct Refusal
{
  delaunay_3_status status;
  std::size_t where;
};

#ifndef DELAUNAY_3_NO_EXCEPTIONS

// Calls f, and returns the status with which it ended; `of_input` if the core refuses what it is given.
template <class F>
delaunay_3_status status_of(std::size_t* where, const F& f,
                            delaunay_3_status of_input = DELAUNAY_3_BAD_BOX)
{
  try {
    const core::Rounding_to_nearest rounding;
    if (core::obstacle_of_core() != nullptr)
      return DELAUNAY_3_NOT_EXACT;
    f();
    return DELAUNAY_3_OK;
  } catch (const Refusal& refusal) {
    if (where != nullptr)
      *where = refusal.where;
    return refusal.status;
  } catch (const CGAL::Delaunay_from_surface_3::Too_many_cells&) {
    return DELAUNAY_3_TOO_MANY;
  } catch (const CGAL::Surface_input_error&) {
    return of_input;
  } catch (const std::length_error&) {
    return DELAUNAY_3_BAD_ARGUMENT;
  } catch (const std::invalid_argument&) { // the points have changed
    return DELAUNAY_3_BAD_ARGUMENT;
  } catch (const std::bad_alloc&) {
    return DELAUNAY_3_NO_MEMORY;
  } catch (...) {
    return DELAUNAY_3_FAILED;
  }
}

#else

// Without exceptions the statuses are the same, but a call that ends early leaves its memory behind.

constexpr std::size_t nowhere = std::size_t(-1);

// What it means in this call if the core refuses what it is given.
thread_local delaunay_3_status status_of_input = DELAUNAY_3_BAD_BOX;

Refusal refusal_of(const Refusal& refusal)
{
  return refusal;
}

template <class Error>
Refusal refusal_of(const Error&)
{
  using Too_many_cells = CGAL::Delaunay_from_surface_3::Too_many_cells;
  constexpr bool is_bad_argument = std::is_same<Error, std::length_error>::value ||
                                   std::is_same<Error, std::invalid_argument>::value;
  return {std::is_same<Error, Too_many_cells>::value              ? DELAUNAY_3_TOO_MANY
          : std::is_same<Error, CGAL::Surface_input_error>::value ? status_of_input
          : is_bad_argument                                       ? DELAUNAY_3_BAD_ARGUMENT
          : std::is_same<Error, std::bad_alloc>::value            ? DELAUNAY_3_NO_MEMORY
                                                                  : DELAUNAY_3_FAILED,
          nowhere};
}

#ifdef __wasm__

// The host's function throws, in its language.
extern "C" {
__attribute__((import_module("delaunay_3"), import_name("end_call"), noreturn)) void
delaunay_3_end_call_in_host(int status, std::size_t where);
}

[[noreturn]] void end_call(const Refusal& refusal)
{
  delaunay_3_end_call_in_host(refusal.status, refusal.where);
}

template <class F>
Refusal ending_of(const F& f)
{
  f();
  return {DELAUNAY_3_OK, nowhere};
}

#else

struct Ending
{
  std::jmp_buf jump;
  Refusal refusal;
};
thread_local Ending* ending_of_call = nullptr;

[[noreturn]] void end_call(const Refusal& refusal)
{
  ending_of_call->refusal = refusal;
  std::longjmp(ending_of_call->jump, 1);
}

// Calls f, and returns the reason why it ended early, if it did.
template <class F>
Refusal ending_of(const F& f)
{
  Ending ending = {{}, {DELAUNAY_3_OK, nowhere}};
  Ending* const outer = ending_of_call; // of the call whose function makes this one
  ending_of_call = &ending;
  if (setjmp(ending.jump) == 0)
    f();
  ending_of_call = outer;
  return ending.refusal;
}

#endif

// Is what operator new calls when there is no memory.
[[noreturn]] void end_without_memory()
{
  end_call({DELAUNAY_3_NO_MEMORY, nowhere});
}

template <class F>
delaunay_3_status status_of(std::size_t* where, const F& f,
                            delaunay_3_status of_input = DELAUNAY_3_BAD_BOX)
{
  const core::Rounding_to_nearest rounding;
  const delaunay_3_status outer = status_of_input;
  status_of_input = of_input;
  if (core::obstacle_of_core() != nullptr)
    return DELAUNAY_3_NOT_EXACT;
  const std::new_handler handler = std::set_new_handler(end_without_memory);
  const Refusal refusal = ending_of(f);
  std::set_new_handler(handler);
  status_of_input = outer;
  if (where != nullptr && refusal.where != nowhere)
    *where = refusal.where;
  return refusal.status;
}

#endif

#ifdef DELAUNAY_3_ONE_THREAD

using Threads = core::Alone;

Threads checked_threads(int threads)
{
  if (threads <= 0)
    throw Refusal{DELAUNAY_3_BAD_ARGUMENT, 0};
  return {};
}

#else

using Threads = core::Thread_executor;

std::size_t checked_threads(int threads)
{
  if (threads <= 0)
    throw Refusal{DELAUNAY_3_BAD_ARGUMENT, 0};
  return (std::min)(std::size_t(threads), std::size_t(core::Marks::most_workers));
}

#endif

void refuse_null(const void* array, std::size_t n = 1)
{
  if (array == nullptr && n > 0)
    throw Refusal{DELAUNAY_3_BAD_ARGUMENT, 0};
}

// Checks, before an array with three numbers per entry is read, that so many entries can be
// numbered and can lie in memory.
void check_number(const void* array, std::size_t n)
{
  constexpr std::size_t most_in_memory = std::size_t(-1) / 2 / (3 * sizeof(double));
  if (n >= (std::min)(core::Compact_numbers::max_vertices - 1, most_in_memory))
    throw Refusal{DELAUNAY_3_TOO_MANY, 0};
  refuse_null(array, n);
}

core::Point_array checked_points(const double* points, std::size_t n)
{
  check_number(points, n);
  for (std::size_t i = 0; i < 3 * n; ++i)
    if (!core::is_finite_number(points[i]))
      throw Refusal{DELAUNAY_3_NOT_FINITE, i / 3};
  return core::Point_array(points, n);
}

// Checks the triangles. They change nothing in the result; wrong ones are a sign of a mistake.
void check_triangles(const std::int32_t* triangles, std::size_t number, std::size_t n)
{
  check_number(triangles, number);
  for (std::size_t k = 0; k < 3 * number; ++k)
    if (triangles[k] < 0 || std::size_t(triangles[k]) >= n)
      throw Refusal{DELAUNAY_3_BAD_INDEX, k / 3};
}

void check_weights(const double* weights, std::size_t n)
{
  for (std::size_t i = 0; i < n; ++i)
    if (!core::is_finite_number(weights[i]))
      throw Refusal{DELAUNAY_3_NOT_FINITE, i};
}

class Given_weighted_points final : public core::Weighted_point_source
{
public:
  Given_weighted_points(const core::Point_array& points, const double* weights)
    : m_points(points)
    , m_weights(weights)
  {
  }
  core::Point_array points() override { return m_points; }
  const double* weights() override { return m_weights; }

private:
  const core::Point_array m_points;
  const double* const m_weights;
};

// Tells a function of the caller's how far the work is, and whether it returned 0.
class Watch final : public core::Observer
{
public:
  explicit Watch(std::size_t n = 0, int (*go_further)(void*, double) = nullptr,
                 void* data = nullptr)
    : m_n(n)
    , m_go_further(go_further)
    , m_data(data)
  {
  }
  bool go_further(std::size_t inserted) override
  {
    // Copies of points in a box are inserted, too.
    const double share = (std::min)(1., double(inserted) / double((std::max)(m_n, std::size_t(1))));
    m_is_stopped = m_go_further != nullptr && m_go_further(m_data, share) == 0;
    return !m_is_stopped;
  }
  void refuse_stopped() const
  {
    if (m_is_stopped)
      throw Refusal{DELAUNAY_3_STOPPED, 0};
  }

private:
  const std::size_t m_n;
  int (*const m_go_further)(void*, double);
  void* const m_data;
  bool m_is_stopped = false;
};

template <class Source>
Arrays built_of(Source&& source, Watch& watch, const Threads& executor)
{
  core::Build_options options;
  options.adds_apex = true;
  const auto built = core::build(source, options, watch, executor);
  watch.refuse_stopped();
  return core::arrays_of_built<std::int32_t>(*built, source, executor);
}

Periodic_arrays built_in_box(const core::Point_array& points, const double* weights, const Box& box,
                             Watch& watch, const Threads& executor)
{
  core::Built_in_box built =
      core::build_in_box(points, weights, box.data(), core::Build_options(), watch, executor);
  watch.refuse_stopped();
  return core::arrays_of_box<std::int32_t>(built, points, box);
}

struct Input
{
  const double *points, *weights;
  std::size_t n;
  const double* box;
};

// Checks what is given, and builds; weights and box may be null.
template <class F>
delaunay_3_status build(const Input& input, int threads, Watch watch, delaunay_3** result,
                        std::size_t* where, const F& check_further)
{
  if (result != nullptr)
    *result = nullptr;
  return status_of(where, [&] {
    refuse_null(result);
    const Threads executor(checked_threads(threads));
    const core::Point_array points = checked_points(input.points, input.n);
    if (input.weights != nullptr)
      check_weights(input.weights, input.n);
    check_further();
    auto d = std::make_unique<delaunay_3>(delaunay_3{points, input.weights, Arrays()});
    if (input.box != nullptr) {
      d->is_periodic = true;
      d->box = {input.box[0], input.box[1], input.box[2]};
      d->in_box = built_in_box(points, input.weights, d->box, watch, executor);
    } else if (input.weights != nullptr) {
      d->arrays = built_of(Given_weighted_points(points, input.weights), watch, executor);
    } else {
      d->arrays = built_of(core::Given_points(points), watch, executor);
    }
    *result = d.release();
  });
}

template <class A>
delaunay_3_cells cells_of(const A& arrays)
{
  return {arrays.dimension(),        arrays.number_of_simplices(),
          arrays.number_of_cells(),  arrays.stride(),
          arrays.vertices_data(),    arrays.neighbors_data(),
          arrays.number_of_points(), arrays.vertices_of_points().data()};
}

delaunay_3_cells cells_of(const delaunay_3& d)
{
  return d.is_periodic ? cells_of(d.in_box) : cells_of(d.arrays);
}

core::Simplices_view<std::int32_t> view_of(const delaunay_3_cells& cells)
{
  return {cells.vertices,        cells.stride, cells.neighbors,
          cells.stride,          cells.number, cells.number_with_infinite,
          cells.number_of_points};
}

} // namespace

delaunay_3_status delaunay_3_build(const double* points, size_t n, const int32_t* triangles,
                                   size_t number_of_triangles, int threads, delaunay_3** result,
                                   size_t* where)
{
  return build({points, nullptr, n, nullptr}, threads, Watch(), result, where,
               [&] { check_triangles(triangles, number_of_triangles, n); });
}

delaunay_3_status delaunay_3_build_weighted(const double* points, const double* weights, size_t n,
                                            int threads, delaunay_3** result, size_t* where)
{
  return build({points, weights, n, nullptr}, threads, Watch(), result, where,
               [&] { refuse_null(weights, n); });
}

delaunay_3_status delaunay_3_build_periodic(const double* points, const double* weights, size_t n,
                                            const double* box, int threads, delaunay_3** result,
                                            size_t* where)
{
  return build({points, weights, n, box}, threads, Watch(), result, where,
               [&] { refuse_null(box); });
}

delaunay_3_status delaunay_3_build_watched(const double* points, const double* weights, size_t n,
                                           const double* box, int threads,
                                           int (*go_further)(void*, double), void* data,
                                           delaunay_3** result, size_t* where)
{
  return build({points, weights, n, box}, threads, Watch(n, go_further, data), result, where,
               [] {});
}

const int16_t* delaunay_3_offsets(const delaunay_3* d)
{
  return d == nullptr ? nullptr : d->in_box.offsets_data();
}

const char* delaunay_3_message(delaunay_3_status status)
{
  switch (status) {
  case DELAUNAY_3_OK:
    return "all is well";
  case DELAUNAY_3_NOT_FINITE:
    return "a coordinate or weight is not a finite number";
  case DELAUNAY_3_BAD_INDEX:
    return "a triangle has an index that is not one of a point";
  case DELAUNAY_3_BAD_ARGUMENT:
    return "threads must be at least 1, levels from 0 to 3, arrays with entries not null, and the "
           "points those of the triangulation";
  case DELAUNAY_3_TOO_MANY:
    return "there are more cells, points or triangles than numbers of 32 bits can tell apart";
  case DELAUNAY_3_NO_MEMORY:
    return "there is not enough memory";
  case DELAUNAY_3_NOT_EXACT:
    return "the library is compiled with -ffast-math or -Ofast (remedy: -fno-fast-math), or "
           "denormal numbers become zero in a mode that cannot be left";
  case DELAUNAY_3_BAD_BOX:
    return "a period is not positive, or much smaller than the box or the coordinates are, or the "
           "points lie in a plane or on a line parallel to all axes with periods";
  case DELAUNAY_3_STOPPED:
    return "the caller's function has stopped the work";
  case DELAUNAY_3_NO_INSIDE:
    return "the surface has no inside: it is not orientable, or so open that less volume is surely "
           "inside than in doubt";
  default:
    return "the library has failed";
  }
}

void delaunay_3_get(const delaunay_3* d, delaunay_3_cells* cells)
{
  if (cells == nullptr)
    return;
  *cells = {-1, 0, 0, 0, nullptr, nullptr, 0, nullptr};
  if (d == nullptr)
    return;
  *cells = cells_of(*d);
}

void delaunay_3_free(delaunay_3* d)
{
  delete d;
}

delaunay_3_status delaunay_3_find(const delaunay_3* d, const double* points, size_t n, int threads,
                                  int32_t* found, size_t* where)
{
  return status_of(where, [&] {
    const Threads executor(checked_threads(threads));
    refuse_null(d);
    refuse_null(found, n);
    const core::Point_array queries = checked_points(points, n);
    const delaunay_3_cells cells = cells_of(*d);
    if (cells.dimension < 3) {
      std::fill_n(found, n, -1);
      return;
    }
    const auto point_of = [&](std::size_t i) {
      const double* const p = d->points[i];
      return std::array<double, 3>{p[0], p[1], p[2]};
    };
    if (d->is_periodic) {
      const core::Points_in_box wrapped(d->points.size(), point_of, d->box.data());
      const core::Simplices_in_box<std::int32_t> in_box = {view_of(cells), d->in_box.offsets_data(),
                                                           wrapped};
      core::find_in_box(in_box, queries, 0, executor,
                        [&](std::size_t i, const auto& copy) { found[i] = copy.simplex; });
    } else {
      core::find_simplices(view_of(cells), point_of, queries, found, executor);
    }
  });
}

delaunay_3_status delaunay_3_winding_numbers(const delaunay_3* d, const int32_t* triangles,
                                             size_t number_of_triangles, int threads,
                                             double* numbers, size_t* where)
{
  const auto find = [&] {
    const Threads executor(checked_threads(threads));
    refuse_null(d);
    const delaunay_3_cells cells = cells_of(*d);
    if (d->is_periodic || d->weights != nullptr || cells.dimension < 3 || number_of_triangles == 0)
      throw Refusal{DELAUNAY_3_BAD_ARGUMENT, 0};
    refuse_null(numbers);
    check_triangles(triangles, number_of_triangles, cells.number_of_points);
    std::vector<std::array<std::int32_t, 3>> faces(number_of_triangles);
    std::copy_n(triangles, 3 * number_of_triangles, faces.data()->data());
    const auto four = [&](const std::int32_t* all) {
      return [&cells, all](std::size_t c) {
        const std::int32_t* const of_cell = all + c * cells.stride;
        return std::array<std::int32_t, 4>{of_cell[0], of_cell[1], of_cell[2], of_cell[3]};
      };
    };
    const CGAL::Inside_3 inside = CGAL::Delaunay_from_surface_3::internal::find_inside(
        d->points, faces, cells.number, four(cells.vertices), four(cells.neighbors),
        [&](std::size_t i) { return cells.vertex_of_point[i]; }, executor);
    std::copy(inside.winding_numbers.begin(), inside.winding_numbers.end(), numbers);
  };
  return status_of(where, find, DELAUNAY_3_NO_INSIDE);
}

int delaunay_3_is_valid(const delaunay_3* d, int level)
{
  bool is_valid = false;
  const delaunay_3_status status = status_of(nullptr, [&] {
    refuse_null(d);
    if (d->is_periodic || level < 0 || level > int(CGAL::Delaunay_validity_level::DELAUNAY))
      throw Refusal{DELAUNAY_3_BAD_ARGUMENT, 0};
    checked_points(d->points.size() > 0 ? d->points[0] : nullptr, d->points.size());
    const auto wanted = CGAL::Delaunay_validity_level(level);
    if (d->weights == nullptr) {
      is_valid = core::is_valid(d->arrays, d->points, wanted);
    } else {
      check_weights(d->weights, d->points.size());
      is_valid = core::is_valid<core::Weighted_vertex>(d->arrays, d->points, wanted, core::Alone(),
                                                       d->weights);
    }
  });
  return status == DELAUNAY_3_OK ? is_valid : -int(status);
}

#ifdef DELAUNAY_3_NO_EXCEPTIONS
template <class Error>
void delaunay_3_end_call(const Error& error)
{
  end_call(refusal_of(error));
}
#endif
