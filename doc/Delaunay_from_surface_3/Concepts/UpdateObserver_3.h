/*!
\ingroup PkgDelaunayFromSurface3Concepts
\cgalConcept

An `UpdateObserver_3` is told by `CGAL::Delaunay_from_surface_3::Triangulation_target_3` what each
insertion changes (\cgalCite{choi-dtsm-02}, Fig.\ 1, line 2c). Points are identified by their
numbers in the target.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Delaunay_from_surface_3::Null_update_observer}
\cgalHasModels{CGAL::Delaunay_from_surface_3::Conflict_history_3<Triangulation>}
\cgalHasModelsBare{all models of `InsertionHints_3`}
\cgalHasModelsEnd
*/
class UpdateObserver_3
{
public:
  /*!
  says, at compile time, whether `before_update()` is to be called. If it is `false`, the target
  need not compute the conflict zone separately, and inserts in the fastest way.
  */
  static constexpr bool observes_conflict_zone = unspecified_value;

  /*!
  is called before point `i` is inserted, if `observes_conflict_zone` is `true` and the target knows
  the conflict zone: in dimension 3, without `Fast_location`, for points that have no vertex yet.

  \tparam CellIterator an input iterator with the value type `Cell` of the target
  \param i the number of the point
  \param first,last the cells that the insertion will destroy. They still exist.
  */
  template <class CellIterator>
  void before_update(std::size_t i, CellIterator first, CellIterator last);

  /*!
  is called after point `i` was inserted.

  \tparam Vertex the type `Vertex` of the target
  \param i the number of the point
  \param v its vertex: a new one, or the existing one if the point is a duplicate
  */
  template <class Vertex>
  void after_update(std::size_t i, Vertex v);
};
