/*!
\ingroup PkgDelaunayFromSurface3Concepts
\cgalConcept

An `InsertionTarget_3` is what n points are inserted into. They are numbered 0, …, n-1 in the order
of their insertion, whatever their numbers in the surface were (\cgalCite{choi-dtsm-02}, Fig.\ 1,
line 2c). It also locates points by walking, which stands in for the location structure Q of lines
2a and 2b.

A target knows nothing of surfaces. A model is a class template with one parameter:
`Triangulation`, a `CGAL::Delaunay_triangulation_3`.

The complete insertion calls, in this order: the constructor; `obstacle()`;
`create_vertices_in_order()` if the caller asks for it; `insert_round()` for one round after the
other, with locations of points not yet inserted in between; `finish()`; `take_vertices()`. If it is
stopped, `finish()` is left out. All functions declared `const` may be called at any time before
`take_vertices()`.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Delaunay_from_surface_3::Compact_delaunay_3<Triangulation>}
\cgalHasModels{CGAL::Delaunay_from_surface_3::Triangulation_target_3<Triangulation>}
\cgalHasModelsEnd

\sa `SurfaceInsertionTraits_3`
*/
class InsertionTarget_3
{
public:
  /// \name Types
  /// @{

  /*!
  a vertex: a model of `DefaultConstructible`, `CopyAssignable` and `EqualityComparable`, with
  `!=` as well as `==`. `Vertex()` stands for none. A vertex stays valid while points are only
  inserted.
  */
  using Vertex = unspecified_type;

  /*!
  a cell: a model of `DefaultConstructible` and `CopyAssignable`. An insertion may destroy it.
  */
  using Cell = unspecified_type;

  /*!
  the place of a point: a model of `CopyConstructible` with a public member `cell` of type
  `Cell`. An insertion may make it invalid.
  */
  using Location = unspecified_type;

  /// @}

  /// \name Creation
  /// @{

  /*!
  `true` if any points can be inserted into any triangulation; `serves_geom_traits()` and
  `obstacle()` need not exist then.
  */
  static constexpr bool serves_everything = unspecified_value;

  /*!
  returns whether triangulations with these geometric traits can be served at all. If not, nothing
  else is compiled.
  */
  static constexpr bool serves_geom_traits();

  /*!
  is to insert `points`, in this order, into `tr`, which may have vertices already. Both outlive
  the target, so references to them may be kept. `tr` is not changed before `insert_round()`.

  A target may have another beside it that does the same with many threads, the type
  `Parallel_target`; `void` if there is none.

  A target that numbers its cells and runs out of numbers throws a
  `CGAL::Delaunay_from_surface_3::Too_few_ids`, here or from a function that inserts, and leaves `tr`
  empty. If it names a type `Wider_target` that is not `void`, that begins anew.
  */
  InsertionTarget_3(Triangulation& tr, const std::vector<Triangulation::Point>& points);

  /*!
  returns why the points cannot be inserted this way, in words; nothing if they can. If there is
  an obstacle, no other function is called, and `Triangulation_target_3` takes the target's place.
  */
  std::optional<std::string> obstacle() const;

  /// @}

  /// \name Access
  /// @{

  /// returns n, the number of points.
  std::size_t size() const;

  /// returns the vertex of point `i`; none if the point is not inserted yet, or left out.
  Vertex vertex(std::size_t i) const;

  /// returns a cell of `v`; any cell from which `locate()` can start if `v` is none.
  Cell cell(Vertex v) const;

  /// @}

  /// \name Location
  /// @{

  /// returns the place of point `i`, found by a walk from `start`. Point `i` may be inserted or
  /// not. A target may have the same function without `const`, whose steps `counts()` counts.
  Location locate(std::size_t i, Cell start) const;

  /*!
  returns a finite vertex of the cell of `location`, the nearest to point `i`, perhaps up to rounding.
  \pre `location` is the place of point `i`, and nothing was inserted since it was found.
  \pre There is a finite vertex.
  */
  Vertex nearest_vertex(std::size_t i, const Location& location) const;

  /// returns whether `v` is closer to point `i` than `w`, perhaps up to rounding. Both are finite.
  bool is_closer(std::size_t i, Vertex v, Vertex w) const;

  /// @}

  /// \name Insertion
  /// @{

  /*!
  inserts point `i` and tells `observer`: `before_update()` where it applies, and
  `after_update()` always. A point that is there already gets the vertex that is there.

  \tparam Observer a model of `UpdateObserver_3`
  \pre `location` is the place of point `i`, and nothing was inserted since it was found.
  \post `vertex(i)` is not none.
  */
  template <class Observer>
  void insert(std::size_t i, const Location& location, Observer& observer);

  /*!
  does the same as `insert()` if `accepts(j, q)` returns `true`, where q is the point of the vertex
  nearest to point `i`, and j the number of the first point inserted there, or `std::size_t(-1)` if
  none was. Else it inserts nothing, and tells `observer` of that vertex by `after_update()`.
  `accepts` is not called where a vertex stands at point `i`, or there is no vertex at all.

  This function may be left out. A target that has it calls it in `insert_round()` for a visitor that
  leaves points out, as `insert_one_by_one()` does; with the others such a visitor does not compile.
  */
  template <class Observer, class Accepts>
  void insert_if(std::size_t i, const Location& location, Observer& observer,
                 const Accepts& accepts);

  /// returns how many threads may insert at the same time in `insert_round()`.
  std::size_t number_of_threads() const;

  /*!
  returns how many points of a round `insert_round()` should be given at once when `inserted` points
  are inserted, at least 1. Between the calls `counts()` tells whether the order has become too
  costly.
  */
  std::size_t size_of_piece(std::size_t inserted) const;

  /*!
  inserts the points `first`, …, `last - 1`, which are a round or a piece of one: asks `hints` where
  the location of each starts, and tells them of each insertion, and `visitor` of the phases
  `LOCATION` and `UPDATE`. A target that has no better way calls `insert_one_by_one()`. One that lets
  several threads insert gives each a copy of `hints`, whose class then has a constant
  `is_concurrent` that is `true`, and calls nothing of `visitor` but `go_further()`, in the thread
  that called.

  \tparam Hints a model of `InsertionHints_3`
  \tparam Visitor a model of `SurfaceInsertionVisitor_3`
  \return `false` if the visitor's `go_further()` stopped it
  */
  template <class Hints, class Visitor>
  bool insert_round(std::size_t first, std::size_t last, Hints& hints, Visitor& visitor);

  /// returns what the insertions have done so far: a
  /// `CGAL::Delaunay_from_surface_3::Insertion_counts`, with zeros for what is not counted.
  Insertion_counts counts() const;

  /*!
  is called before the first round if the caller wants the vertices in the order of the input. A
  target that cannot do this leaves the function out; the input is then refused.

  \param order the numbers of the points in that order, a permutation of 0, …, n-1; equal points share
  the place of the first of them. It lives until the target is destroyed.
  */
  void create_vertices_in_order(const std::vector<std::size_t>& order);

  /*!
  is called once, after the last insertion. From then on the triangulation is complete.
  */
  void finish();

  /*!
  gives the vertices of the points in the triangulation away, in the order of `points`: a
  default-constructed handle for each point that was not inserted. It is called last.
  */
  std::vector<Triangulation::Vertex_handle> take_vertices();

  /// @}
};
