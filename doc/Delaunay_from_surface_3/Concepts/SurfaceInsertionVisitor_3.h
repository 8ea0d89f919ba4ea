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
| `notice(SURFACE_IS_IRREGULAR, reason)` | only if it applies |
| `phase_begins(PLAN, 0)`, `phase_begins(SUBGRAPH, 0)` | |
| `notice(SUBGRAPH_IS_REPLACED, reason)` | only if the subgraph refuses the surface |
| `notice(CORE_IS_REPLACED, reason)` | only if it applies |
| `phase_begins(INSERTION, 1)` | with the number of threads |
| `phase_begins(ROUND, n_0)` | with the number of points |
| `go_further(0)`, `phase_begins(LOCATION, 0)`, `phase_begins(UPDATE, 0)` | for p, and so on |
| `phase_begins(TRACE, n_1)` | not in the core |
| `phase_begins(ROUND, n_1)` | |
| `go_further(n_0)`, `phase_begins(LOCATION, 0)`, `phase_begins(UPDATE, 0)` | for q, and so on |
| `insertion_ends(target, hints)`, `phase_begins(FINISH, 0)` | left out after a stop |
| `phase_begins(DONE, 0)` | |

If the order is too costly, `notice(ORDER_IS_REPLACED, reason)` is called after an insertion, and all
calls from `phase_begins(PLAN, 0)` on are repeated.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Default_surface_insertion_visitor_3}
\cgalHasModelsEnd
*/
class SurfaceInsertionVisitor_3
{
public:
  /// says, at compile time, whether the phases `LOCATION` and `UPDATE` of every point are reported.
  /// With more than one thread they never are.
  static constexpr bool follows_points = unspecified_value;

  /*!
  is called when something other than what was asked for is done. This is not an error, and the result
  is the same.

  \param what is done; `Surface_insertion_notice` says when
  \param reason says in words why
  */
  void notice(CGAL::Surface_insertion_notice what, const std::string& reason);

  /*!
  is called when `phase` begins, which ends the previous phase. The calling thread calls this and all
  other functions of the visitor.

  \param phase the phase
  \param number `Surface_insertion_phase` says of what; 0 for phases without a number
  */
  void phase_begins(CGAL::Surface_insertion_phase phase, std::size_t number);

  /*!
  is called before each insertion if %CGAL inserts; in the core at the beginning of each round and
  before every 256th insertion, and with several threads whenever the calling thread takes a portion of
  points.

  \param inserted the number of points inserted, which is approximate with several threads. It falls
  only when the work begins anew.

  \return `false` to stop the work here
  */
  bool go_further(std::size_t inserted);

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
};
