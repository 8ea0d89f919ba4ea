// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The kernels, and the vertex and cell bases, that a user may bring.

#include "check_insertion.h"
#include "insertion_ways.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Filtered_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/Tracing_traits_3.h>

#include <string>
#include <vector>

namespace fuzz {
namespace {

using namespace CGAL;
using Epick = Exact_predicates_inexact_constructions_kernel;
using Epeck = Exact_predicates_exact_constructions_kernel;

template <class Kernel>
using Cell_base = Delaunay_triangulation_cell_base_3<Kernel>;

using Info_tds = Triangulation_data_structure_3<
    Triangulation_vertex_base_with_info_3<std::string, Epick>,
    Triangulation_cell_base_with_info_3<std::vector<int>, Epick, Cell_base<Epick>>>;
using Parallel_tds = Triangulation_data_structure_3<Triangulation_vertex_base_3<Epick>,
                                                    Cell_base<Epick>, Parallel_tag>;

using With_info = Delaunay_triangulation_3<Epick, Info_tds>;
using Fast = Delaunay_triangulation_3<Epick, Fast_location>;
using Exact = Delaunay_triangulation_3<Epeck>;
using Filtered = Delaunay_triangulation_3<Filtered_kernel<Simple_cartesian<double>>>;
#ifdef CGAL_LINKED_WITH_TBB
using Parallel = Delaunay_triangulation_3<Epick, Parallel_tds>;
#endif

} // namespace

std::vector<Insertion_way> ways_by_triangulation()
{
  return {
      {"bases with info", check_insertion<With_info, Surface_insertion_traits_3, As_soup>},
      {"Fast_location", check_insertion<Fast, Surface_insertion_traits_3, As_soup>},
      {"Fast_location, tracing", check_insertion<Fast, Tracing_traits_3, As_mesh>},
#ifdef CGAL_LINKED_WITH_TBB
      {"Parallel_tag", check_insertion<Parallel, Surface_insertion_traits_3, As_soup>},
      {"Parallel_tag, tracing", check_insertion<Parallel, Tracing_traits_3, As_soup>},
#endif
      {"Epeck", check_insertion<Exact, Surface_insertion_traits_3, As_soup>},
      {"Epeck, tracing", check_insertion<Exact, Tracing_traits_3, As_mesh>},
      {"filtered doubles", check_insertion<Filtered, Surface_insertion_traits_3, As_graph>},
  };
}

} // namespace fuzz
