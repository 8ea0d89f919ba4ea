// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_HAS_BUDGET_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_HAS_BUDGET_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Does a plan name a budget, and another plan for when it is exceeded?
template <class Plan, class = void>
struct Has_budget : std::false_type
{
};
template <class Plan>
struct Has_budget<Plan, std::void_t<decltype(Plan::cells_per_point),
                                    decltype(std::declval<const Plan&>().fallback_plan())>>
  : std::true_type
{
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_PAPER_HAS_BUDGET_H
