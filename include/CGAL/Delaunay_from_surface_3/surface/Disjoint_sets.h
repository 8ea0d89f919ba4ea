// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_DISJOINT_SETS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_DISJOINT_SETS_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// boost::disjoint_sets over 0, …, n-1, with its storage. Not boost::disjoint_sets_with_storage:
// that takes pointers for property maps, whose get() cannot be found where
// <boost/graph/compressed_sparse_row_graph.hpp> was included first.
template <class Index>
class Disjoint_sets
{
  template <class T>
  using Map = boost::iterator_property_map<typename std::vector<T>::iterator,
                                           boost::typed_identity_property_map<Index>>;

public:
  explicit Disjoint_sets(std::size_t n)
    : m_rank(n)
    , m_parent(n)
    , m_sets(Map<unsigned char>(m_rank.begin()), Map<Index>(m_parent.begin()))
  {
    for (std::size_t i = 0; i < n; ++i)
      m_sets.make_set(static_cast<Index>(i));
  }

  Disjoint_sets(const Disjoint_sets&) = delete;
  Disjoint_sets& operator=(const Disjoint_sets&) = delete;

  // Unites the sets of a and b; returns false if they were one already.
  bool unite(Index a, Index b)
  {
    const Index s = m_sets.find_set(a), t = m_sets.find_set(b);
    if (s == t)
      return false;
    m_sets.link(s, t);
    return true;
  }

private:
  std::vector<unsigned char> m_rank; // at most log2 n
  std::vector<Index> m_parent;
  boost::disjoint_sets<Map<unsigned char>, Map<Index>> m_sets;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SURFACE_DISJOINT_SETS_H
