/*!
\ingroup PkgDelaunayFromSurface3Concepts
\cgalConcept

An `InsertionHints_3` gives each point the cell from which its location starts
(\cgalCite{choi-dtsm-02}, Fig.\ 1, lines 2a and 2b). It observes the insertions, and it may trace
the surface through the triangulation at the end of a round.

A start is a hint: every cell is right, a near one is fast.

What is remembered must be vertices, not cells. While points are only inserted a vertex never dies;
a cell does with the next insertion near it, and its memory may then hold another cell. A policy
that observes conflict zones may remember the history of the cells instead.

A model is a class template with two parameters: `Target`, which is
`CGAL::Delaunay_from_surface_3::Triangulation_target_3<Triangulation>`, and `Subgraph`, a model of
`boost::AdjacencyGraph` whose vertices are the numbers of the points, of type `std::size_t`. It stands
for T, the subgraph of the surface that a `SurfaceSubgraph` has chosen, and every edge of T can be
followed in both directions. Points are numbered in the order of their insertion, as in the target.

With `Planned_hints_3` and `Previous_hint_3` the points can go through the core
(`SurfaceInsertionTraits_3::through_core`), which starts them in the same way.

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
  says, at compile time, whether T is needed. If it is `false`, T is not computed, and the graph
  that the constructor gets is empty.
  */
  static constexpr bool uses_subgraph = unspecified_value;

  /*!
  makes the hints for one insertion. All three objects outlive this one, so references to them may
  be kept.

  \param target what the points are inserted into. No round has begun.
  \param subgraph the graph T on the numbers 0, …, `target.size()`-1 if `uses_subgraph` is `true`,
  else an empty graph
  \param plan the plan that was made; point i of `target` is the one at place i of its order, so that
  `starting_places[i]` is the number of a point of `target`
  */
  InsertionHints_3(const Target& target, const Subgraph& subgraph,
                   const CGAL::Delaunay_from_surface_3::Insertion_order& plan);

  /*!
  returns the cell from which the location of point `i` starts (line 2b). It is called just before
  that, for `i` = 0, 1, and so on. Where a visitor leaves points out, points before `i` may have no
  vertex.

  \return a cell that is alive now. `target.cell(v)` gives one for every vertex `v`, and for none.
  */
  Target::Cell start(std::size_t i);

  /*!
  is called after each round but the last, when the last point of the round has been inserted
  (line 2a).

  \return the number of points that were located; 0 if there is no trace
  */
  std::size_t trace();
};
