/*!
\ingroup PkgDelaunayFromSurface3Concepts
\cgalConcept

An `InsertionPlan` is a function object that decides the order in which points are inserted, and
where the rounds of the insertion end. A trace follows every round but the last
(\cgalCite{choi-dtsm-02}, §2 and Fig.\ 1).

The triangulation is right for any order. A model knows nothing of cells.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Delaunay_from_surface_3::Log_star_rounds}
\cgalHasModels{CGAL::Delaunay_from_surface_3::Geometric_rounds}
\cgalHasModels{CGAL::Delaunay_from_surface_3::Spaced_rounds}
\cgalHasModels{CGAL::Delaunay_from_surface_3::Spatial_sort_order}
\cgalHasModels{CGAL::Delaunay_from_surface_3::Surface_net_rounds}
\cgalHasModelsEnd

\sa `CGAL::Delaunay_from_surface_3::Insertion_order`
\sa `SurfaceInsertionTraits_3`
*/
class InsertionPlan
{
public:
  /*!
  makes the plan from `seed`, which stands for all its random choices: plans with the same seed give
  the same order for the same points. A plan without random choices ignores it.

  Only `CGAL::Surface_insertion_policies_3`, and plans that are made of others, ask for this
  constructor. A traits class of your own may make its plan in another way.
  */
  explicit InsertionPlan(unsigned int seed);

  /*!
  returns the order of n points and the ends of the rounds.

  \tparam Point the points of the triangulation
  \tparam GeomTraits the geometric traits class of these points, a model of
  `DelaunayTriangulationTraits_3`
  \tparam Graph a model of `boost::VertexListGraph` and `boost::EdgeListGraph`, directed or not
  \tparam VertexIndexMap a model of `boost::ReadablePropertyMap` from vertex descriptors of `Graph`
  to an integer type

  \param points the n points; all coordinates are finite, points may coincide
  \param gt a geometric traits object for `points`
  \param graph the graph of the surface, not the subgraph that is traced
  \param index_map maps the vertices of `graph` onto 0, …, n-1, one to one: the vertex with index i
  stands for `points[i]`

  \post The `order` returned is a permutation of 0, …, n-1. Its `round_ends` increase strictly, and
  the last is n; there are none if and only if n is 0. Its `starting_places` are none, or one
  for each place; each but the first comes before its place. The functions that insert check all
  this, and throw a `std::invalid_argument` before they insert anything if it does not hold.
  */
  template <class Point, class GeomTraits, class Graph, class VertexIndexMap>
  CGAL::Delaunay_from_surface_3::Insertion_order
  operator()(const std::vector<Point>& points, const GeomTraits& gt, const Graph& graph,
             VertexIndexMap index_map) const;

  /// \name Budget
  ///
  /// A plan may have both of the following, or neither. They bound what an unlucky order can cost:
  /// when the insertions have destroyed more cells than the budget allows, or tested twice as many on
  /// their walks, those made so far are dropped and the work begins anew with `fallback_plan()`. It is
  /// looked at every 256 points, by threads more rarely, while points are left, and in the core alone:
  /// %CGAL's insertion counts nothing.
  /// @{

  /// how many cells the insertions may destroy for each point inserted, on average; as many as for a
  /// thousand points come on top. Of more than a million points another sixteenth is allowed for each
  /// doubling.
  static constexpr std::size_t cells_per_point = unspecified_value;

  /// returns another `InsertionPlan`, made from the same seed.
  unspecified_type fallback_plan() const;

  /// @}
};
