// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A peer of compare_with_plain: the Delaunay triangulation of HXT, which comes with Gmsh.

#include <Delaunay_from_surface_3_comparison/points_file.h>

#include <hxt_mesh.h>
#include <hxt_tetDelaunay.h>
#include <hxt_tools.h>

#include <omp.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

void check(HXTStatus status)
{
  if (status != HXT_STATUS_OK)
    throw std::runtime_error("HXT gave up with code " + std::to_string(status));
}

// As HXT wants them: four numbers for each point, the last one for its own use.
void give_points(HXTMesh& mesh, const std::vector<double>& coordinates)
{
  const std::size_t n = coordinates.size() / 3;
  check(hxtAlignedMalloc(&mesh.vertices.coord, 4 * n * sizeof(double)));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < 4; ++k)
      mesh.vertices.coord[4 * i + k] = k < 3 ? coordinates[3 * i + k] : 0;
  mesh.vertices.num = mesh.vertices.size = static_cast<std::uint32_t>(n);
}

// HXT keeps those with the vertex at infinity, too.
std::size_t number_of_finite_tetrahedra(const HXTMesh& mesh)
{
  std::size_t number = 0;
  for (std::uint64_t t = 0; t < mesh.tetrahedra.num; ++t)
    if (mesh.tetrahedra.node[4 * t + 3] != HXT_GHOST_VERTEX)
      ++number;
  return number;
}

} // namespace

int main(int argc, char** argv)
{
  return comparison::run_peer(
      "hxt_peer", true, argc, argv, [](unsigned threads, const std::vector<double>& coordinates) {
        omp_set_num_threads(int(threads)); // of the sort, too
        HXTMesh* mesh = nullptr;
        check(hxtMeshCreate(&mesh));
        give_points(*mesh, coordinates);
        HXTDelaunayOptions options = {};
        options.perfectDelaunay = 1;
        options.delaunayThreads = int(threads);
        comparison::Stopwatch watch;
        check(hxtDelaunay(mesh, &options));
        watch.stop();
        comparison::print_answer(watch, number_of_finite_tetrahedra(*mesh), threads, "HXT",
                                 DELAUNAY_FROM_SURFACE_3_BUILT_AS);
      });
}
