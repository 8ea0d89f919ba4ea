/*!
\ingroup PkgDelaunayFromSurface3Concepts
\cgalConcept

A `SurfaceInsertionVisitor_3` is told about the progress of the insertion of a surface, and can stop
it.

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
};
