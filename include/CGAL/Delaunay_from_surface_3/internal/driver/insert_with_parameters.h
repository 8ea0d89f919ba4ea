// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_INSERT_WITH_PARAMETERS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_INSERT_WITH_PARAMETERS_H

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_from_surface_3/internal/driver/insert_surface.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/iterator.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {

// A visitor in std::ref() serves as it is. Any other is copied, since its functions may change it;
// get_parameter_reference() gives a reference to what is gone by then.
template <class Visitor>
Visitor visitor_of(const Visitor& visitor)
{
  return visitor;
}

template <class Visitor>
Visitor& visitor_of(const std::reference_wrapper<Visitor>& visitor)
{
  return visitor;
}

// The parameters that all forms share: seed, visitor, and what is done with the vertices.
template <class Triangulation, class Graph, class VertexIndexMap, class Traits,
          class NamedParameters, class NameOf>
std::ptrdiff_t
insert_with_parameters(Triangulation& tr, const std::vector<typename Triangulation::Point>& points,
                       const std::optional<std::string>& irregularity, const Graph& graph,
                       VertexIndexMap index_map, const Traits& traits, const NamedParameters& np,
                       const NameOf& name_of)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  auto&& visitor = visitor_of(choose_parameter<Default_surface_insertion_visitor_3>(
      get_parameter(np, internal_np::visitor)));
  const auto seed =
      static_cast<unsigned int>(choose_parameter(get_parameter(np, internal_np::random_seed), 0));
  auto out = choose_parameter(get_parameter(np, internal_np::vertex_to_vertex_output_iterator),
                              Emptyset_iterator());

  if (irregularity)
    visitor.surface_is_irregular(*irregularity);
  const auto before = static_cast<std::ptrdiff_t>(tr.number_of_vertices());
  insert_surface(tr, points, graph, index_map, traits, seed, visitor, [&](const auto& vertices) {
    for (std::size_t i = 0; i < vertices.size(); ++i)
      if (vertices[i] != typename Triangulation::Vertex_handle())
        *out++ = std::make_pair(name_of(i), vertices[i]);
  });
  return static_cast<std::ptrdiff_t>(tr.number_of_vertices()) - before;
}

} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_INTERNAL_DRIVER_INSERT_WITH_PARAMETERS_H
