// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_FORM_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_FORM_H

// Detects what a user's type offers, by an alias template of the expression or member, as
// std::experimental::is_detected does (the detection idiom of W. E. Brown).

#include <cstddef>
#include <limits>
#include <type_traits>

// The form in which the package is used gives the names of two inline namespaces, so that one
// program may mix forms: header-only (the default) or with the core compiled
// (CGAL_DELAUNAY_FROM_SURFACE_3_COMPILED, which the target Delaunay_from_surface_3::compiled
// defines), this version or another, units with more instructions or more checks than others. Of
// two functions with one name a linker keeps either, even one with instructions that the machine
// lacks.
//
//   …_FORM       code that each unit compiles for itself: bodies, and types that only they see;
//   …_INTERFACE  code that the compiled core and its callers share: declarations, abstract classes,
//                structs of pointers and numbers. Nothing there depends on a unit's options.
//   …_FILES      shared by the file side of tiles and its callers: see below.

#define CGAL_DELAUNAY_FROM_SURFACE_3_VERSION v0_1_0

#if defined(CGAL_NO_ASSERTIONS) || defined(CGAL_NDEBUG) || (defined(NDEBUG) && !defined(CGAL_DEBUG))
#define CGAL_DELAUNAY_FROM_SURFACE_3_CHECKS unchecked
#elif defined(CGAL_CHECK_EXPENSIVE)
#define CGAL_DELAUNAY_FROM_SURFACE_3_CHECKS checked_at_any_price
#else
#define CGAL_DELAUNAY_FROM_SURFACE_3_CHECKS checked
#endif

#if defined(__AVX512F__)
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSTRUCTIONS avx512
#elif defined(__AVX2__)
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSTRUCTIONS avx2
#elif defined(__AVX__)
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSTRUCTIONS avx
#elif defined(__SSE4_1__)
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSTRUCTIONS sse4
#else
#define CGAL_DELAUNAY_FROM_SURFACE_3_INSTRUCTIONS base
#endif

#if defined(__FAST_MATH__)
#define CGAL_DELAUNAY_FROM_SURFACE_3_ARITHMETIC fast
#elif defined(__FMA__)
#define CGAL_DELAUNAY_FROM_SURFACE_3_ARITHMETIC fused
#else
#define CGAL_DELAUNAY_FROM_SURFACE_3_ARITHMETIC strict
#endif

#if defined(CGAL_DELAUNAY_FROM_SURFACE_3_LIBRARY) // in the compiled core itself
#define CGAL_DELAUNAY_FROM_SURFACE_3_KIND library
#elif defined(CGAL_DELAUNAY_FROM_SURFACE_3_COMPILED)
#define CGAL_DELAUNAY_FROM_SURFACE_3_KIND compiled
#else
#define CGAL_DELAUNAY_FROM_SURFACE_3_KIND header_only
#endif

#define CGAL_DELAUNAY_FROM_SURFACE_3_JOINED(a, b, c, d, e) a##_##b##_##c##_##d##_##e
#define CGAL_DELAUNAY_FROM_SURFACE_3_JOIN(a, b, c, d, e)                                           \
  CGAL_DELAUNAY_FROM_SURFACE_3_JOINED(a, b, c, d, e)

#define CGAL_DELAUNAY_FROM_SURFACE_3_FORM                                                          \
  CGAL_DELAUNAY_FROM_SURFACE_3_JOIN(                                                               \
      CGAL_DELAUNAY_FROM_SURFACE_3_VERSION, CGAL_DELAUNAY_FROM_SURFACE_3_KIND,                     \
      CGAL_DELAUNAY_FROM_SURFACE_3_CHECKS, CGAL_DELAUNAY_FROM_SURFACE_3_INSTRUCTIONS,              \
      CGAL_DELAUNAY_FROM_SURFACE_3_ARITHMETIC)

// ThreadSanitizer understands atomic words, but neither fences nor vectors.
#if defined(__SANITIZE_THREAD__)
#define CGAL_DELAUNAY_FROM_SURFACE_3_IS_WATCHED
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define CGAL_DELAUNAY_FROM_SURFACE_3_IS_WATCHED
#endif
#endif

// For functions that are no templates.
#if defined(CGAL_DELAUNAY_FROM_SURFACE_3_LIBRARY)
#define CGAL_DELAUNAY_FROM_SURFACE_3_INLINE
#else
#define CGAL_DELAUNAY_FROM_SURFACE_3_INLINE inline
#endif

#if defined(CGAL_DELAUNAY_FROM_SURFACE_3_COMPILED)
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE                                                     \
  CGAL_DELAUNAY_FROM_SURFACE_3_JOIN(CGAL_DELAUNAY_FROM_SURFACE_3_VERSION, of, the, compiled, core)
#else
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE CGAL_DELAUNAY_FROM_SURFACE_3_FORM
#endif

// The file side of tiles, which is compiled, shares structs of the standard library's containers, whose
// members every unit compiles, with its callers; they differ in the library's debug mode.
#if !defined(CGAL_DELAUNAY_FROM_SURFACE_3_COMPILED)
#define CGAL_DELAUNAY_FROM_SURFACE_3_FILES CGAL_DELAUNAY_FROM_SURFACE_3_FORM
#elif defined(_GLIBCXX_DEBUG)
#define CGAL_DELAUNAY_FROM_SURFACE_3_FILES                                                         \
  CGAL_DELAUNAY_FROM_SURFACE_3_JOIN(CGAL_DELAUNAY_FROM_SURFACE_3_VERSION, of, the, debug, files)
#else
#define CGAL_DELAUNAY_FROM_SURFACE_3_FILES                                                         \
  CGAL_DELAUNAY_FROM_SURFACE_3_JOIN(CGAL_DELAUNAY_FROM_SURFACE_3_VERSION, of, the, compiled, files)
#endif

// Code shared by functions for several instruction sets must be inlined into each.
#if defined(__GNUC__)
#define CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE __attribute__((always_inline)) inline
#else
#define CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE inline
#endif

// Code that is rarely reached must not take registers from code that often is.
#if defined(__GNUC__)
#define CGAL_DELAUNAY_FROM_SURFACE_3_APART __attribute__((noinline)) inline
#else
#define CGAL_DELAUNAY_FROM_SURFACE_3_APART inline
#endif

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
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

// Tells whether Operation<Types...> is a type.
template <template <class...> class Operation, class... Types>
constexpr bool is_detected = Detected_or<void, void, Operation, Types...>::value;

// Is Operation<Types...> if this is a type, and else Default.
template <class Default, template <class...> class Operation, class... Types>
using detected_or_t = typename Detected_or<Default, void, Operation, Types...>::type;

// Tells whether faces may have such indices: integers, or classes that are converted to them.
template <class Index>
constexpr bool is_index = std::is_integral<Index>::value ||
                          (std::is_class<Index>::value &&
                           std::is_convertible<Index, std::size_t>::value &&
                           std::numeric_limits<Index>::is_specialized ==
                               std::numeric_limits<Index>::is_integer);

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core

// The other rooms know the core and what it stands on.
namespace internal {
using namespace core;
}

} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_FORM_H
