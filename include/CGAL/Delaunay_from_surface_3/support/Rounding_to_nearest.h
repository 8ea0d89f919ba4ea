// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_ROUNDING_TO_NEAREST_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_ROUNDING_TO_NEAREST_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <cfenv>

#if defined(__SSE2_MATH__) || defined(_M_X64)
#include <xmmintrin.h>
#endif

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The floating-point mode of a thread: how it rounds, and whether it treats denormal numbers as
// zero, which some libraries for sound, images or learning leave switched on.
class Floating_point_mode
{
public:
  // Reads the mode of this thread.
  Floating_point_mode()
    : m_rounding(std::fegetround())
    , m_word(word() & mask)
  {
  }

  // Returns whether all results are rounded to nearest, and no bit of the word is set.
  bool is_to_nearest() const { return m_rounding == FE_TONEAREST && m_word == 0; }

  void set() const { set(m_rounding, m_word); }
  static void set_to_nearest() { set(FE_TONEAREST, 0); }

private:
#if defined(__SSE2_MATH__) || defined(_M_X64)
  // std::fegetround() reads only the mode of the older unit, and CGAL changes only this one.
  using Word = unsigned int;
  static constexpr Word mask = 0xe040; // flush to zero, rounding, denormals are zeros
  static Word word()
  {
    return _mm_getcsr();
  }
  static void set_word(Word word)
  {
    _mm_setcsr(word);
  }
#elif defined(__GNUC__) && defined(__aarch64__)
  using Word = unsigned long long;
  static constexpr Word mask = 0x1c00001; // flush to zero, rounding, flush inputs to zero
  static Word word()
  {
    Word word;
    __asm__ volatile("mrs %0, fpcr" : "=r"(word));
    return word;
  }
  static void set_word(Word word)
  {
    __asm__ volatile("msr fpcr, %0" : : "r"(word) : "memory");
  }
#else
  using Word = unsigned int;
  static constexpr Word mask = 0;
  static Word word()
  {
    return 0;
  }
  static void set_word(Word) {}
#endif

  // Other bits, such as the exception flags, are kept.
  static void set(int rounding, Word bits)
  {
    std::fesetround(rounding);
    set_word((word() & ~mask) | bits);
  }

  int m_rounding;
  Word m_word;
};

// Rounds to nearest while it lives, and keeps denormal numbers, as the error bounds of the filters
// assume; a caller may be inside CGAL's Protect_FPU_rounding. Functions of the caller are called in
// the caller's mode.
class Rounding_to_nearest
{
public:
  Rounding_to_nearest()
  {
    if (!is_mode_of_caller())
      Floating_point_mode::set_to_nearest();
  }
  Rounding_to_nearest(const Rounding_to_nearest&) = delete;
  Rounding_to_nearest& operator=(const Rounding_to_nearest&) = delete;
  ~Rounding_to_nearest()
  {
    if (!is_mode_of_caller())
      m_mode_of_caller.set();
  }

  // Calls f() in the caller's mode.
  template <class F>
  decltype(auto) in_mode_of_caller(const F& f) const
  {
    const Callback callback(*this);
    return f();
  }

private:
  struct Callback
  {
    const Rounding_to_nearest& rounding;
    explicit Callback(const Rounding_to_nearest& r)
      : rounding(r)
    {
      if (!rounding.is_mode_of_caller())
        rounding.m_mode_of_caller.set();
    }
    ~Callback()
    {
      if (!rounding.is_mode_of_caller())
        Floating_point_mode::set_to_nearest();
    }
  };

  bool is_mode_of_caller() const { return m_mode_of_caller.is_to_nearest(); } // nearly always

  const Floating_point_mode m_mode_of_caller;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_ROUNDING_TO_NEAREST_H
