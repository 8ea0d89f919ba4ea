/*!
\ingroup PkgDelaunayFromSurface3Concepts
\cgalConcept

A `SurfaceInsertionTraits_3` binds a plan, a subgraph, a hint policy and a target together: all that
the algorithm of the package leaves open. The functions of the package take an object of such a
class. None of its parts changes the triangulation that comes out.

`CGAL::Surface_insertion_policies_3` makes a model of four parts.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Surface_insertion_traits_3}
\cgalHasModels{CGAL::Point_insertion_traits_3}
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

  /// a model of `InsertionHints_3` for every subgraph, and for these targets: that of the traits, those
  /// that it names (`Wider_target`, and `Parallel_target` if the hints are concurrent), and
  /// `CGAL::Delaunay_from_surface_3::Triangulation_target_3`, which takes its place.
  template <class Target, class Subgraph>
  using Insertion_hints_3 = unspecified_type;

  /// a model of `InsertionTarget_3` for every `CGAL::Delaunay_triangulation_3`.
  template <class Triangulation>
  using Insertion_target_3 = unspecified_type;

  /// @}

  /// \name Operations
  /// @{

  /// returns the function object that makes T. It is called only if the hint policy uses T.
  Surface_subgraph surface_subgraph_object() const;

  /// returns the function object that makes order and rounds; its random choices come from `seed`.
  Insertion_plan insertion_plan_object(unsigned int seed) const;

  /// @}
};
