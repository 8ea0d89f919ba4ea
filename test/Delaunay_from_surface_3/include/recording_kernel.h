// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_RECORDING_KERNEL_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_RECORDING_KERNEL_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <boost/functional/hash.hpp>

#include <cstddef>
#include <memory>
#include <vector>

namespace tests {

// A user's traits class: it writes down every call of the two predicates that decide an insertion,
// with the points, in one vector that all copies share.
class Recording_kernel : public CGAL::Exact_predicates_inexact_constructions_kernel
{
  using Base = CGAL::Exact_predicates_inexact_constructions_kernel;

  template <class Predicate>
  struct Recording
  {
    template <class... Points>
    auto operator()(const Points&... points) const
    {
      std::size_t call = sizeof(Predicate) + sizeof...(points);
      (add(call, points), ...);
      calls->push_back(call);
      return predicate(points...);
    }

    static void add(std::size_t& call, const Base::Point_3& p)
    {
      boost::hash_combine(call, p.x());
      boost::hash_combine(call, p.y());
      boost::hash_combine(call, p.z());
    }

    Predicate predicate;
    std::vector<std::size_t>* calls;
  };

public:
  using Orientation_3 = Recording<Base::Orientation_3>;
  using Side_of_oriented_sphere_3 = Recording<Base::Side_of_oriented_sphere_3>;

  Orientation_3 orientation_3_object() const
  {
    return {Base::orientation_3_object(), m_calls.get()};
  }
  Side_of_oriented_sphere_3 side_of_oriented_sphere_3_object() const
  {
    return {Base::side_of_oriented_sphere_3_object(), m_calls.get()};
  }

  const std::vector<std::size_t>& calls() const { return *m_calls; }

private:
  std::shared_ptr<std::vector<std::size_t>> m_calls = std::make_shared<std::vector<std::size_t>>();
};

} // namespace tests

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_RECORDING_KERNEL_H
