// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Triangulates the points of an .xyz or .off file through the C interface, checks the result, and
// writes the tetrahedra for ParaView. scripts/try_it builds and runs it.
//
//   triangulate_file POINTS [CELLS.vtk [THREADS]]

#include "delaunay_3.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <limits>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Triangulation = std::unique_ptr<delaunay_3, void (*)(delaunay_3*)>;

// The next line that says something: comments and blank lines do not.
bool next_line(std::istream& file, std::string& line, std::size_t& number)
{
  while (std::getline(file, line)) {
    ++number;
    line.erase(std::min(line.find('#'), line.size()));
    if (line.find_first_not_of(" \t\r\v\f") != std::string::npos)
      return true;
  }
  return false;
}

// Three coordinates for each point: of .off the vertices, of .xyz the first three numbers of each
// line.
std::vector<double> read_points(const std::string& name)
{
  std::ifstream file(name);
  if (!file)
    throw std::runtime_error(name + ": " + std::strerror(errno));
  std::vector<double> points;
  std::string line;
  std::size_t number = 0, wanted = std::numeric_limits<std::size_t>::max();
  const bool is_off = name.size() > 4 && name.compare(name.size() - 4, 4, ".off") == 0;
  if (is_off) {
    next_line(file, line, number);
    if (line.compare(0, 3, "OFF") != 0)
      throw std::runtime_error(name + ": the first line is not OFF");
    std::istringstream counts(line.substr(3));
    if (!(counts >> wanted)) { // they have a line of their own
      next_line(file, line, number);
      counts = std::istringstream(line);
      if (!(counts >> wanted))
        throw std::runtime_error(name + ": there is no number of vertices");
    }
  }
  while (points.size() / 3 < wanted && next_line(file, line, number)) {
    const char* at = line.c_str();
    for (int k = 0; k < 3; ++k) {
      char* end;
      points.push_back(std::strtod(at, &end));
      if (end == at)
        throw std::runtime_error(name + ": line " + std::to_string(number) +
                                 " has no three numbers");
      at = end;
    }
  }
  if (is_off && points.size() / 3 < wanted)
    throw std::runtime_error(name + ": it ends before its last vertex");
  return points;
}

void write_vtk(const std::string& name, const std::vector<double>& points,
               const delaunay_3_cells& cells)
{
  const std::string aside = name + ".part"; // so that no half of a file has the name
  std::ofstream file(aside);
  file.precision(std::numeric_limits<double>::max_digits10);
  file << "# vtk DataFile Version 2.0\nDelaunay triangulation\nASCII\nDATASET "
          "UNSTRUCTURED_GRID\nPOINTS "
       << points.size() / 3 << " double\n";
  for (std::size_t i = 0; i < points.size(); i += 3)
    file << points[i] << ' ' << points[i + 1] << ' ' << points[i + 2] << '\n';
  const std::size_t corners = std::size_t(cells.dimension + 1);
  file << "CELLS " << cells.number << ' ' << cells.number * (corners + 1) << '\n';
  for (std::size_t c = 0; c < cells.number; ++c) {
    file << corners;
    for (std::size_t k = 0; k < corners; ++k)
      file << ' ' << cells.vertices[c * cells.stride + k];
    file << '\n';
  }
  static constexpr int types[] = {1, 3, 5, 10}; // vertex, line, triangle, tetrahedron
  file << "CELL_TYPES " << cells.number << '\n';
  for (std::size_t c = 0; c < cells.number; ++c)
    file << types[cells.dimension] << '\n';
  file.close();
  if (!file || std::rename(aside.c_str(), name.c_str()) != 0) {
    std::remove(aside.c_str());
    throw std::runtime_error(name + ": cannot be written");
  }
}

bool ends_in(const std::string& name, const std::string& ending)
{
  return name.size() > ending.size() &&
         name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
}

void run(const std::string& input, const std::string& output, int threads)
{
  if (!output.empty() && (!ends_in(output, ".vtk") || ends_in(input, ".vtk")))
    throw std::runtime_error(output +
                             ": nothing is written over points; name a file that ends in .vtk");
  const std::vector<double> points = read_points(input);
  const auto begin = std::chrono::steady_clock::now();
  delaunay_3* built = nullptr;
  std::size_t where = 0;
  const delaunay_3_status status =
      delaunay_3_build(points.data(), points.size() / 3, nullptr, 0, threads, &built, &where);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const Triangulation owner(built, &delaunay_3_free);
  if (status != DELAUNAY_3_OK)
    throw std::runtime_error(
        input + ": " + delaunay_3_message(status) +
        (status == DELAUNAY_3_NOT_FINITE ? "; it is that of point " + std::to_string(where) : ""));

  delaunay_3_cells cells;
  delaunay_3_get(built, &cells);
  const int is_valid = delaunay_3_is_valid(built, 3);
  static const char* const names[] = {"no cells", "vertex", "edges", "triangles", "tetrahedra"};
  std::printf("%zu points, %zu %s, %.3f s with %d threads; %s\n", points.size() / 3, cells.number,
              names[cells.dimension + 1], seconds, threads,
              is_valid == 1   ? "checked: it is the Delaunay triangulation"
              : is_valid == 0 ? "WRONG: please report it"
                              : delaunay_3_message(delaunay_3_status(-is_valid)));
  if (!output.empty()) {
    if (cells.dimension < 0)
      throw std::runtime_error(input + ": there are no points, and nothing is written");
    write_vtk(output, points, cells);
    std::printf("written: %s\n", output.c_str());
  }
  if (is_valid != 1)
    throw std::runtime_error(input + ": the result has not passed the check");
}

} // namespace

int main(int argc, char** argv)
{
  if (argc < 2 || argc > 4) {
    std::fprintf(stderr, "usage: %s POINTS [CELLS.vtk [THREADS]]\n", argv[0]);
    return 2;
  }
  try {
    run(argv[1], argc > 2 ? argv[2] : "", argc > 3 ? std::atoi(argv[3]) : 1);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  }
  return 0;
}
