// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_ROUNDING_TO_NEAREST_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_ROUNDING_TO_NEAREST_H

#include <cfenv>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// Rounds to nearest while it lives, as the error bounds of the filters assume; a caller may be
// inside CGAL's Protect_FPU_rounding. What is the caller's is called in the caller's mode.
class Rounding_to_nearest
{
public:
  Rounding_to_nearest()
    : m_mode_of_caller(std::fegetround())
  {
    set(FE_TONEAREST);
  }
  Rounding_to_nearest(const Rounding_to_nearest&) = delete;
  Rounding_to_nearest& operator=(const Rounding_to_nearest&) = delete;
  ~Rounding_to_nearest() { set(m_mode_of_caller); }

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
      rounding.set(rounding.m_mode_of_caller);
    }
    ~Callback() { rounding.set(FE_TONEAREST); }
  };

  void set(int mode) const
  {
    if (m_mode_of_caller != FE_TONEAREST) // nearly never
      std::fesetround(mode);
  }

  const int m_mode_of_caller;
};

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_ROUNDING_TO_NEAREST_H
