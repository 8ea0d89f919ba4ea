// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_POINTS_3_H
#define CGAL_DELAUNAY_FROM_POINTS_3_H

#include <CGAL/insert_points_3.h>

#include <CGAL/Default.h>
#include <CGAL/Delaunay_triangulation_3.h>

#include <cstddef>
#include <type_traits>

namespace CGAL {

/*!
\ingroup PkgDelaunayFromSurface3Points

is a `Delaunay_triangulation_3` or a `Regular_triangulation_3` that inserts ranges by
`insert_points_3()`; its short names are `Delaunay_from_points_3` and `Regular_from_points_3`. Used
as the triangulation type of `Alpha_shape_3`, `Fixed_alpha_shape_3`,
`Advancing_front_surface_reconstruction` or your own templates, it makes these faster without any
other change.

In all other respects it is its base class: it has the same vertices, cells and functions, and the
result is equal. Of several pairs with equal points the first determines the info of the vertex, as
in `insert_points_3()`. If the `Tds` is one for `Parallel_tag`, many threads insert.

\tparam Triangulation the base class
*/
template <class Triangulation>
class Triangulation_from_points_3 : public Triangulation
{
  template <class Iterator>
  static constexpr bool is_range_of =
      Delaunay_from_surface_3::internal::is_iterator<Iterator> &&
      !std::is_convertible<Iterator, typename Triangulation::Point>::value;

public:
  /// the base class.
  using Base = Triangulation;

  /// constructs an empty triangulation.
  explicit Triangulation_from_points_3(
      const typename Base::Geom_traits& gt = typename Base::Geom_traits())
    : Base(gt)
  {
  }

  /// constructs the triangulation of the points in the range [`first`, `last`), which may be pairs
  /// of a point and an info. The arguments `rest` are passed to the constructor of `Base`:
  /// geometric traits, a lock data structure, both where `Base` takes them, or nothing.
  template <class InputIterator, class... Rest>
  Triangulation_from_points_3(InputIterator first, InputIterator last, const Rest&... rest)
    : Base(rest...)
  {
    insert(first, last);
  }

  /// constructs an empty triangulation with a lock data structure.
  template <class LockDataStructure>
  explicit Triangulation_from_points_3(
      LockDataStructure* lock_ds,
      const typename Base::Geom_traits& gt = typename Base::Geom_traits())
    : Base(lock_ds, gt)
  {
  }
  /// \cond SKIP_IN_MANUAL
  template <class LockDataStructure>
  Triangulation_from_points_3(const typename Base::Geom_traits& gt, LockDataStructure* lock_ds)
    : Base(gt, lock_ds)
  {
  }
  /// \endcond

  /// inserts the points in the range [`first`, `last`), or the pairs of a point and an info, by
  /// `insert_points_3()`, and returns the number of vertices gained.
  template <class InputIterator>
#ifdef DOXYGEN_RUNNING
  std::ptrdiff_t
#else
  std::enable_if_t<is_range_of<InputIterator>, std::ptrdiff_t>
#endif
  insert(InputIterator first, InputIterator last)
  {
    return insert_points_3(static_cast<Base&>(*this), first, last);
  }

  /// inserts one point by `Base::insert()`, to which `rest` is passed.
  template <class... Rest>
  typename Base::Vertex_handle insert(const typename Base::Point& p, const Rest&... rest)
  {
    return Base::insert(p, rest...);
  }
};

/// \ingroup PkgDelaunayFromSurface3Points
/// is a `Delaunay_triangulation_3`, of the same parameters, that inserts ranges by
/// `insert_points_3()`.
template <class Gt, class Tds = Default, class Lp = Default, class Slds = Default>
using Delaunay_from_points_3 =
    Triangulation_from_points_3<Delaunay_triangulation_3<Gt, Tds, Lp, Slds>>;

} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_POINTS_3_H
