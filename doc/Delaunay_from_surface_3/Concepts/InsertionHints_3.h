/*!
\ingroup PkgDelaunayFromSurface3Concepts
\cgalConcept

An `InsertionHints_3` provides for each point the cell from which its location starts
(\cgalCite{choi-dtsm-02}, Fig.\ 1, lines 2a and 2b). It is told what each insertion changes (line
2c), and it may trace the surface through the triangulation at the end of a round.

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

A model may be derived from `CGAL::Delaunay_from_surface_3::Previous_hint_3`, and then has all
members already; those that it declares itself take their place. `CGAL/Surface_insertion_traits_3.h`
includes all that it needs. Example: \ref Delaunay_from_surface_3/own_hints.cpp

With `Planned_hints_3` and `Previous_hint_3` the points can go through the core
(`SurfaceInsertionTraits_3::through_core`), which uses the same starting points.

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
  says, at compile time, whether `before_update()` is to be called. If it is `false`, the target
  need not compute the conflict zone separately, and inserts in the fastest way.
  */
  static constexpr bool observes_conflict_zone = unspecified_value;

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
  is called before point `i` is inserted, if `observes_conflict_zone` is `true` and the target knows
  the conflict zone: in dimension 3, without `Fast_location`, for points that have no vertex yet.

  \tparam CellIterator an input iterator with the value type `Target::Cell`
  \param i the number of the point
  \param first,last the cells that the insertion will destroy. They still exist.
  */
  template <class CellIterator>
  void before_update(std::size_t i, CellIterator first, CellIterator last);

  /*!
  is called after point `i` was inserted.

  \param i the number of the point
  \param v its vertex: a new one, or the existing one if the point is a duplicate
  */
  void after_update(std::size_t i, Target::Vertex v);

  /*!
  traces the surface, if the policy does so (line 2a). It is called after the last insertion of each
  round except the last round.

  \return the number of points that were located, for whoever measures; 0 if nothing is traced
  */
  std::size_t trace();
};
