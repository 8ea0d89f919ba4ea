// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_FAILING_ALLOCATIONS_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_FAILING_ALLOCATIONS_H

// Replaces the allocation of the whole program: the k-th allocation, of the thread that asks for it
// or of all others, fails. For a single unit of a program. Where the linker wraps `calloc`
// (--wrap=calloc), that fails, too; then TESTS_WRAP_CALLOC is defined.

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace tests {

enum class Allocating { NOBODY, CALLER, OTHERS };

// Whose k-th allocation fails; once.
class Failing_allocation
{
public:
  Failing_allocation(Allocating who, long k)
  {
    is_caller = true;
    countdown = k;
    whose = who;
  }
  Failing_allocation(const Failing_allocation&) = delete;
  Failing_allocation& operator=(const Failing_allocation&) = delete;
  ~Failing_allocation()
  {
    whose = Allocating::NOBODY;
    is_caller = false;
  }

  bool has_failed() const { return countdown <= 0; }

  static bool fails_now()
  {
    const Allocating who = whose;
    return who != Allocating::NOBODY && (who == Allocating::CALLER) == is_caller &&
           countdown.fetch_sub(1) == 1;
  }

private:
  static inline std::atomic<Allocating> whose{Allocating::NOBODY};
  static inline std::atomic<long> countdown{0};
  static inline thread_local bool is_caller = false;
};

inline void* allocate(std::size_t size, std::size_t alignment)
{
  if (Failing_allocation::fails_now())
    throw std::bad_alloc();
  const std::size_t rounded = (size + alignment - 1) / alignment * alignment;
  if (void* p = std::aligned_alloc(alignment, rounded == 0 ? alignment : rounded))
    return p;
  throw std::bad_alloc();
}

// A function of its own: where a compiler sees free() take what operator new has returned, it
// warns.
#if defined(__GNUC__)
__attribute__((noinline))
#endif
inline void
release(void* p) noexcept
{
  std::free(p);
}

} // namespace tests

void* operator new(std::size_t size)
{
  return tests::allocate(size, alignof(std::max_align_t));
}
void* operator new[](std::size_t size)
{
  return tests::allocate(size, alignof(std::max_align_t));
}
void* operator new(std::size_t size, std::align_val_t a)
{
  return tests::allocate(size, std::size_t(a));
}
void operator delete(void* p) noexcept
{
  tests::release(p);
}
void operator delete[](void* p) noexcept
{
  tests::release(p);
}
void operator delete(void* p, std::size_t) noexcept
{
  tests::release(p);
}
void operator delete[](void* p, std::size_t) noexcept
{
  tests::release(p);
}
void operator delete(void* p, std::align_val_t) noexcept
{
  tests::release(p);
}
void operator delete(void* p, std::size_t, std::align_val_t) noexcept
{
  tests::release(p);
}

#ifdef TESTS_WRAP_CALLOC
extern "C" {
void* __real_calloc(std::size_t number, std::size_t size);
void* __wrap_calloc(std::size_t number, std::size_t size)
{
  return tests::Failing_allocation::fails_now() ? nullptr : __real_calloc(number, size);
}
}
#endif

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_FAILING_ALLOCATIONS_H
