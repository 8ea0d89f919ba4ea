// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_BUCKETS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_BUCKETS_H

// Groups values by a key below n in linear time: linked lists in flat arrays. It turns what each v
// says of u into what u hears from all v: so the two darts of an edge meet where the cut needs it;
// elsewhere they need not. Cost: the array of heads is the caller's; two words per value.

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Index>
class Buckets
{
public:
  static constexpr Index empty = (std::numeric_limits<Index>::max)();

  void reserve(std::size_t number_of_values)
  {
    m_values.reserve(number_of_values);
    m_next.reserve(number_of_values);
  }

  // The head of a bucket is wherever the caller keeps it; it starts as `empty`.
  void add(Index& head, Index value)
  {
    m_values.push_back(value);
    m_next.push_back(head);
    head = static_cast<Index>(m_values.size() - 1);
  }

  template <class Function>
  void for_each(Index head, const Function& function) const
  {
    for (; head != empty; head = m_next[head])
      function(m_values[head]);
  }

private:
  std::vector<Index> m_values;
  std::vector<Index> m_next;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_BUCKETS_H
