// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_WITH_CONCURRENCY_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_WITH_CONCURRENCY_H

// The policies of a traits class, with a target for many threads where a concurrency tag asks for
// it.

#include <CGAL/Delaunay_from_surface_3/internal/driver/Index_graph.h>
#include <CGAL/Delaunay_from_surface_3/internal/parallel/Tbb_executor.h>
#include <CGAL/Delaunay_from_surface_3/support/blocks.h>

#include <CGAL/Default.h>
#include <CGAL/tags.h>

#include <type_traits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// The target for many threads that stands beside `Target`; void if there is none.
template <class Target, class = void>
struct Parallel_target_of
{
  using type = void;
};
template <class Target>
struct Parallel_target_of<Target, std::void_t<typename Target::Parallel_target>>
{
  using type = typename Target::Parallel_target;
};

// May each of many threads have a copy of the hints?
template <class Hints, class = void>
struct Is_concurrent : std::false_type
{
};
template <class Hints>
struct Is_concurrent<Hints, std::void_t<decltype(Hints::is_concurrent)>>
  : std::bool_constant<Hints::is_concurrent>
{
};

template <class Traits>
class Parallel_policies
{
public:
  // Keeps a reference.
  explicit Parallel_policies(const Traits& traits)
    : m_traits(traits)
  {
  }

  const Traits& of_one_thread() const { return m_traits; }
  decltype(auto) surface_subgraph_object() const { return m_traits.surface_subgraph_object(); }
  decltype(auto) insertion_plan_object(unsigned int seed) const
  {
    return m_traits.insertion_plan_object(seed);
  }

  template <class Target, class Subgraph>
  using Insertion_hints_3 = typename Traits::template Insertion_hints_3<Target, Subgraph>;

  template <class Triangulation>
  struct Target
  {
    using Alone = typename Traits::template Insertion_target_3<Triangulation>;
    using Parallel = typename Parallel_target_of<Alone>::type;
    using Asked = std::conditional_t<std::is_void<Parallel>::value, Alone, Parallel>;
    using Hints = typename Traits::template Insertion_hints_3<Asked, Index_graph>;
    using type = std::conditional_t<Is_concurrent<Hints>::value, Asked, Alone>;
  };
  template <class Triangulation>
  using Insertion_target_3 = typename Target<Triangulation>::type;

private:
  const Traits& m_traits;
};

// What a concurrency tag asks for: Alone, or what runs many threads.
template <class Tag>
struct Executor_of_tag
{
  static constexpr bool is_parallel = std::is_convertible<Tag, Parallel_tag>::value;
  static_assert(!is_parallel || !std::is_void<Parallel_executor>::value,
                "Parallel_tag is enabled but TBB is unavailable.");
  using type = std::conditional_t<is_parallel, Parallel_executor, Alone>;
};

// The tag of a call: if that is Default, the one of the triangulation.
template <class ConcurrencyTag, class Triangulation>
using Executor_by_tag = Executor_of_tag<
    typename Default::Get<ConcurrencyTag, typename Triangulation::Concurrency_tag>::type>;

// The traits themselves where one thread is asked for.
template <class ConcurrencyTag, class Triangulation, class Traits>
decltype(auto) with_concurrency(const Triangulation&, const Traits& traits)
{
  if constexpr (Executor_by_tag<ConcurrencyTag, Triangulation>::is_parallel)
    return Parallel_policies<Traits>(traits);
  else
    return (traits);
}

// Those for one thread, whatever was asked for.
template <class Traits>
const Traits& of_one_thread(const Traits& traits)
{
  return traits;
}
template <class Traits>
const Traits& of_one_thread(const Parallel_policies<Traits>& traits)
{
  return traits.of_one_thread();
}

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_WITH_CONCURRENCY_H
