// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_TRIANGULATED_SURFACE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_TRIANGULATED_SURFACE_H

#include <utility>

namespace CGAL {
namespace Delaunay_from_surface_3 {

/*!
\ingroup PkgDelaunayFromSurface3Subgraphs

is a triangulated surface as the functions on subgraphs take it, independent of the user's data
structure. It is returned by `surface_of()`, is small, and refers to the arguments of that function.

\tparam Reader chosen by `surface_of()`
*/
template <class Reader>
class Triangulated_surface
{
public:
  /// the type of edges: the descriptor of the mesh or graph, or a pair of indices for a soup.
  using edge_descriptor = typename Reader::Edge;

  /// \cond
  explicit Triangulated_surface(Reader reader)
    : m_reader(std::move(reader))
  {
  }

  const Reader& reader() const { return m_reader; }
  /// \endcond

private:
  Reader m_reader;
};

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_TRIANGULATED_SURFACE_H
