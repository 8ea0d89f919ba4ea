// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INSERT_SURFACE_VERTICES_3_H
#define CGAL_INSERT_SURFACE_VERTICES_3_H

#include <CGAL/Delaunay_from_surface_3/door/Read_mesh.h>
#include <CGAL/Delaunay_from_surface_3/door/insert_surface.h>
#include <CGAL/Delaunay_from_surface_3/door/refuse_triangulation.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Surface_insertion_traits_3.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Named_function_parameters.h>

#include <cstddef>

namespace CGAL {

/// \cond SKIP_IN_MANUAL
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {
/// \endcond

/*!
\ingroup PkgDelaunayFromSurface3Mesh

inserts the vertices of a surface mesh into a Delaunay triangulation. The result equals what
`tr.insert(first, last)` makes of the same points; the surface serves to find the way.

The default traits use the edges of the mesh, and nothing else of its connectivity; faces that are
not triangles, several components, boundaries and isolated vertices are no obstacle to any traits.
Duplicate points share one vertex, to which the first of them in the order of `vertices(mesh)` gives
its point and info.

If `tr` is empty it is built aside and swapped in: refused input, a stop by the visitor or an
exception leave it unchanged, and handles to its infinite vertex from before the call become
invalid. If it is not empty, after a stop, or an exception thrown by the visitor or the output
iterator, it is the triangulation of its old points and those inserted so far; after an exception
thrown by its own insertion it may only be cleared or destroyed.

<b>Complexity</b>: expected \f$O((n + m) \log n + k)\f$ for the order of n vertices along m edges,
with a largest index k, plus the insertions.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; by default that
of the triangulation. Any of them serves any triangulation: many threads can fill one that is made
for a single thread. `Parallel_tag` needs TBB.
\tparam Gt,Tds,Lp,Slds the parameters of `Delaunay_triangulation_3`; any are served. `Gt` must have
exact predicates.
\tparam FaceGraph a model of `VertexListGraph`, `EdgeListGraph` and `FaceListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tr the triangulation into which the vertices are inserted
\param mesh the surface
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
below; any other does not compile

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices of `mesh`}
    \cgalParamType{a model of `ReadablePropertyMap` from
      `boost::graph_traits<FaceGraph>::%vertex_descriptor` to the points of `tr`, to a type
      convertible to it, or to the points of another kernel. The latter go through
      `Cartesian_converter`: exactly where the numbers of `Gt` can hold the coordinates, else
      rounded by `to_double()`.}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{an index for each vertex of `mesh`, different for different vertices}
    \cgalParamType{a model of `ReadablePropertyMap` from
      `boost::graph_traits<FaceGraph>::%vertex_descriptor` to an integer type; indices are not
      negative, and may have gaps; memory grows with the largest}
    \cgalParamDefault{the index map of the mesh, or one made for the call}
  \cgalParamNEnd
  \cgalParamNBegin{random_seed}
    \cgalParamDescription{the seed of the insertion order; the same seed gives the same insertions}
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
    \cgalParamDescription{receives a pair for every vertex of `mesh` inserted, in their order: the vertex
      and its handle in `tr`. Duplicates are paired with the same handle. After a stop nothing is
      written if `tr` was empty, else the vertices inserted so far.}
    \cgalParamType{a model of `OutputIterator` accepting
      `std::pair<boost::graph_traits<FaceGraph>::%vertex_descriptor, Vertex_handle>`, or a callable
      with such a pair, or with a vertex and a handle}
    \cgalParamDefault{`Emptyset_iterator`}
  \cgalParamNEnd
\cgalNamedParamsEnd

The info of the vertices can be given by `Delaunay_from_surface_3::vertex_info_map()` or
`Delaunay_from_surface_3::vertex_info_range()`, with which the sequence then begins.

\return the number of vertices that `tr` has gained; 0 after a stop if it was empty

\throws Surface_input_error if a coordinate is not a finite number, an index is negative or too large, two
vertices have the same index, the number of infos is not that of the vertices, or `preserve_order`
cannot be had; `tr` is then unchanged

Example: \ref Delaunay_from_surface_3/insert_surface_mesh.cpp

\sa `insert_points_3()`
\sa `insert_points_along_graph_3()`
*/
template <class ConcurrencyTag = Default, class Gt, class Tds, class Lp, class Slds,
          class FaceGraph, typename CGAL_NP_TEMPLATE_PARAMETERS>
std::ptrdiff_t insert_surface_vertices_3(Delaunay_triangulation_3<Gt, Tds, Lp, Slds>& tr,
                                         const FaceGraph& mesh,
                                         const CGAL_NP_CLASS& np = parameters::default_values())
{
  return insert_surface_vertices_3<ConcurrencyTag>(tr, mesh, Surface_insertion_traits_3(), np);
}

/*!
\ingroup PkgDelaunayFromSurface3Mesh

does the same in another way, with traits, a model of `SurfaceInsertionTraits_3`: they say in which
order points are inserted, from which cells, and along which subgraph the surface is traced.

The other parameters, what is returned and what is thrown are as above; `preserve_order` needs traits
that go through the core (`through_core`). <b>Complexity</b>: that of the parts of the traits, plus
\f$O(n + m + k)\f$.

Example: \ref Delaunay_from_surface_3/own_traits.cpp
*/
template <class ConcurrencyTag = Default, class Gt, class Tds, class Lp, class Slds,
          class FaceGraph, class SurfaceInsertionTraits, typename CGAL_NP_TEMPLATE_PARAMETERS>
std::ptrdiff_t insert_surface_vertices_3(Delaunay_triangulation_3<Gt, Tds, Lp, Slds>& tr,
                                         const FaceGraph& mesh,
                                         const SurfaceInsertionTraits& traits,
                                         const CGAL_NP_CLASS& np = parameters::default_values())
{
  using namespace Delaunay_from_surface_3::internal;
  using Triangulation = Delaunay_triangulation_3<Gt, Tds, Lp, Slds>;
  const Read_mesh<Triangulation, FaceGraph, CGAL_NP_CLASS> read(mesh, np);
  return insert_surface<Executor_by_tag<ConcurrencyTag, Triangulation>, internal_np::vertex_point_t,
                        internal_np::vertex_index_t>(tr, read.input(), traits, np);
}

/// \cond SKIP_IN_MANUAL
template <class ConcurrencyTag = Default, class Triangulation, class... Arguments>
Delaunay_from_surface_3::internal::If_refused<Triangulation>
insert_surface_vertices_3(Triangulation&, const Arguments&...)
{
  return Delaunay_from_surface_3::internal::refuse_triangulation<Triangulation>();
}
} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
/// \endcond

} // namespace CGAL

#endif // CGAL_INSERT_SURFACE_VERTICES_3_H
