// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_CHECK_NAMED_PARAMETERS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_CHECK_NAMED_PARAMETERS_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <CGAL/Named_function_parameters.h>

#include <type_traits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Never defined: compilers say so with its name and the parameter, as no static_assert can.
template <class Tag>
struct this_function_does_not_know_that_named_parameter_see_its_documentation;

template <class Tag, bool is_known>
struct Named_parameter
{
  static constexpr bool is_right = true;
};

template <class Tag>
struct Named_parameter<Tag, false>
  : this_function_does_not_know_that_named_parameter_see_its_documentation<Tag>
{
  static constexpr bool is_right = true; // one error is enough
};

template <class NamedParameters, class... Known>
struct Named_parameters_are_known : std::true_type
{
};

// Looks at the last parameter of the sequence, and then at the ones before it.
template <class T, class Tag, class Base, class... Known>
struct Named_parameters_are_known<Named_function_parameters<T, Tag, Base>, Known...>
  : std::bool_constant<Named_parameter<Tag, (std::is_same<Tag, internal_np::all_default_t>::value ||
                                             ... || std::is_same<Tag, Known>::value)>::is_right &&
                       Named_parameters_are_known<Base, Known...>::value>
{
};

// Does not compile if there is a named parameter whose tag is not among `Known`: it would have no
// effect.
template <class... Known, class NamedParameters>
constexpr bool check_named_parameters(const NamedParameters&)
{
  return Named_parameters_are_known<NamedParameters, Known...>::value;
}

// True if the parameter with that tag is given.
template <class NamedParameters, class Tag>
constexpr bool is_given = !parameters::is_default_parameter<NamedParameters, Tag>::value;

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_ADAPTERS_CHECK_NAMED_PARAMETERS_H
