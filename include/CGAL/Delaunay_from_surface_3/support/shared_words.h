// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_SHARED_WORDS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_SHARED_WORDS_H

// Words in ordinary memory that several threads read and write: the part of C++20's std::atomic_ref
// that is used, for C++17.
//
// On x86 every load acquires and every store releases, and compilers keep volatile accesses in
// their order: volatile words suffice if all shared data is read and written by these functions.
// GCC treats an atomic access as one to all memory, and loads every pointer again after it.

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <atomic>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// A loop prefetches memory so many steps ahead of its use; if the address is itself in prefetched
// memory, half the distance is for what is there. A hierarchy of nets of a scan of 603,000 points
// takes 0.139 s without, 0.130 at 4 steps, 0.119 to 0.126 at 8, 16, 32 or 64; with its vertices
// shuffled 0.169, 0.146, and 0.144 to 0.160 (medians of 8 in turn). So anything near 16 will do.
constexpr std::size_t prefetch_distance = 16;

// Tells the processor that *address will be read soon. It is only a hint, and any address will do.
inline void prefetch(const void* address)
{
#if defined(__GNUC__)
  __builtin_prefetch(address);
#else
  (void)address;
#endif
}

#if defined(CGAL_DELAUNAY_FROM_SURFACE_3_IS_WATCHED)
constexpr bool is_watched = true;
#else
constexpr bool is_watched = false;
#endif

#if defined(__x86_64__) && !defined(CGAL_DELAUNAY_FROM_SURFACE_3_IS_WATCHED)

template <class Word>
Word load_relaxed(const Word& w)
{
  return *static_cast<const volatile Word*>(&w);
}
template <class Word>
Word load_acquire(const Word& w)
{
  return *static_cast<const volatile Word*>(&w);
}
template <class Word>
void store_relaxed(Word& w, Word value)
{
  *static_cast<volatile Word*>(&w) = value;
}
template <class Word>
void store_release(Word& w, Word value)
{
  *static_cast<volatile Word*>(&w) = value;
}

#elif defined(__GNUC__) || defined(__clang__)

template <class Word>
Word load_relaxed(const Word& w)
{
  return __atomic_load_n(&w, __ATOMIC_RELAXED);
}
template <class Word>
Word load_acquire(const Word& w)
{
  return __atomic_load_n(&w, __ATOMIC_ACQUIRE);
}
template <class Word>
void store_relaxed(Word& w, Word value)
{
  __atomic_store_n(&w, value, __ATOMIC_RELAXED);
}
template <class Word>
void store_release(Word& w, Word value)
{
  __atomic_store_n(&w, value, __ATOMIC_RELEASE);
}

#else

// On all known compilers, a std::atomic of an integer that is always lock-free is that integer.
template <class Word>
std::atomic<Word>& as_atomic(const Word& w)
{
  static_assert(std::atomic<Word>::is_always_lock_free && sizeof(std::atomic<Word>) == sizeof(Word),
                "words are shared without locks");
  return reinterpret_cast<std::atomic<Word>&>(const_cast<Word&>(w));
}
template <class Word>
Word load_relaxed(const Word& w)
{
  return as_atomic(w).load(std::memory_order_relaxed);
}
template <class Word>
Word load_acquire(const Word& w)
{
  return as_atomic(w).load(std::memory_order_acquire);
}
template <class Word>
void store_relaxed(Word& w, Word value)
{
  as_atomic(w).store(value, std::memory_order_relaxed);
}
template <class Word>
void store_release(Word& w, Word value)
{
  as_atomic(w).store(value, std::memory_order_release);
}

#endif

// Fences are empty if no instruction is needed. ThreadSanitizer does not see them, and its
// compilers warn of them.
inline void acquire_fence()
{
#if !defined(__x86_64__) && !defined(CGAL_DELAUNAY_FROM_SURFACE_3_IS_WATCHED)
  std::atomic_thread_fence(std::memory_order_acquire);
#endif
}
inline void release_fence()
{
#if !defined(__x86_64__) && !defined(CGAL_DELAUNAY_FROM_SURFACE_3_IS_WATCHED)
  std::atomic_thread_fence(std::memory_order_release);
#endif
}

// Separates the stores before it from the loads after it. For ThreadSanitizer, an exchange of a
// word that no other thread has does the same on x86.
inline void full_fence()
{
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_IS_WATCHED
  std::atomic<int> word{0};
  word.exchange(1, std::memory_order_seq_cst);
#else
  std::atomic_thread_fence(std::memory_order_seq_cst);
#endif
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_SHARED_WORDS_H
