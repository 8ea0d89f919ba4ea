// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// More points than fit into memory: computes the tetrahedra of small radius and the volumes of
// Voronoi cells, tile by tile. A tile contains the stars of its own points, so everything that
// depends on a star can be computed; then the tile is discarded. The points form a lattice in which
// nearly all Voronoi cells are cubes.

#include <CGAL/delaunay_3_tiles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

using Vector = std::array<double, 3>;

Vector operator-(const Vector& a, const Vector& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector cross(const Vector& a, const Vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// That of the origin, a, b and c, which are not in one plane.
Vector circumcenter(const Vector& a, const Vector& b, const Vector& c)
{
  const Vector u = cross(b, c), v = cross(c, a), w = cross(a, b);
  const double d = 2 * dot(a, u);
  Vector center;
  for (int k = 0; k < 3; ++k)
    center[k] = (dot(a, a) * u[k] + dot(b, b) * v[k] + dot(c, c) * w[k]) / d;
  return center;
}

// The part of a positive tetrahedron that is nearer to its vertex at the origin than to a, b and c,
// up to what parts of its neighbours make up for: six corners at middles of edges and of facets.
double part_of_voronoi_cell(const Vector& a, const Vector& b, const Vector& c)
{
  const Vector corners[3] = {a, b, c}, center = circumcenter(a, b, c);
  double volume = 0;
  for (int i = 0; i < 3; ++i)
    for (int k = 1; k < 3; ++k) {
      const Vector &p = corners[i], &q = corners[(i + k) % 3];
      const Vector normal = cross(p, q);
      const double height = dot(normal, center) / dot(normal, normal);
      Vector middle,
          foot; // of the edge, and of the facet: where a perpendicular from the centre meets it
      for (int j = 0; j < 3; ++j) {
        middle[j] = p[j] / 2;
        foot[j] = center[j] - height * normal[j];
      }
      volume += (k == 1 ? 1 : -1) * dot(middle, cross(foot, center)) / 6;
    }
  return volume;
}

// A folder that nobody else has, as long as it lives.
struct Folder
{
  Folder()
  {
    if (!std::filesystem::create_directory(path))
      throw std::runtime_error(path.string() + " is there already");
  }
  Folder(const Folder&) = delete;
  ~Folder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }

  const std::filesystem::path path = std::filesystem::temp_directory_path() /
                                     ("filter_tiles-" + std::to_string(std::random_device()()));
};

int main(int argc, char* argv[])
try {
  const std::size_t side = argc > 1 ? std::size_t(std::atoi(argv[1])) : 20;
  if (side < 3 || side > 1000) {
    std::cerr << "expected a number of points on each side, from 3 to 1000\n";
    return EXIT_FAILURE;
  }
  const Folder folder;
  {
    std::ofstream file(folder.path / "lattice.raw", std::ios::binary);
    file.exceptions(std::ios::failbit | std::ios::badbit); // the disk may be full
    for (std::size_t i = 0; i < side * side * side; ++i) {
      const double p[] = {double(i % side), double(i / side % side), double(i / side / side)};
      file.write(reinterpret_cast<const char*>(p), sizeof(p));
    }
    file.close();
  }
  // [tiles]
  const CGAL::Point_files_3 points({folder.path / "lattice.raw"});
  CGAL::Tiles_in_files_3 engine(folder.path / "tiles");
  CGAL::Tiles_options options;
  options.number_of_tiles = 8; // or options.memory, in bytes
  // [tiles]

  std::size_t small = 0, cubes = 0;
  const auto report = CGAL::delaunay_3_tiles(
      engine, points,
      [&](const CGAL::Delaunay_3_tile& tile) {
        std::vector<double> volumes(tile.number_of_own_vertices);
        for (std::size_t c = 0; c < tile.cells.size(); ++c) {
          const auto& cell = tile.cells[c];
          if (cell[3] < 0) { // at the convex hull Voronoi cells are unbounded
            for (int k = 0; k < 3; ++k)
              if (std::size_t(cell[k]) < volumes.size())
                volumes[std::size_t(cell[k])] = HUGE_VAL;
            continue;
          }
          const Vector p[4] = {tile.points[cell[0]], tile.points[cell[1]], tile.points[cell[2]],
                               tile.points[cell[3]]};
          const Vector center = circumcenter(p[1] - p[0], p[2] - p[0], p[3] - p[0]);
          small += c < tile.number_of_owned_finite_cells && dot(center, center) < 0.7501;
          for (int k = 0; k < 4; ++k) // the others in positive order
            if (std::size_t(cell[k]) < volumes.size())
              volumes[std::size_t(cell[k])] +=
                  part_of_voronoi_cell(p[k ^ 1] - p[k], p[k ^ 2] - p[k], p[k ^ 3] - p[k]) * 1;
        }
        for (const double volume : volumes)
          cubes += std::abs(volume - 1) < 1e-9;
      },
      options);

  std::cout << report.points << " points in " << report.tiles << " tiles, " << report.cells
            << " finite and infinite cells, of which " << small
            << " have a radius of at most sqrt(3) / 2; " << cubes << " Voronoi cells are cubes\n";
  const std::size_t inner = side - 2;
  return cubes == inner * inner * inner && small > 5 * (side - 1) * (side - 1) * (side - 1)
             ? EXIT_SUCCESS
             : EXIT_FAILURE;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
