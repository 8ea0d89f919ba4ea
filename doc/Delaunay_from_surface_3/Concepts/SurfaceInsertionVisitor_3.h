/*!
\ingroup PkgDelaunayFromSurface3Concepts
\cgalConcept

A `SurfaceInsertionVisitor_3` is told about the progress of the insertion of a surface, and can stop
it. It may have an additional function `accept()`, which leaves points out.

Visitors are copied; pass one by `std::ref()` to keep its state. A visitor may throw. An empty
triangulation is then unchanged; a non-empty one is the triangulation of its old points and
those inserted so far.

For points p, q, …, in two rounds, the calls come in this order:

| call | |
|---|---|
| `surface_is_irregular(reason)` | only if it applies |
| `phase_begins(PLAN)`, `phase_begins(SUBGRAPH)` | |
| `subgraph_is_replaced(reason)` | only if the subgraph refuses the surface |
| `target_is_replaced(reason)` | only if it applies |
| `insertion_begins(1)` | with the number of threads |
| `round_begins(0, n_0)` | |
| `go_further()`, `phase_begins(LOCATION)`, `phase_begins(UPDATE)` | for p, and so on |
| `phase_begins(TRACE)`, `trace_ends(k)` | not in the core |
| `round_begins(1, n_1)` | |
| `go_further()`, `phase_begins(LOCATION)`, `phase_begins(UPDATE)` | for q, and so on |
| `insertion_ends(target, hints)`, `phase_begins(FINISH)` | left out after a stop |
| `phase_begins(DONE)` | |

In the core, `go_further()` is called at the beginning of each round, and then for every 256th point.

`accept()`, if there is one, is called after `phase_begins(UPDATE)`. For the first points, until
those accepted do not lie in one plane, it is called before `insertion_begins()`.

If the order is too costly, `order_is_replaced(reason)` is called after an insertion, and all calls
from `phase_begins(PLAN)` on are repeated.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Default_surface_insertion_visitor_3}
\cgalHasModelsEnd
*/
class SurfaceInsertionVisitor_3
{
public:
  /*!
  is called before the first phase if the surface is not a manifold mesh of triangles. This is not an
  error.

  \param reason says in words how many faces are not triangles, and how many edges have more than two
  faces
  */
  void surface_is_irregular(const std::string& reason);

  /*!
  is called before the first round if the compact triangulation of the core cannot be used. This is
  not an error: %CGAL's own insertion takes its place, and the result is the same. It is called in the
  middle of the work if there are more cells than 32 bits can number; the rounds then begin anew.
  \param reason says in words what prevents the use of the core
  */
  void target_is_replaced(const std::string& reason);

  /*!
  is called in the phase `SUBGRAPH` if the subgraph of the traits cannot be used. This is not an
  error: a spanning forest takes its place, and the result is the same.

  \param reason says which vertex or edge the subgraph refuses, or what it needs and the graph lacks
  */
  void subgraph_is_replaced(const std::string& reason);

  /*!
  is called in the middle of the work if the order of the plan makes the insertions too costly. This
  is not an error: they begin anew in another order, with the phase `PLAN`, and the result is the
  same.
  \param reason says in words what is too costly
  */
  void order_is_replaced(const std::string& reason);

  /*!
  is called before the first round with the number of threads that may insert. If there is more than
  one, the phases `LOCATION` and `UPDATE` are not reported, and `go_further()` is called whenever the
  calling thread takes a portion of points. The calling thread calls all functions of the visitor.
  */
  void insertion_begins(std::size_t number_of_threads);

  /// is called when `phase` begins, which ends the previous phase. If a visitor keeps the default's
  /// version, the phases of single points are not tracked.
  void phase_begins(CGAL::Surface_insertion_phase phase);

  /*!
  is called before the first point of a round.

  \param round the number of the round, counted from 0
  \param number_of_points how many points the round is to insert; at least 1
  */
  void round_begins(std::size_t round, std::size_t number_of_points);

  /*!
  is called after the trace that ends a round: every round but the last, if %CGAL inserts.

  \param number_of_located_points what `InsertionHints_3::trace()` returned
  */
  void trace_ends(std::size_t number_of_located_points);

  /*!
  is called after the last insertion, before the triangulation is handed over. It gives access to the
  counts of the insertions. It is not called after a stop.
  \param target an object with a function `counts()` that returns
  `CGAL::Delaunay_from_surface_3::Insertion_counts`; if %CGAL inserts, a
  `CGAL::Delaunay_from_surface_3::Triangulation_target_3`, which counts nothing
  \param hints a model of `InsertionHints_3`; if the core inserts, an object without functions
  */
  template <class Target, class Hints>
  void insertion_ends(const Target& target, const Hints& hints);

  /*!
  is called before each insertion if %CGAL inserts; in the core before every 256th, and at the
  beginning of each round.

  \return `false` to stop the work here
  */
  bool go_further();

  /*!
  is optional. If it exists, the core calls it instead of the one without argument, with the number of
  points inserted; with several threads this number is approximate. It falls only when the work begins
  anew. The one without argument must exist too: a class derived from the default visitor says
  `using CGAL::Default_surface_insertion_visitor_3::go_further;`.

  \return `false` to stop the work here
  */
  bool go_further(std::size_t inserted);

  /*!
  decides whether a point is inserted. This function is optional, and the default visitor has none:
  everything is then inserted, and no nearest vertices are computed.

  It is called once for each point, in the order of insertion. It is not called for the very first
  point in an empty triangulation, nor for a point at which there is already a vertex, which then
  becomes the point's vertex. Which points are left out depends on the order: on the traits, the seed,
  and the order of the input. So a single thread inserts the points one by one, whatever the
  concurrency tag says, and `insertion_begins()` receives 1. If another order takes over
  (`order_is_replaced()`), the function is called anew for all points; if %CGAL's insertion continues
  in the same order, it is not called again.

  A point that is left out gets no vertex. It is not written to `vertex_to_vertex_output_iterator`,
  its info is not used, and it has no effect on later points. The result is the triangulation of the
  points that are inserted.

  The nearest vertex is exactly the nearest of the whole triangulation; of several at the same
  distance it is the lexicographically smallest. So only the order and the answers decide which points
  are left out. In the core, this costs the search for the cells in conflict with the point, which
  every insertion needs anyway; a point that is left out costs this search besides its location. If
  %CGAL inserts, the stars on the way to the nearest vertex are visited.

  A visitor with this function does not compile with `delaunay_3_arrays()`.

  \tparam Point the points of the triangulation

  \param i the index of the point in the input; for a mesh, its place in `vertices(mesh)`
  \param nearest the index of the first point inserted at the nearest vertex; `std::size_t(-1)` if
  the vertex was in the triangulation before the call
  \param point the point of the nearest vertex

  \return `false` to leave the point out
  */
  bool accept(std::size_t i, std::size_t nearest, const Point& point);

  /*!
  is called instead of the one above, if it exists.

  \param i as above
  \param nearest as above
  \param point as above
  \param corners for each vertex of a cell that contains the point, what `nearest` is for the nearest
  vertex. `std::size_t(-1)` also stands for the infinite vertex, if the point lies beyond the
  facet of the others, and for all four vertices while the dimension is below 3.

  \return `false` to leave the point out
  */
  bool accept(std::size_t i, std::size_t nearest, const Point& point,
              const std::array<std::size_t, 4>& corners);
};
