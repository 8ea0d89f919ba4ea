// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_ARRAY_TARGET_3_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_ARRAY_TARGET_3_H

// The compact triangulation whose own cells become the arrays, in their place.

#include <CGAL/Delaunay_from_surface_3/Delaunay_3_arrays.h>
#include <CGAL/Delaunay_from_surface_3/arrays/flat_arrays.h>
#include <CGAL/Delaunay_from_surface_3/insertion/Compact_delaunay_3.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/partition_cells.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/starting_simplex.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

template <class Triangulation, class Index, class Executor>
class Array_target_3
  : public Compact_delaunay_with_ids_3<Triangulation, std::make_unsigned_t<Index>, Executor>
{
  using Id = std::make_unsigned_t<Index>;
  using Base = Compact_delaunay_with_ids_3<Triangulation, Id, Executor>;
  using Arrays = Delaunay_3_arrays<Index>;

public:
  using Base::Base;

  // Nothing is written into a triangulation.
  void finish() { this->finish_insertions(); }

  // Of all points: which of them, by place, are a simplex of largest dimension.
  Starting_simplex simplex()
  {
    return starting_simplex(this->size(), [&](std::size_t i) { return coordinates_of_place(i); });
  }

  // Of the point at a place.
  const double* coordinates_of_place(std::size_t i)
  {
    return this->complex().exact_coordinates(Compact_complex<Id>::vertex_of_point(i));
  }

  // The triangles at the last point, which is none of `order`: the apex off the plane of the others.
  Arrays take_arrays_at_apex(const std::vector<std::size_t>& order)
  {
    std::vector<Index> names = names_of_vertices(order);
    names.push_back(Arrays::none);
    typename Arrays::Entries rows;
    const auto [finite, all] =
        triangles_at(this->complex(), this->vertex(order.size()), names, rows);
    return Arrays(2, finite, all, std::move(rows), vertices_of_points(order, names));
  }

  // order[k] is the index of the point at place k. To be called last.
  Arrays take_arrays(const std::vector<std::size_t>& order)
  {
    auto& complex = this->complex();
    complex.deallocate_vertices();
    const Numbers_of_cells numbers = partition_cells(complex);
    const std::vector<Index> names = names_of_vertices(order);
    rename(complex.cells(), complex.cells() + numbers.all, names);
    return Arrays(3, numbers.finite, numbers.all, typename Arrays::Entries(complex.take_cells()),
                  vertices_of_points(order, names));
  }

private:
  // By vertex: the smallest index of its points.
  std::vector<Index> names_of_vertices(const std::vector<std::size_t>& order) const
  {
    std::vector<Index> names(order.size() + 1, Arrays::none);
    for (std::size_t k = 0; k < order.size(); ++k) {
      Index& name = names[this->vertex(k)];
      name = name == Arrays::none ? Index(order[k]) : (std::min)(name, Index(order[k]));
    }
    return names; // that of the infinite vertex, 0, is none
  }

  // By point: the name of its vertex.
  std::vector<Index> vertices_of_points(const std::vector<std::size_t>& order,
                                        const std::vector<Index>& names) const
  {
    std::vector<Index> vertices(order.size());
    for (std::size_t k = 0; k < order.size(); ++k)
      vertices[order[k]] = names[this->vertex(k)];
    return vertices;
  }

  // Ids of vertices become indices of points, and links the numbers of neighbours.
  template <class Cell>
  static void rename(Cell* first, Cell* last, const std::vector<Index>& names)
  {
    for (; first != last; ++first)
      for (std::size_t k = 0; k < 4; ++k) {
        first->v[k] = Id(names[first->v[k]]);
        first->links[k] >>= 2;
      }
  }
};

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_ARRAY_TARGET_3_H
