// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INSERT_POINTS_3_H
#define CGAL_INSERT_POINTS_3_H

#include <CGAL/Delaunay_from_surface_3/door/Executor_by_tag.h>
#include <CGAL/Delaunay_from_surface_3/door/Read_soup.h>
#include <CGAL/Delaunay_from_surface_3/door/insert_surface.h>
#include <CGAL/Delaunay_from_surface_3/door/read_items.h>
#include <CGAL/Delaunay_from_surface_3/door/refuse_triangulation.h>
#include <CGAL/Delaunay_from_surface_3/paper/Lower_neighbor_graph.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Point_insertion_traits_3.h>
#include <CGAL/Surface_insertion_traits_3.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Iterator_range.h>
#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <optional>
#include <type_traits>

namespace CGAL {

/// \cond SKIP_IN_MANUAL
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {
/// \endcond

/*!
\ingroup PkgDelaunayFromSurface3Points

inserts points into a Delaunay triangulation: no surface and no graph is needed. The result equals
what `tr.insert(first, last)` makes of them. What holds after refused input, a stop or an exception
is what `insert_surface_vertices_3()` says.

Pairs of a point and an info (`std::pair`, or the tuples of a `boost::zip_iterator`) give the
vertices their info, if no `point_map` is given. Of points that are equal the one with the smallest
index gives the vertex its point and info, in every mode. That differs from `tr.insert(first,
last)`, where the last in its own order gives the info.

<b>Complexity</b>: expected \f$O(n \log n)\f$ for the order of n points, plus the insertions.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; by default
that of the triangulation. Any of them serves any triangulation: many threads can fill one that is
made for a single thread. `Parallel_tag` needs TBB.
\tparam Gt,Tds,Lp,Slds the parameters of `Delaunay_triangulation_3`; any are served. `Gt` must have
exact predicates.
\tparam PointRange a range of points, of pairs of points and infos, of anything with numbers `p[0]`,
`p[1]`, `p[2]` (arrays, pointers, vectors of other libraries), or of items that `point_map` turns
into points
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tr the triangulation into which the points are inserted
\param points the points
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
below; any other does not compile

\cgalNamedParamsBegin
  \cgalParamNBegin{point_map}
    \cgalParamDescription{the points of the items of `points`}
    \cgalParamType{a model of `ReadablePropertyMap` from the items to the points of `tr`, to a type
      convertible to it, or to the points of another kernel, which are converted as
      `insert_surface_vertices_3()` does it}
    \cgalParamDefault{`CGAL::Identity_property_map`}
  \cgalParamNEnd
  \cgalParamNBegin{random_seed}
    \cgalParamDescription{the seed of the insertion order; the same seed gives the same insertions. That
      of points alone is random only where its budget is exceeded.}
    \cgalParamType{unsigned int}
    \cgalParamDefault{0}
  \cgalParamNEnd
  \cgalParamNBegin{preserve_order}
    \cgalParamDescription{whether the vertices are created in the order of the input: the vertex iterator
      of `tr` then gives the i-th distinct point as its i-th finite vertex. That needs an empty `tr`
      that can go through the core.}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{is told what is going on, and can stop it; if it has a function `accept()`
      it leaves points out. It is copied unless it is passed by `std::ref()`}
    \cgalParamType{a model of `SurfaceInsertionVisitor_3`, or a callable that gets the share of the points
      that are inserted, a `double` that grows from 0 to 1, now and then; it stops the work by
      returning `false`}
    \cgalParamDefault{`Default_surface_insertion_visitor_3`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_to_vertex_output_iterator}
    \cgalParamDescription{receives a pair for every point inserted: its index and its handle in
      `tr`, in ascending order of the indices. It is otherwise that of
      `insert_surface_vertices_3()`.}
    \cgalParamType{a model of `OutputIterator` accepting `std::pair<std::size_t, Vertex_handle>`, or a
      callable with such a pair, or with an index and a handle}
    \cgalParamDefault{`Emptyset_iterator`}
  \cgalParamNEnd
\cgalNamedParamsEnd

The info of the vertices can be given by `Delaunay_from_surface_3::vertex_info_map()` or
`Delaunay_from_surface_3::vertex_info_range()`, with which the sequence then begins.

\return the number of vertices that `tr` has gained; 0 after a stop if it was empty

\throws Surface_input_error if a coordinate is not a finite number, the number of infos is not that
of the points, or `preserve_order` cannot be had; `tr` is then unchanged

Example: \ref Delaunay_from_surface_3/thin_points.cpp

\sa `insert_points_along_graph_3()`
\sa `Point_insertion_traits_3`
*/
template <class ConcurrencyTag = Default, class Gt, class Tds, class Lp, class Slds,
          class PointRange, typename CGAL_NP_TEMPLATE_PARAMETERS>
std::ptrdiff_t insert_points_3(Delaunay_triangulation_3<Gt, Tds, Lp, Slds>& tr,
                               const PointRange& points,
                               const CGAL_NP_CLASS& np = parameters::default_values())
{
  using namespace Delaunay_from_surface_3::internal;
  using Triangulation = Delaunay_triangulation_3<Gt, Tds, Lp, Slds>;
  const Read_items<Triangulation, PointRange, CGAL_NP_CLASS> read(points, np);
  const Lower_neighbor_graph no_graph;
  const Insertion_input input{read.points(), no_graph,        Identity_index_map(),
                              std::nullopt,  Identity_name(), read.infos()};
  return insert_surface<Executor_by_tag<ConcurrencyTag, Triangulation>, internal_np::point_t>(
      tr, input, Point_insertion_traits_3(), np);
}

/// \ingroup PkgDelaunayFromSurface3Points
/// does the same for the points in the range [`first`, `last`) of a model of `InputIterator`.
template <class ConcurrencyTag = Default, class Gt, class Tds, class Lp, class Slds,
          class InputIterator, typename CGAL_NP_TEMPLATE_PARAMETERS>
#ifdef DOXYGEN_RUNNING
std::ptrdiff_t
#else
std::enable_if_t<Delaunay_from_surface_3::internal::is_iterator<InputIterator>, std::ptrdiff_t>
#endif
insert_points_3(Delaunay_triangulation_3<Gt, Tds, Lp, Slds>& tr, InputIterator first,
                InputIterator last, const CGAL_NP_CLASS& np = parameters::default_values())
{
  return insert_points_3<ConcurrencyTag>(tr, make_range(first, last), np);
}

/*!
\ingroup PkgDelaunayFromSurface3Soup

inserts the points of a polygon soup into a Delaunay triangulation. The edges of the faces serve as
the surface; the faces may be polygons, overlap, be oriented at random, or have edges with many
faces. For traits that trace a `Bounded_degree_subgraph`, it is found as for a mesh if the faces are
triangles that form a surface; else a spanning forest takes its place. The result, and what holds
after a stop or an exception, are those of `insert_surface_vertices_3()`.

<b>Complexity</b>: expected \f$O((n + m) \log n)\f$ for the order of n points along m sides of faces,
plus the insertions.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; by default
that of the triangulation. Any of them serves any triangulation: many threads can fill one that is
made for a single thread. `Parallel_tag` needs TBB.
\tparam Gt,Tds,Lp,Slds the parameters of `Delaunay_triangulation_3`; any are served. `Gt` must have
exact predicates.
\tparam PointRange as that of `insert_points_3()`: points, pairs of points and infos, or items that
`point_map` turns into points
\tparam FaceRange a range of ranges of integers; with `Parallel_tag` several threads read it at once
if its iterators have random access
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tr the triangulation into which the points are inserted
\param points the points, those in no face included
\param faces the faces: for each the indices of its points in order
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": those of the form
without faces. The seed always counts.

\return the number of vertices that `tr` has gained; 0 after a stop if it was empty

\throws Surface_input_error if a coordinate is not a finite number, a face has an index out of
range, the number of infos is not that of the points, or `preserve_order` cannot be had; `tr` is
then unchanged

Example: \ref Delaunay_from_surface_3/insert_polygon_soup.cpp

\sa `insert_surface_vertices_3()`
*/
template <class ConcurrencyTag = Default, class Gt, class Tds, class Lp, class Slds,
          class PointRange, class FaceRange, typename CGAL_NP_TEMPLATE_PARAMETERS>
std::ptrdiff_t insert_points_3(Delaunay_triangulation_3<Gt, Tds, Lp, Slds>& tr,
                               const PointRange& points, const FaceRange& faces,
                               const CGAL_NP_CLASS& np = parameters::default_values())
{
  return insert_points_3<ConcurrencyTag>(tr, points, faces, Surface_insertion_traits_3(), np);
}

/*!
\ingroup PkgDelaunayFromSurface3Soup

does the same in another way, with traits, a model of `SurfaceInsertionTraits_3`: they say in which
order points are inserted, from which cells, and along which subgraph the surface is traced.

The other parameters, what is returned and what is thrown are as above; `preserve_order` needs traits
that go through the core (`through_core`). <b>Complexity</b>: that of the parts of the traits, plus
\f$O(n + m)\f$.

Example: \ref Delaunay_from_surface_3/own_plan.cpp
*/
template <class ConcurrencyTag = Default, class Gt, class Tds, class Lp, class Slds,
          class PointRange, class FaceRange, class SurfaceInsertionTraits,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
std::ptrdiff_t insert_points_3(Delaunay_triangulation_3<Gt, Tds, Lp, Slds>& tr,
                               const PointRange& points, const FaceRange& faces,
                               const SurfaceInsertionTraits& traits,
                               const CGAL_NP_CLASS& np = parameters::default_values())
{
  using namespace Delaunay_from_surface_3::internal;
  using Triangulation = Delaunay_triangulation_3<Gt, Tds, Lp, Slds>;
  using Executor = Executor_by_tag<ConcurrencyTag, Triangulation>;
  static_assert(are_faces<FaceRange>, "behind the points come faces, ranges of indices, or "
                                      "named parameters");
  if constexpr (are_faces<FaceRange>) {
    const Read_soup<Triangulation, PointRange, FaceRange, CGAL_NP_CLASS> read(
        points, faces, np, Executor(), least_points_for_core<SurfaceInsertionTraits>(tr, np));
    return insert_surface<Executor, internal_np::point_t>(tr, read.input(), traits, np);
  } else {
    return 0;
  }
}

/// \cond SKIP_IN_MANUAL
template <class ConcurrencyTag = Default, class Triangulation, class... Arguments>
Delaunay_from_surface_3::internal::If_refused<Triangulation> insert_points_3(Triangulation&,
                                                                             const Arguments&...)
{
  return Delaunay_from_surface_3::internal::refuse_triangulation<Triangulation>();
}
} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
/// \endcond

} // namespace CGAL

#endif // CGAL_INSERT_POINTS_3_H
