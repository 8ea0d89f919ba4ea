/*!
\ingroup PkgDelaunayFromSurface3Concepts
\cgalConcept

An `InsertionPlan` is a function object that decides the order in which points are inserted, and
where the rounds of the insertion end. A trace follows every round but the last
(\cgalCite{choi-dtsm-02}, §2 and Fig.\ 1).

The result is the same for any order. A model knows nothing about cells.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Delaunay_from_surface_3::Log_star_rounds}
\cgalHasModels{CGAL::Delaunay_from_surface_3::Geometric_rounds}
\cgalHasModels{CGAL::Delaunay_from_surface_3::Spaced_rounds}
\cgalHasModels{CGAL::Delaunay_from_surface_3::Spatial_sort_order}
\cgalHasModelsEnd

\sa `CGAL::Delaunay_from_surface_3::Insertion_order`
\sa `SurfaceInsertionTraits_3`
*/
class InsertionPlan
{
public:
  /*!
  constructs the plan from `seed`, which determines all its random choices: plans with the same seed
  give the same order for the same points. A plan without random choices ignores it.

  Only `CGAL::Surface_insertion_policies_3`, and plans that contain other plans, use this
  constructor. Your own traits class may construct its plan in another way.
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

  \post `order` is a permutation of 0, …, n-1. `round_ends` is strictly increasing and ends with n;
  it is empty if and only if n is 0. `starting_places` is empty or has n elements, and
  `starting_places[k]` < k for all k > 0. If any of this does not hold, the functions that insert
  throw a `std::invalid_argument` before they insert anything.
  */
  template <class Point, class GeomTraits, class Graph, class VertexIndexMap>
  CGAL::Delaunay_from_surface_3::Insertion_order
  operator()(const std::vector<Point>& points, const GeomTraits& gt, const Graph& graph,
             VertexIndexMap index_map) const;

  /// \name Budget
  ///
  /// A plan may have both of the following members, or neither. They bound the cost of an unlucky
  /// order. If the insertions have destroyed more cells than the budget allows, or tested more than
  /// twice as many on their walks, their result is discarded and the work begins anew with
  /// `fallback_plan()`. The budget is checked every 256 points, by many threads less often, as long as
  /// points are left. Only the core checks it: %CGAL's insertion counts nothing.
  /// @{

  /// says how many cells the insertions may destroy per point inserted, on average. The amount for a
  /// thousand points is allowed in addition, and above a million points another sixteenth for each
  /// doubling.
  static constexpr std::size_t cells_per_point = unspecified_value;

  /// returns another `InsertionPlan`, made from the same seed.
  unspecified_type fallback_plan() const;

  /// @}
};
