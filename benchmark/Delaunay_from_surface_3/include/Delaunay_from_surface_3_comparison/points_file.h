// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_POINTS_FILE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_POINTS_FILE_H

// How points go to programs of all kinds: the number of points as an unsigned integer of 8 bytes,
// then x, y, z of each as doubles, all in the machine's byte order. And how the programs answer.

#include <cstdint>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace comparison {

// `Points`: a range of anything with x(), y() and z().
template <class Points>
void write_points_file(const Points& points, const std::string& file_name)
{
  std::vector<double> coordinates;
  for (const auto& p : points)
    coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
  const std::uint64_t n = coordinates.size() / 3;
  std::ofstream file(file_name, std::ios::binary);
  file.write(reinterpret_cast<const char*>(&n), sizeof n);
  file.write(reinterpret_cast<const char*>(coordinates.data()),
             static_cast<std::streamsize>(coordinates.size() * sizeof(double)));
  if (!file.flush())
    throw std::runtime_error("cannot write '" + file_name + "'");
}

// x, y, z of the first point, then of the second …
inline std::vector<double> read_points_file(const std::string& file_name)
{
  std::ifstream file(file_name, std::ios::binary);
  std::uint64_t n = 0;
  file.read(reinterpret_cast<char*>(&n), sizeof n);
  std::vector<double> coordinates(file ? 3 * n : 0);
  file.read(reinterpret_cast<char*>(coordinates.data()),
            static_cast<std::streamsize>(coordinates.size() * sizeof(double)));
  if (!file)
    throw std::runtime_error("cannot read points from '" + file_name + "'");
  return coordinates;
}

// What a peer prints at the end: the seconds of process CPU time since `begin`, when it had its
// points as it wants them, to `end`, when it had the tetrahedra; and their number, finite ones.
inline void print_answer(std::clock_t begin, std::clock_t end, std::size_t tetrahedra)
{
  std::printf("cpu_seconds %.6f\ntetrahedra %zu\n", double(end - begin) / CLOCKS_PER_SEC,
              tetrahedra);
}

} // namespace comparison

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_POINTS_FILE_H
