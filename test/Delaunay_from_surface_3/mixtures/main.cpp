// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Calls units of several forms in one program.

#include <array>
#include <cstddef>
#include <cstdio>
#include <vector>

using Points = std::vector<std::array<double, 3>>;
using Faces = std::vector<std::array<int, 3>>;

std::size_t header_only(const Points&, const Faces&);
std::size_t compiled(const Points&, const Faces&);
std::size_t checked(const Points&, const Faces&);
std::size_t of_another_version(const Points&, const Faces&);
std::size_t wide(const Points&, const Faces&); // is there, and not called

int main()
{
  const int m = 40;
  Points points;
  Faces faces;
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < m; ++j) {
      points.push_back({double(i), double(j), double(i * i + j * j) / m});
      const int p = i * m + j;
      if (i + 1 < m && j + 1 < m) {
        faces.push_back({p, p + 1, p + m});
        faces.push_back({p + 1, p + m + 1, p + m});
      }
    }
  const std::size_t cells = header_only(points, faces);
  std::printf("%zu cells\n", cells);
  return cells > points.size() && compiled(points, faces) == cells &&
                 checked(points, faces) == cells && of_another_version(points, faces) == cells
             ? 0
             : 1;
}
