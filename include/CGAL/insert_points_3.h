// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INSERT_POINTS_3_H
#define CGAL_INSERT_POINTS_3_H

#include <CGAL/Delaunay_from_surface_3/adapters/Executor_by_tag.h>
#include <CGAL/Delaunay_from_surface_3/adapters/Read_mesh.h>
#include <CGAL/Delaunay_from_surface_3/adapters/insert_surface.h>
#include <CGAL/Delaunay_from_surface_3/paper/spanning_subgraph.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
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

inserts points into a Delaunay triangulation, without a surface or graph. The result equals that of
`tr.insert(first, last)`. `insert_surface_vertices_3()` describes the state of `tr` after refused
input, a stop or an exception.

If no `point_map` is given, pairs of a point and an info (`std::pair`, or the tuples of a
`boost::zip_iterator`) set the infos of the vertices. Of several equal points, the one with the
smallest index determines the point and info of their vertex, with any traits and number of threads.
This differs from `tr.insert(first, last)`, where the last in its own order determines the info.

<b>Complexity</b>: expected \f$O(n \log n)\f$ for the order of n points, plus the insertions.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; by default
that of the triangulation. Any tag works with any triangulation: many threads can fill one that is
made for a single thread. `Parallel_tag` requires TBB.
\tparam Gt,Tds,Lp,Slds the parameters of `Delaunay_triangulation_3`, without restriction. The result
is guaranteed only if `Gt` has exact predicates.
\tparam PointRange a range of points, of pairs of points and infos, of anything with arithmetic
coordinates `p[0]`, `p[1]`, `p[2]` (arrays, pointers, vectors of other libraries), or of items that
`point_map` maps to points
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tr the triangulation into which the points are inserted
\param points the points
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
below; any other does not compile

\cgalNamedParamsBegin
  \cgalParamNBegin{point_map}
    \cgalParamDescription{maps the items of `points` to points}
    \cgalParamType{a model of `ReadablePropertyMap` from the items to the points of `tr`, to a type
      convertible to these, or to the points of another kernel, which are converted as in
      `insert_surface_vertices_3()`}
    \cgalParamDefault{`CGAL::Identity_property_map`}
  \cgalParamNEnd
  \cgalParamNBegin{random_seed}
    \cgalParamDescription{the seed of the insertion order; on one thread, the same seed gives the
      same insertions. With the default traits it has an effect only if the budget of the order is
      exceeded.}
    \cgalParamType{unsigned int}
    \cgalParamDefault{0}
  \cgalParamNEnd
  \cgalParamNBegin{preserve_order}
    \cgalParamDescription{whether the vertices are created in the order of the input: the i-th
      finite vertex of the vertex iterator of `tr` is then the i-th distinct point. This requires an
      empty `tr` and input that the core can handle.}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{is told about the progress, and can stop the work. It is copied unless it
      is passed by `std::ref()`.}
    \cgalParamType{a model of `SurfaceInsertionVisitor_3`, or a callable that receives from time to
      time the fraction of the points that are inserted, a `double` from 0 to 1, and stops the work
      by returning `false`}
    \cgalParamDefault{`Default_surface_insertion_visitor_3`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_to_vertex_output_iterator}
    \cgalParamDescription{receives for every point inserted a pair of its index and its vertex
      handle in `tr`, in ascending order of the indices. In all other respects it is as in
      `insert_surface_vertices_3()`.}
    \cgalParamType{a model of `OutputIterator` accepting `std::pair<std::size_t, Vertex_handle>`, or
      a callable that takes such a pair, or an index and a handle}
    \cgalParamDefault{`Emptyset_iterator`}
  \cgalParamNEnd
\cgalNamedParamsEnd

The infos of the vertices can be given by `Delaunay_from_surface_3::vertex_info_map()` or
`Delaunay_from_surface_3::vertex_info_range()`; the sequence then begins with one of these.

\return the number of vertices that `tr` has gained; 0 after a stop if it was empty

\throws Surface_input_error if a coordinate is not a finite number, the numbers of infos and points
differ, or the input order cannot be preserved as requested; `tr` is then unchanged

Example: \ref Delaunay_from_surface_3/insert_polygon_soup.cpp

\sa `insert_points_along_graph_3()`
\sa `Surface_insertion_traits_3`
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
  const Index_graph no_graph;
  const Insertion_input input{read.points(), no_graph,        Identity_index_map(),
                              std::nullopt,  Identity_name(), read.infos()};
  return insert_surface<Executor_by_tag<ConcurrencyTag, Triangulation>, internal_np::point_t>(
      tr, input, Surface_insertion_traits_3(), np);
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

inserts the points of a polygon soup into a Delaunay triangulation. By default the faces are checked
and have no effect on the order; other traits use their edges. The faces may be any polygons, may
overlap, may be oriented arbitrarily, and any number of them may share an edge. If the traits trace
a `Bounded_degree_subgraph` and the faces are triangles that form a surface, this subgraph is found
as for a mesh; otherwise a spanning forest takes its place. The result, and the state after a stop
or an exception, are those of `insert_surface_vertices_3()`.

<b>Complexity</b>: \f$O(n \log n + m)\f$ for the order of n points and the checks of m sides of
faces, plus the insertions.

\tparam ConcurrencyTag,Gt,Tds,Lp,Slds as in the overload without faces
\tparam PointRange as in the overload without faces: points, pairs of points and infos, or items
that `point_map` maps to points
\tparam FaceRange a range of ranges of integers. If it has random access, several threads may read
it at the same time with `Parallel_tag`.
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tr the triangulation into which the points are inserted
\param points the points, including those in no face
\param faces for each face the indices of its points, in order
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": those of the overload
without faces

\return the number of vertices that `tr` has gained; 0 after a stop if it was empty

\throws Surface_input_error if a coordinate is not a finite number, a face has an index out of
range, the numbers of infos and points differ, or the input order cannot be preserved as requested;
`tr` is then unchanged

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

does the same with other traits, a model of `SurfaceInsertionTraits_3`. The traits determine the
order in which points are inserted, from which cells their location starts, and along which subgraph
the surface is traced.

The other parameters, the return value and the exceptions are as above; `preserve_order` requires
traits that go through the core (`through_core`). <b>Complexity</b>: that of the parts of the
traits, plus \f$O(n + m)\f$.

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
        points, faces, np, Executor(), asks_for_graph<SurfaceInsertionTraits>());
    return insert_surface<Executor, internal_np::point_t>(tr, read.input(), traits, np);
  } else {
    return 0;
  }
}

/// \cond SKIP_IN_MANUAL
template <class ConcurrencyTag = Default, class Triangulation, class... Arguments>
std::enable_if_t<!Delaunay_from_surface_3::internal::is_regular<Triangulation>,
                 Delaunay_from_surface_3::internal::If_refused<Triangulation>>
insert_points_3(Triangulation&, const Arguments&...)
{
  return Delaunay_from_surface_3::internal::refuse_triangulation<Triangulation>();
}

// insert_weighted_points_3.h has the overloads that take precedence.
template <class ConcurrencyTag = Default, class Gt, class Tds, class Lp, class... Arguments>
std::ptrdiff_t insert_points_3(Regular_triangulation_3<Gt, Tds, Lp>&, const Arguments&...)
{
  return Delaunay_from_surface_3::internal::refuse_triangulation<
      Regular_triangulation_3<Gt, Tds, Lp>>();
}
} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
/// \endcond

} // namespace CGAL

#endif // CGAL_INSERT_POINTS_3_H
