// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_CORE_INTERFACE_BUILT_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_CORE_INTERFACE_BUILT_H

#include <CGAL/Delaunay_from_surface_3/Insertion_counts.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Compact_cell.h>
#include <CGAL/Delaunay_from_surface_3/core/interface/Order_view.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/inlining.h>

#include <cstddef>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE {

enum class Insertion_outcome {
  COMPLETE,
  STOPPED,     // by the watcher
  OVER_BUDGET, // never returned: another order follows
  FLAT,        // nothing is inserted: the points lie in one plane
  TOO_FEW_IDS  // to number all cells
};

// What build() makes: a complex, in memory of the core, which can give it up piece by piece while
// it is read once.
//
// One vertex, one number: the point at place k of the order is vertex k + 1.
template <class Id>
class Built
{
public:
  virtual ~Built() = default;

  // The cells first, …, last - 1 are not read any more; none of the cells; none of the vertices.
  virtual void release_cells(std::size_t first, std::size_t last) = 0;
  virtual void give_up_cells() = 0;
  virtual void give_up_vertices() = 0;

  // The memory of the cells is the caller's from now on, that of a Page_array with such a capacity.
  virtual Compact_cell<Id>* take_cells(std::size_t& capacity) = 0;

  CGAL_DELAUNAY_FROM_SURFACE_3_ALWAYS_INLINE bool has_started() const { return cells_end > 0; }

  Insertion_outcome outcome = Insertion_outcome::FLAT;
  int dimension = -1;    // of the points as they came; of those accepted nothing is known
  bool has_apex = false; // as the last vertex, off the plane of all others
  Insertion_counts counts;

  Order_view order = {nullptr, 0, nullptr, 0, nullptr};
  const Id* vertex_of = nullptr; // by place: 0 if there is none; that of an apex is the last
  std::size_t number_of_places = 0;
  Compact_cell<Id>* cells = nullptr;
  std::size_t cells_end = 0; // dead ones too
  const Compact_vertex<Id>* vertices = nullptr;
  std::size_t vertices_end = 0; // 0 and unused ones too
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_CORE_INTERFACE_BUILT_H
