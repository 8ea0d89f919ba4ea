/*!
\ingroup PkgDelaunayFromSurface3Concepts
\cgalConcept

A `SurfaceInsertionTraits_3` combines a plan, a subgraph and a hint policy: everything that the
algorithm of the package leaves open. The functions of the package take an object of such a
class. None of its parts changes the resulting triangulation.

`CGAL::Surface_insertion_policies_3` makes a model from three parts.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Surface_insertion_traits_3}
\cgalHasModels{CGAL::Tracing_traits_3}
\cgalHasModels{CGAL::History_tracing_traits_3}
\cgalHasModels{CGAL::Plain_insertion_traits_3}
\cgalHasModels{CGAL::Surface_insertion_policies_3}
\cgalHasModelsEnd
*/
class SurfaceInsertionTraits_3
{
public:
  /// \name Types
  /// @{

  /// a model of `SurfaceSubgraph`.
  using Surface_subgraph = unspecified_type;

  /// a model of `InsertionPlan`.
  using Insertion_plan = unspecified_type;

  /// a model of `InsertionHints_3`. It is not used if `through_core` is `true`.
  template <class Target, class Subgraph>
  using Insertion_hints_3 = unspecified_type;

  /// @}

  /// \name Way
  /// @{

  /*!
  decides who inserts. If it is `true`, the core inserts the points into the compact triangulation,
  in the order of the plan and from the starting places that the plan names. Nothing is traced. If
  the core cannot be used, %CGAL's own insertion takes over, and the visitor is told. If it is
  `false`, %CGAL inserts, with T and traces.
  */
  static constexpr bool through_core = unspecified_value;

  /// @}

  /// \name Operations
  /// @{

  /// returns the function object that makes T. It is called only if the hint policy uses T.
  Surface_subgraph surface_subgraph_object() const;

  /// returns the function object that makes order and rounds, with random choices from `seed`.
  Insertion_plan insertion_plan_object(unsigned int seed) const;

  /// @}
};
