// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_RECORDING_KERNEL_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_RECORDING_KERNEL_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <boost/functional/hash.hpp>

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <vector>

namespace tests {

// A user's traits class: it writes down every call of the two predicates that decide an insertion,
// with the points, in one record that all copies share. It can be told to fail at a call.
class Recording_kernel : public CGAL::Exact_predicates_inexact_constructions_kernel
{
  using Base = CGAL::Exact_predicates_inexact_constructions_kernel;

  struct Record
  {
    std::vector<std::size_t> calls;
    std::size_t fails_at = std::size_t(-1);
  };

  template <class Predicate>
  struct Recording
  {
    template <class... Points>
    auto operator()(const Points&... points) const
    {
      std::size_t call = sizeof(Predicate) + sizeof...(points);
      (add(call, points), ...);
      if (record->calls.size() == record->fails_at)
        throw std::runtime_error("a predicate fails");
      record->calls.push_back(call);
      return predicate(points...);
    }

    static void add(std::size_t& call, const Base::Point_3& p)
    {
      boost::hash_combine(call, p.x());
      boost::hash_combine(call, p.y());
      boost::hash_combine(call, p.z());
    }

    Predicate predicate;
    Record* record;
  };

public:
  using Orientation_3 = Recording<Base::Orientation_3>;
  using Side_of_oriented_sphere_3 = Recording<Base::Side_of_oriented_sphere_3>;

  Orientation_3 orientation_3_object() const
  {
    return {Base::orientation_3_object(), m_record.get()};
  }
  Side_of_oriented_sphere_3 side_of_oriented_sphere_3_object() const
  {
    return {Base::side_of_oriented_sphere_3_object(), m_record.get()};
  }

  const std::vector<std::size_t>& calls() const { return m_record->calls; }
  void fail_at_call(std::size_t number) const { m_record->fails_at = number; }

private:
  std::shared_ptr<Record> m_record = std::make_shared<Record>();
};

} // namespace tests

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_RECORDING_KERNEL_H
