// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_VECTORS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_VECTORS_H

// Functions in vector instructions for which the user need not compile: they are marked with their
// target, and called if the machine has it. Products are fused into sums if the compiler's options
// allow it (-ffp-contract), and filters are proved for either. A vector that is read from a vertex
// has one word more than the point. Other threads may write that word, but its lane is never used.
// ThreadSanitizer cannot know this, so there are no vectors if it watches.

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#if defined(__GNUC__) && defined(__x86_64__) && !defined(CGAL_DELAUNAY_FROM_SURFACE_3_IS_WATCHED)

#include <smmintrin.h> // not <immintrin.h>, which takes g++ 12 a hundred megabytes more

#include <type_traits>

#define CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS
#define CGAL_DELAUNAY_FROM_SURFACE_3_IN_VECTORS __attribute__((target("avx2,fma,popcnt")))
// A function with vectors is never inlined into one without; so all that it calls goes into it.
#define CGAL_DELAUNAY_FROM_SURFACE_3_ALL_IN_VECTORS                                                \
  __attribute__((target("avx2,fma,popcnt"), flatten))
#define CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS                                             \
  __attribute__((target("avx2,fma,popcnt"), always_inline)) inline
#else
#define CGAL_DELAUNAY_FROM_SURFACE_3_IN_VECTORS
#endif

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

inline bool machine_has_vectors()
{
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
         __builtin_cpu_supports("popcnt");
#else
  return false;
#endif
}

#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS

// Vectors with four or eight lanes, and the operators that GCC and clang give them.
using Four_doubles = double __attribute__((vector_size(32)));
using Four_longs = long long __attribute__((vector_size(32)));
using Four_words = unsigned __attribute__((vector_size(16)));
using Eight_words = unsigned __attribute__((vector_size(32)));

// Returns the lanes with these numbers, where 0 to 3 are lanes of a, and 4 to 7 lanes of b.
template <int i, int j, int k, int l, class Vector>
CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS Vector lanes_of(Vector a, Vector b)
{
#if defined(__clang__) || __GNUC__ >= 12
  return __builtin_shufflevector(a, b, i, j, k, l);
#else
  using Numbers = std::conditional_t<sizeof(Vector) == 32, Four_longs, Four_words>;
  return __builtin_shuffle(a, b, Numbers{i, j, k, l});
#endif
}
template <int i, int j, int k, int l, class Vector>
CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS Vector lanes_of(Vector a)
{
  return lanes_of<i, j, k, l>(a, a);
}

// Loads and stores at any address of a double, by copying: clang assumes that a vector type is
// aligned whatever its attributes say in an alias. Each is one instruction.
CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS Four_doubles load_four(const double* from)
{
  Four_doubles v;
  __builtin_memcpy(&v, from, sizeof v);
  return v;
}
CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS void store_four(double* to, Four_doubles v)
{
  __builtin_memcpy(to, &v, sizeof v);
}

CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS Four_doubles max_of(Four_doubles a, Four_doubles b)
{
  return a > b ? a : b;
}

// There is no operator for the square root.
CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS Four_doubles sqrt_of(Four_doubles v)
{
#if defined(__clang__) && __clang_major__ >= 18
  return __builtin_elementwise_sqrt(v);
#else
  return __builtin_ia32_sqrtpd256(v);
#endif
}

// Returns the words of v with the numbers in `which`.
CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS Eight_words words_of(Eight_words v,
                                                                    Eight_words which)
{
  using Eight_ints = int __attribute__((vector_size(32)));
  return reinterpret_cast<Eight_words>(__builtin_ia32_permvarsi256(
      reinterpret_cast<Eight_ints>(v), reinterpret_cast<Eight_ints>(which)));
}

// Returns bits, of which bit i is the result of a comparison in lane i.
CGAL_DELAUNAY_FROM_SURFACE_3_INLINE_IN_VECTORS unsigned bits_of(Four_longs comparison)
{
  return unsigned(__builtin_ia32_movmskpd256(reinterpret_cast<Four_doubles>(comparison)));
}

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_VECTORS_H
