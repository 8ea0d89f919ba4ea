// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_STAGE_PROGRESS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_STAGE_PROGRESS_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_options.h>

#include <cstddef>
#include <functional>
#include <mutex>
#include <string>
#include <utility>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Says how much of a stage is done, to Tiles_options::progress, by one thread at a time; throws
// Tiles_stopped if that wants no more. Keeps a reference.
class Stage_progress
{
public:
  using Function = std::function<bool(const char*, std::size_t, std::size_t)>;

  Stage_progress(const Function& progress, std::string what, std::size_t all)
    : m_progress(progress)
    , m_what(std::move(what))
    , m_all(all)
  {
    tell();
  }

  void tell_next() const
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    ++m_done;
    tell();
  }

private:
  void tell() const
  {
    if (m_progress && !m_progress(m_what.c_str(), m_done, m_all))
      throw Tiles_stopped();
  }

  const Function& m_progress;
  const std::string m_what;
  const std::size_t m_all;
  mutable std::size_t m_done = 0;
  mutable std::mutex m_mutex;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_STAGE_PROGRESS_H
