// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// tess2 for measure_tiles_peers.py: blocks by its k-d tree, which needs two at least. It has
// coordinates as floats.

#include <Delaunay_from_surface_3_comparison/mpi_peer.h>

#define DIY_NO_THREADS // as tess2 has it if nothing else is said
#include <tess/tess.h>
#include <tess/tess.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <vector>

namespace {

using Input = comparison::Mpi_peer_input;

// The first block of a rank begins with the points that this has read, wherever these are.
struct Add_part : AddBlock
{
  Add_part(diy::Master& master, const Input& input)
    : AddBlock(master)
    , input(input)
  {
  }
  void operator()(int gid, const diy::ContinuousBounds& core, const diy::ContinuousBounds& bounds,
                  const diy::ContinuousBounds& domain, const RCLink& link) const
  {
    DBlock* const block = AddBlock::operator()(gid, core, bounds, domain, link);
    block->box = domain;
    if (master.size() > 1)
      return; // another block of this rank has them
    block->num_particles = block->num_orig_particles = int(input.points.size());
    block->particles = static_cast<float*>(std::malloc(3 * input.points.size() * sizeof(float)));
    float* to = block->particles; // which tess2 frees
    for (const auto& p : input.points)
      to = std::transform(p.begin(), p.end(), to, [](double x) { return float(x); });
  }
  const Input& input;
};

// A tetrahedron belongs to the block with the smallest number that one of its vertices has.
bool owns(const DBlock& block, const tet_t& cell)
{
  int least = block.gid;
  bool has_own = false;
  for (const int v : cell.verts)
    if (v < block.num_orig_particles)
      has_own = true;
    else
      least = (std::min)(least, block.rem_gids[v - block.num_orig_particles]);
  return has_own && least == block.gid;
}

void add_corners(const DBlock& block, const tet_t& cell,
                 std::vector<comparison::Mpi_peer_point>& corners)
{
  for (const int v : cell.verts) {
    const float* const p = block.particles + 3 * std::size_t(v);
    corners.push_back({double(p[0]), double(p[1]), double(p[2])});
  }
}

diy::ContinuousBounds domain_of(const Input& input)
{
  diy::ContinuousBounds domain(3);
  for (std::size_t i = 0; i < 3; ++i) {
    domain.min[unsigned(i)] = float(input.lowest[i]);
    domain.max[unsigned(i)] = float(input.highest[i]);
  }
  return domain;
}

} // namespace

int main(int argc, char** argv)
{
  return comparison::run_mpi_peer(
      "tess2_peer", argc, argv, [](const char* file, int blocks, const char* cells) {
        const Input input = comparison::read_part(file);
        diy::mpi::communicator world(MPI_COMM_WORLD);
        diy::Master master(world, 1, -1, &create_block, &destroy_block);
        diy::RoundRobinAssigner assigner(world.size(), blocks * world.size());
        diy::decompose(3, world.rank(), domain_of(input), assigner, Add_part(master, input));
        comparison::Mpi_stopwatch watch;
        if (assigner.nblocks() > 1)
          tess_kdtree_exchange(master, assigner, false);
        const std::size_t rounds = tess(master);
        watch.stop();
        watch.print("tess2 " DELAUNAY_FROM_SURFACE_3_BUILT_AS);
        std::size_t tetrahedra = 0, held = 0;
        std::vector<comparison::Mpi_peer_point> corners;
        for (int k = 0; k < int(master.size()); ++k) {
          const DBlock& block = *master.block<DBlock>(k);
          held += std::size_t(block.num_particles);
          for (int t = 0; t < block.num_tets; ++t)
            if (owns(block, block.tets[t])) {
              ++tetrahedra;
              if (*cells != 0)
                add_corners(block, block.tets[t], corners);
            }
        }
        comparison::print_number("tetrahedra", double(tetrahedra));
        comparison::print_number("points_held", double(held));
        if (world.rank() == 0)
          std::printf("rounds %zu\n", rounds);
        comparison::write_corners(cells, input.rank, corners);
      });
}
