#ifndef CONSUMER_SECOND_UNIT_H
#define CONSUMER_SECOND_UNIT_H

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;

Triangulation triangulation_of_points(const Mesh& mesh);

#endif // CONSUMER_SECOND_UNIT_H
