// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_INSERTER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_INSERTER_H

// An insertion (Bowyer 1981; Watson 1981) on numbered cells walks to a conflict, digs the conflict
// zone, and fills the star (Choi 2002, Fig. 1, lines 2b and 2c). Each of the three has a header of
// its own; this one composes them, for a thread that is alone and for one that announces its zones
// (threads/Insertion_worker.h).

#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Compact_predicates.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Dig_conflict_zone.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Fill_star.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Sphere_filter.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Walk_to_conflict.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/vectors.h>

#include <utility>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Says how a thread that is alone looks at cells, and how it writes them.
template <class Vertex_>
struct Alone_with_complex
{
  using Vertex = Vertex_;
  using Zone = Conflict_zone;
  using Write = Write_alone<Vertex>;
  using Explore = Explore_neighbors;
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS
  using Wide_explore = Wide_explore_neighbors;
#endif

  Write write() const
  {
    return Write();
  }
  template <class Explorer>
  Explorer explore(Zone&) const
  {
    return Explorer();
  }
};

// Access says how cells are looked at and written.
template <class Access>
class Inserter
{
  using Vertex = typename Access::Vertex;
  using Complex = Compact_complex<Vertex>;

public:
  // Inserts into `complex`, which must have started. Keeps a reference.
  explicit Inserter(Complex& complex, const Access& access = Access())
    : m_complex(complex)
    , m_access(access)
    , m_fill_star(access.write())
  {
  }
  Inserter(const Inserter&) = delete;

  // Walks from the cell `start` to the place of vertex p, which is in no cell yet.
  template <class Read>
  Compact_location walk(Id p, Id start, Read&& read)
  {
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS
    if (m_is_wide)
      return Walk_to_conflict<Wide_sphere_filter, Read>()(m_complex, m_predicates, p, start,
                                                          std::forward<Read>(read));
#endif
    return Walk_to_conflict<Sphere_filter, Read>()(m_complex, m_predicates, p, start,
                                                   std::forward<Read>(read));
  }

  // Digs the zone of p from a cell in conflict; returns false if another thread was in the way.
  bool dig(Id p, Id cell)
  {
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS
    if (m_is_wide)
      return dig_in_vectors(p, cell);
#endif
    return dig<typename Access::Explore>(p, cell);
  }

  // Returns true if all that the dig read still holds.
  bool is_zone_still_true()
  {
    return with_explorer([&](const auto& explorer) {
      return explorer.is_still_true(m_complex.cells(), zone.number_of_cells);
    });
  }

  // Replaces the zone by the star of p.
  void fill(Id p)
  {
    m_fill_star(m_complex, zone, p);
  }

  typename Access::Zone zone; // the zone that was dug last

private:
  template <class Explorer>
  bool dig(Id p, Id cell)
  {
    Explorer explorer = m_access.template explore<Explorer>(zone);
    return Dig_conflict_zone<Explorer&>()(m_complex, m_predicates, zone, p, cell, explorer);
  }

#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS
  CGAL_DELAUNAY_FROM_SURFACE_3_ALL_IN_VECTORS bool dig_in_vectors(Id p, Id cell)
  {
    return dig<typename Access::Wide_explore>(p, cell);
  }
#endif

  template <class F>
  bool with_explorer(const F& f)
  {
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS
    if (m_is_wide)
      return f(m_access.template explore<typename Access::Wide_explore>(zone));
#endif
    return f(m_access.template explore<typename Access::Explore>(zone));
  }

  Complex& m_complex;
  const Access m_access;
  Compact_predicates<Vertex> m_predicates{m_complex, zone.counts};
  Fill_star<Vertex, typename Access::Write> m_fill_star;
#ifdef CGAL_DELAUNAY_FROM_SURFACE_3_HAS_VECTORS
  const bool m_is_wide = machine_has_vectors();
#endif
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_KERNEL_INSERTER_H
