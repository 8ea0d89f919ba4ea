#include "all_headers.h"

#include "second_unit.h"

#include <vector>

Triangulation triangulation_of_points(const Mesh& mesh)
{
  const std::vector<Kernel::Point_3> points(mesh.points().begin(), mesh.points().end());
  return Triangulation(points.begin(), points.end());
}
