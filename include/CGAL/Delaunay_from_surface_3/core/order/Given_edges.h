// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_GIVEN_EDGES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_GIVEN_EDGES_H

#include <CGAL/Delaunay_from_surface_3/core/interface/Edge_source.h>
#include <CGAL/Delaunay_from_surface_3/support/Lists.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstdint>
#include <utility>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Edges that are kept until they are given up.
class Given_edges final : public Edge_source
{
public:
  // None.
  Given_edges() = default;

  explicit Given_edges(Lists<std::uint32_t>&& lower)
    : m_lower(std::move(lower))
  {
  }
  Lists_view<std::uint32_t> edges() override { return m_lower; }
  void give_up() override { m_lower = Lists<std::uint32_t>(); }

private:
  Lists<std::uint32_t> m_lower;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_ORDER_GIVEN_EDGES_H
