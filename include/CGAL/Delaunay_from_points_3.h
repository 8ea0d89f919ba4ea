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

is a `Delaunay_triangulation_3` that inserts ranges by `insert_points_3()`. Used as the
triangulation type of `Alpha_shape_3`, `Fixed_alpha_shape_3`,
`Advancing_front_surface_reconstruction` or your own templates, it makes these faster without any
other change.

In all other respects it is a `Delaunay_triangulation_3`: it has the same vertices, cells and
functions, and the result is equal. Of several pairs with equal points the first determines the info
of the vertex, as in `insert_points_3()`.

\tparam Gt,Tds,Lp,Slds the parameters of `Delaunay_triangulation_3`. With a `Tds` for
`Parallel_tag`, many threads insert.
*/
template <class Gt, class Tds = Default, class Lp = Default, class Slds = Default>
class Delaunay_from_points_3 : public Delaunay_triangulation_3<Gt, Tds, Lp, Slds>
{
  template <class Iterator>
  static constexpr bool is_range_of =
      Delaunay_from_surface_3::internal::is_iterator<Iterator> &&
      !std::is_convertible<Iterator,
                           typename Delaunay_triangulation_3<Gt, Tds, Lp, Slds>::Point>::value;

public:
  /// the base class.
  using Base = Delaunay_triangulation_3<Gt, Tds, Lp, Slds>;

  /// constructs an empty triangulation.
  explicit Delaunay_from_points_3(const Gt& gt = Gt())
    : Base(gt)
  {
  }

  /// constructs the triangulation of the points in the range [`first`, `last`), which may be pairs
  /// of a point and an info. The arguments `rest` are passed to the constructor of `Base`:
  /// geometric traits, a lock data structure, or nothing.
  template <class InputIterator, class... Rest>
  Delaunay_from_points_3(InputIterator first, InputIterator last, const Rest&... rest)
    : Base(rest...)
  {
    insert(first, last);
  }

  /// constructs an empty triangulation with a lock data structure.
  template <class LockDataStructure>
  explicit Delaunay_from_points_3(LockDataStructure* lock_ds, const Gt& gt = Gt())
    : Base(lock_ds, gt)
  {
  }
  /// \cond SKIP_IN_MANUAL
  template <class LockDataStructure>
  Delaunay_from_points_3(const Gt& gt, LockDataStructure* lock_ds)
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

  /// inserts one point by `Delaunay_triangulation_3::insert()`, to which `rest` is passed.
  template <class... Rest>
  typename Base::Vertex_handle insert(const typename Base::Point& p, const Rest&... rest)
  {
    return Base::insert(p, rest...);
  }
};

} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_POINTS_3_H
