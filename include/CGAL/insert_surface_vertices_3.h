// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INSERT_SURFACE_VERTICES_3_H
#define CGAL_INSERT_SURFACE_VERTICES_3_H

#include <CGAL/Delaunay_from_surface_3/adapters/Read_mesh.h>
#include <CGAL/Delaunay_from_surface_3/adapters/insert_surface.h>
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

inserts the vertices of a surface mesh into a Delaunay triangulation. The result equals that of
`tr.insert(first, last)` for the same points.

The default traits use the points of the mesh alone; others trace its surface, or make the order
from its edges. Faces that are not triangles, several components, boundaries and isolated vertices
are allowed with any traits. Equal points share one vertex; the first of them in the order of
`vertices(mesh)` determines its point and info.

If `tr` is empty, the result is built in another triangulation and swapped in. Refused input, a stop
by the visitor or an exception leave `tr` unchanged. After success, old handles to its infinite
vertex are invalid.

If `tr` is not empty, then after a stop, or an exception thrown by the visitor or the output
iterator, it is the triangulation of its old points and those inserted so far. After an exception
thrown by its own insertion it may only be cleared or destroyed. Refused input leaves it unchanged.

<b>Complexity</b>: \f$O(n \log n + k)\f$ for the order of n vertices, where k is the largest index,
plus the insertions.

\tparam ConcurrencyTag,Gt,Tds,Lp,Slds as in `insert_points_3()`
\tparam FaceGraph a model of `VertexListGraph`, `EdgeListGraph` and `FaceListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tr the triangulation into which the vertices are inserted
\param mesh the surface
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `random_seed`,
`preserve_order` and `visitor` of `insert_points_3()`, and those below; any other does not compile

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{maps the vertices of `mesh` to points}
    \cgalParamType{a model of `ReadablePropertyMap` from
      `boost::graph_traits<FaceGraph>::%vertex_descriptor` to the points of `tr`, to a type
      convertible to these, or to the points of another kernel. The latter are converted by
      `Cartesian_converter`: exactly if the number type of `Gt` can represent the coordinates,
      otherwise rounded by `to_double()`.}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{maps the vertices of `mesh` to indices, distinct vertices to distinct
      indices}
    \cgalParamType{a model of `ReadablePropertyMap` from
      `boost::graph_traits<FaceGraph>::%vertex_descriptor` to an integer type. Indices must not be
      negative, and may have gaps; the memory used grows with the largest index.}
    \cgalParamDefault{the index map of the mesh, or one created for the call}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_to_vertex_output_iterator}
    \cgalParamDescription{receives for every vertex of `mesh` inserted, in their order, a pair of
      this vertex and its vertex handle in `tr`. Vertices at equal points are paired with the same
      handle. After a stop nothing is written if `tr` was empty, otherwise the vertices inserted so
      far.}
    \cgalParamType{a model of `OutputIterator` accepting
      `std::pair<boost::graph_traits<FaceGraph>::%vertex_descriptor, Vertex_handle>`, or a callable
      that takes such a pair, or a vertex and a handle}
    \cgalParamDefault{`Emptyset_iterator`}
  \cgalParamNEnd
\cgalNamedParamsEnd

The infos of the vertices can be given by `Delaunay_from_surface_3::vertex_info_map()` or
`Delaunay_from_surface_3::vertex_info_range()`; the sequence then begins with one of these.

\return the number of vertices that `tr` has gained; 0 after a stop if it was empty

\throws Surface_input_error if a coordinate is not a finite number, an index is negative or too
large, two vertices have the same index, the numbers of infos and vertices differ, or the input
order cannot be preserved as requested; `tr` is then unchanged

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

does the same with other traits, a model of `SurfaceInsertionTraits_3`. The traits determine the
order in which points are inserted, from which cells their location starts, and along which subgraph
the surface is traced.

The other parameters, the return value and the exceptions are as above; `preserve_order` requires
traits that go through the core (`through_core`). <b>Complexity</b>: that of the parts of the
traits, plus \f$O(n + m + k)\f$.

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
