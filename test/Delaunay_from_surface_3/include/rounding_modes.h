// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_ROUNDING_MODES_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_ROUNDING_MODES_H

// What callers may have done to the arithmetic of their thread.

#include <CGAL/FPU.h>

#include <cfenv>

#if defined(__SSE2_MATH__) || defined(_M_X64)
#include <xmmintrin.h>
#endif

namespace fuzz {

struct Rounding_mode
{
  const char* name;
  int mode;
  bool takes_denormals_for_zero = false; // where it can be set
  bool is_set_by_cgal = false;           // who leaves alone what <cfenv> looks at
};

inline const Rounding_mode rounding_modes[] = {{"to nearest", FE_TONEAREST},
                                               {"upward", FE_UPWARD},
                                               {"downward", FE_DOWNWARD},
                                               {"toward zero", FE_TOWARDZERO},
                                               {"to nearest, no denormals", FE_TONEAREST, true},
                                               {"upward, no denormals", FE_UPWARD, true},
                                               {"upward by CGAL", FE_UPWARD, false, true}};

#if defined(__SSE2_MATH__) || defined(_M_X64)
inline constexpr unsigned bits_of_denormals = 0x8040;
inline unsigned bits_of_arithmetic()
{
  return _mm_getcsr() & bits_of_denormals;
}
inline void take_denormals_for_zero(bool is_on)
{
  _mm_setcsr((_mm_getcsr() & ~bits_of_denormals) | (is_on ? bits_of_denormals : 0));
}
#elif defined(__GNUC__) && defined(__aarch64__)
inline unsigned long long bits_of_arithmetic()
{
  unsigned long long word;
  __asm__ volatile("mrs %0, fpcr" : "=r"(word));
  return word;
}
inline void take_denormals_for_zero(bool is_on)
{
  const unsigned long long bit = 1 << 24, word = bits_of_arithmetic() & ~bit;
  __asm__ volatile("msr fpcr, %0" : : "r"(word | (is_on ? bit : 0)));
}
#else
inline unsigned bits_of_arithmetic()
{
  return 0;
}
inline void take_denormals_for_zero(bool) {}
#endif

struct Arithmetic
{
  int rounding = std::fegetround();
  CGAL::FPU_CW_t rounding_of_cgal = CGAL::FPU_get_cw();
  decltype(bits_of_arithmetic()) bits = bits_of_arithmetic();

  friend bool operator==(const Arithmetic& a, const Arithmetic& b)
  {
    return a.rounding == b.rounding && a.rounding_of_cgal == b.rounding_of_cgal && a.bits == b.bits;
  }
};

// Sets the caller's mode, and to nearest again.
class Rounding
{
public:
  explicit Rounding(const Rounding_mode& mode)
  {
    if (mode.is_set_by_cgal)
      CGAL::FPU_set_cw(CGAL_FE_UPWARD);
    else
      std::fesetround(mode.mode);
    take_denormals_for_zero(mode.takes_denormals_for_zero);
    m_arithmetic = Arithmetic();
  }
  ~Rounding()
  {
    std::fesetround(FE_TONEAREST);
    CGAL::FPU_set_cw(CGAL_FE_TONEAREST);
    take_denormals_for_zero(false);
  }
  Rounding(const Rounding&) = delete;
  Rounding& operator=(const Rounding&) = delete;
  bool is_kept() const { return Arithmetic() == m_arithmetic; }

private:
  Arithmetic m_arithmetic;
};

} // namespace fuzz

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_ROUNDING_MODES_H
