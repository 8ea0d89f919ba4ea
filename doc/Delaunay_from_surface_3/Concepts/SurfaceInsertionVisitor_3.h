/*!
\ingroup PkgDelaunayFromSurface3Concepts
\cgalConcept

A `SurfaceInsertionVisitor_3` is told what the insertion of a surface is doing, and can stop it. It
may have one more function, `accept()`, which leaves points out.

Visitors are copied; one passed by `std::ref()` keeps its state. A visitor may throw: an empty
triangulation is then unchanged, and a non-empty one is the triangulation of its old points and
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

In the core `go_further()` comes at the beginning of each round, and then for every 256th point.

A visitor with `accept()` is asked by it after `phase_begins(UPDATE)`; about the first points, until
those accepted do not lie in one plane, already before `insertion_begins()`.

If the order is too costly, `order_is_replaced(reason)` comes after an insertion, and all from
`phase_begins(PLAN)` on comes again.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Default_surface_insertion_visitor_3}
\cgalHasModelsEnd
*/
class SurfaceInsertionVisitor_3
{
public:
  /*!
  is called before the first phase if the surface is not a manifold mesh of triangles. This is no
  error: only the edges are used.

  \param reason what was found, in words: how many faces are not triangles, and how many edges have
  more than two faces
  */
  void surface_is_irregular(const std::string& reason);

  /*!
  is called before the first round if the compact triangulation of the core cannot serve. This is no
  error: %CGAL's own insertion takes its place, and the result is the same. It is called in the
  middle of the work if there are more cells than numbers of 32 bits: the rounds then begin anew.
  \param reason what stands against it, in words
  */
  void target_is_replaced(const std::string& reason);

  /*!
  is called in the phase `SUBGRAPH` if the subgraph of the traits cannot serve. This is no error: a
  spanning forest takes its place, and the result is the same.

  \param reason what the subgraph says of the vertex or edge that it refuses, or that it needs what
  the graph does not have
  */
  void subgraph_is_replaced(const std::string& reason);

  /*!
  is called in the middle of the work if the order of the plan makes the insertions too costly. This
  is no error: they begin anew, with the phase `PLAN`, in another order, and the result is the same.
  \param reason what is too costly, in words
  */
  void order_is_replaced(const std::string& reason);

  /*!
  is called before the first round with the number of threads that may insert. If that is more than
  one, the phases `LOCATION` and `UPDATE` are not told, and `go_further()` is asked at each
  portion of the thread that called. This thread calls all functions here.
  */
  void insertion_begins(std::size_t number_of_threads);

  /// is called when `phase` begins; the phase before it ends there. Where it is the default's, nobody
  /// is told of points.
  void phase_begins(CGAL::Surface_insertion_phase phase);

  /*!
  is called before the first point of a round.

  \param round the number of the round, counted from 0
  \param number_of_points how many points the round is to insert; at least 1
  */
  void round_begins(std::size_t round, std::size_t number_of_points);

  /*!
  is called after the trace that ends a round: every round but the last where %CGAL inserts.

  \param number_of_located_points what `InsertionHints_3::trace()` returned
  */
  void trace_ends(std::size_t number_of_located_points);

  /*!
  is called after the last insertion, before the triangulation is handed over: here their counts can
  be had. Not after a stop.
  \param target an object with a function `counts()` that returns
  `CGAL::Delaunay_from_surface_3::Insertion_counts`; where %CGAL inserts, a
  `CGAL::Delaunay_from_surface_3::Triangulation_target_3`, which counts nothing
  \param hints a model of `InsertionHints_3`; where the core inserts, an object without functions
  */
  template <class Target, class Hints>
  void insertion_ends(const Target& target, const Hints& hints);

  /*!
  is called before each insertion of %CGAL's; in the core before every 256th, and at the beginning of
  each round.

  \return `false` to stop the work here
  */
  bool go_further();

  /*!
  may be left out. In the core it is asked in place of the other, with the number of points inserted;
  with several threads that is rough, and may fall. The other must be there too: a class derived from
  the default visitor says `using CGAL::Default_surface_insertion_visitor_3::go_further;`.
  */
  bool go_further(std::size_t inserted);

  /*!
  is called before the insertion of a point: whether it may be inserted. This function can be left
  out, and the default visitor has none; everything is then inserted, and nobody looks for nearest
  vertices.

  It is called once for each point, in the order of the insertions, but not for the very first into
  an empty triangulation, nor where a vertex stands at the point already: that is then the point's
  vertex. What is left out depends on the order: on traits, seed, and the order of the input. So the
  insertions go one by one in a single thread, whatever the concurrency tag says, and
  `insertion_begins()` tells 1. In each order the question is asked once, whoever inserts: if another
  order takes its place (`order_is_replaced()`), the questions begin anew.

  A point that is left out gets no vertex: it is not written to
  `vertex_to_vertex_output_iterator`, has no info to give, and stands in nobody's way. The
  triangulation is that of the points that are inserted.

  The nearest vertex is that of the whole triangulation, exactly; of several at the same distance the
  lexicographically smallest. So order and answers alone decide what is left out. In the core that
  costs what it takes to find the cells in conflict with the point, which is done for every
  insertion anyway; a point that is left out costs it on top of its location. %CGAL's own insertion
  passes the stars on the way to the nearest vertex.

  With `delaunay_3_arrays()` a visitor that has this function does not compile.

  \param i the point: its index in the input; for a mesh, its place in `vertices(mesh)`
  \param nearest the index of the first point inserted at the nearest vertex; `std::size_t(-1)` if
  none was: the vertex was in the triangulation before
  \param point where the nearest vertex is
  \tparam Point the points of the triangulation

  \return `false` to leave the point out
  */
  bool accept(std::size_t i, std::size_t nearest, const Point& point);

  /*!
  is called in place of the other, if it is there.

  \param i as above
  \param nearest as above
  \param point as above
  \param corners for the vertices of a cell that contains the point, what `nearest` is for the nearest
  vertex. `std::size_t(-1)` also stands for the infinite vertex, where the point lies beyond the
  facet of the others, and for all four as long as the dimension is below 3.
  */
  bool accept(std::size_t i, std::size_t nearest, const Point& point,
              const std::array<std::size_t, 4>& corners);
};
