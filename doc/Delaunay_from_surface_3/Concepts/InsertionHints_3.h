/*!
\ingroup PkgDelaunayFromSurface3Concepts
\cgalConcept

An `InsertionHints_3` provides for each point the cell from which its location starts
(\cgalCite{choi-dtsm-02}, Fig.\ 1, lines 2a and 2b). It observes the insertions, and it may trace
the surface through the triangulation at the end of a round.

The starting cell is only a hint: any cell gives the right result, a near one gives it fast.

A model must remember vertices, not cells. While points are only inserted, a vertex is never
destroyed. A cell is destroyed by the next insertion near it, and its memory may then hold another
cell. A policy that observes conflict zones may remember the history of the cells instead.

A model is a class template with two parameters. `Target` is
`CGAL::Delaunay_from_surface_3::Triangulation_target_3<Triangulation>`. `Subgraph` is a model of
`boost::AdjacencyGraph` whose vertices are the numbers of the points, of type `std::size_t`. It
represents T, the subgraph of the surface that a `SurfaceSubgraph` has chosen; every edge of T can
be followed in both directions. Points are numbered in the order of their insertion, as in the
target.

With `Planned_hints_3` and `Previous_hint_3` the points can go through the core
(`SurfaceInsertionTraits_3::through_core`), which uses the same starting points.

\cgalRefines{UpdateObserver_3}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Delaunay_from_surface_3::Traced_hints_3<Target\, Subgraph>}
\cgalHasModels{CGAL::Delaunay_from_surface_3::Conflict_history_hints_3<Target\, Subgraph>}
\cgalHasModels{CGAL::Delaunay_from_surface_3::Neighbor_hints_3<Target\, Subgraph>}
\cgalHasModels{CGAL::Delaunay_from_surface_3::Planned_hints_3<Target\, Subgraph>}
\cgalHasModels{CGAL::Delaunay_from_surface_3::Previous_hint_3<Target\, Subgraph>}
\cgalHasModelsEnd

\sa `SurfaceInsertionTraits_3`
*/
class InsertionHints_3
{
public:
  /*!
  says, at compile time, whether T is needed. If it is `false`, T is not computed, and the
  constructor receives an empty graph.
  */
  static constexpr bool uses_subgraph = unspecified_value;

  /*!
  constructs the hints for one call. All three arguments outlive this object, so references to them
  may be kept.

  \param target what the points are inserted into. No round has begun.
  \param subgraph the graph T on the numbers 0, …, `target.size()`-1 if `uses_subgraph` is `true`,
  otherwise an empty graph
  \param plan the order of insertion; point i of `target` is the one at place i of this order, so
  `starting_places[i]` is the number of a point of `target`
  */
  InsertionHints_3(const Target& target, const Subgraph& subgraph,
                   const CGAL::Delaunay_from_surface_3::Insertion_order& plan);

  /*!
  returns the cell from which the location of point `i` starts (line 2b). It is called just before
  that location, for `i` = 0, 1, and so on.

  \return a cell that exists now. `target.cell(v)` returns one for every vertex `v`, and also if `v`
  is none.
  */
  Target::Cell start(std::size_t i);

  /*!
  traces the surface, if the policy does so (line 2a). It is called after the last insertion of each
  round except the last round.

  \return the number of points that were located; 0 if nothing is traced
  */
  std::size_t trace();
};
