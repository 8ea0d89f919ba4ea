/*!
\ingroup PkgDelaunayFromSurface3Concepts
\cgalConcept

A `SurfaceSubgraph` is a function object that chooses the edges of T. T is the subgraph of the
surface graph F that is traced through the triangulation, or whose edges say which points are
neighbours (\cgalCite{choi-dtsm-02}, §3).

The result is the same for any choice, even an empty one. The cost is not: the bound on a
trace (Theorem 3 of the paper) requires a subgraph that spans F, has bounded degree, and consists of
Delaunay edges.

A model knows nothing about triangulations: it sees a graph, and what its constructor was given.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Delaunay_from_surface_3::Bounded_degree_subgraph}
\cgalHasModels{CGAL::Delaunay_from_surface_3::Spanning_forest}
\cgalHasModels{CGAL::Delaunay_from_surface_3::Minimum_spanning_forest<Point>}
\cgalHasModels{CGAL::Delaunay_from_surface_3::Full_graph}
\cgalHasModels{CGAL::Delaunay_from_surface_3::No_subgraph}
\cgalHasModelsEnd

\sa `SurfaceInsertionTraits_3`
*/
class SurfaceSubgraph
{
public:
  /*!
  writes edges of `graph` to `out`. The same graph gives the same edges in the same order.

  Each edge written belongs to T in both directions. Loops and repeated edges are harmless.

  \tparam Graph a model of `boost::VertexListGraph` and `boost::EdgeListGraph`, directed or not. For
  a mesh it is the mesh itself, and a model may ask for more of it, such as `HalfedgeGraph`.
  \tparam VertexIndexMap a model of `boost::ReadablePropertyMap` from vertex descriptors of `Graph`
  to an integer type
  \tparam EdgeOutputIterator a model of `OutputIterator` that accepts edge descriptors of `Graph`

  \param graph the surface as a graph F with n vertices. `num_vertices(graph)` may be larger than n
  for a mesh with removed elements.
  \param index_map maps the vertices of `graph` onto 0, …, n-1, one to one
  \param out receives the edges of T

  \return the output iterator past the last edge written

  \throws Surface_input_error if the model cannot handle this surface. A spanning forest then takes
  its place, and the visitor is told why (`SUBGRAPH_IS_REPLACED`). The same happens if the
  model cannot be called with this type of graph.
  */
  template <class Graph, class VertexIndexMap, class EdgeOutputIterator>
  EdgeOutputIterator operator()(const Graph& graph, VertexIndexMap index_map,
                                EdgeOutputIterator out) const;
};
