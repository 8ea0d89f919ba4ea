// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Tiles by MPI, as the other programs of measure_tiles_peers.py run.

#include <Delaunay_from_surface_3_comparison/mpi_peer.h>

#include <CGAL/Tiles_by_mpi_3.h>
#include <CGAL/delaunay_3_tiles.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace {

// A rank has no points but those that it reads for all.
class Part_source : public CGAL::Tile_source_3
{
public:
  explicit Part_source(const comparison::Mpi_peer_input& input)
    : m_input(input)
  {
  }
  std::uint64_t size() const override { return m_input.all; }
  std::uint64_t first_of_part(std::uint64_t part, std::uint64_t parts) const override
  {
    return m_input.all * part / parts;
  }
  void read(std::uint64_t first, std::size_t n, double* coordinates) const override
  {
    const double* const from = m_input.points[first - m_input.first].data();
    std::copy(from, from + 3 * n, coordinates);
  }

private:
  const comparison::Mpi_peer_input& m_input;
};

} // namespace

int main(int argc, char** argv)
{
  return comparison::run_mpi_peer(
      "tiles_peer", argc, argv, [](const char* file, int tiles, const char* cells) {
        const auto input = comparison::read_part(file);
        std::vector<comparison::Mpi_peer_point> corners;
        std::size_t tetrahedra = 0, held = 0;
        comparison::Mpi_stopwatch watch;
        CGAL::Tiles_by_mpi_3 engine(MPI_COMM_WORLD);
        CGAL::Tiles_options options;
        options.number_of_tiles = std::uint32_t(tiles * engine.number_of_ranks());
        CGAL::delaunay_3_tiles(
            engine, Part_source(input),
            [&](const CGAL::Delaunay_3_tile& tile) {
              tetrahedra += tile.number_of_owned_finite_cells;
              held += tile.ids.size();
              if (*cells != 0)
                for (std::size_t c = 0; c < tile.number_of_owned_finite_cells; ++c)
                  for (const std::int32_t v : tile.cells[c])
                    corners.push_back(tile.points[std::size_t(v)]);
            },
            options);
        watch.stop();
        watch.print("this package");
        comparison::print_number("tetrahedra", double(tetrahedra));
        comparison::print_number("points_held", double(held));
        comparison::write_corners(cells, input.rank, corners);
      });
}
