// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_IS_DETECTED_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_IS_DETECTED_H

// Detects what a user's type offers, by an alias template of the expression or member, as
// std::experimental::is_detected does (the detection idiom of W. E. Brown).

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cstddef>
#include <limits>
#include <type_traits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class Default, class Void, template <class...> class Operation, class... Types>
struct Detected_or
{
  static constexpr bool value = false;
  using type = Default;
};
template <class Default, template <class...> class Operation, class... Types>
struct Detected_or<Default, std::void_t<Operation<Types...>>, Operation, Types...>
{
  static constexpr bool value = true;
  using type = Operation<Types...>;
};

// Whether Operation<Types...> is a type.
template <template <class...> class Operation, class... Types>
constexpr bool is_detected = Detected_or<void, void, Operation, Types...>::value;

// That type, or else Default.
template <class Default, template <class...> class Operation, class... Types>
using detected_or_t = typename Detected_or<Default, void, Operation, Types...>::type;

// Whether faces may have such indices: integers, or classes that are converted to them.
template <class Index>
constexpr bool is_index = std::is_integral<Index>::value ||
                          (std::is_class<Index>::value &&
                           std::is_convertible<Index, std::size_t>::value &&
                           std::numeric_limits<Index>::is_specialized ==
                               std::numeric_limits<Index>::is_integer);

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_IS_DETECTED_H
