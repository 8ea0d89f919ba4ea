// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

// The makers of surfaces: topology, manifoldness, sizes, determinism, and refused arguments.

#define BOOST_TEST_MODULE surfaces
#include <boost/test/included/unit_test.hpp>

#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/adversarial.h>
#include <Delaunay_from_surface_3_surfaces/cad.h>
#include <Delaunay_from_surface_3_surfaces/edit.h>
#include <Delaunay_from_surface_3_surfaces/genus_surface.h>
#include <Delaunay_from_surface_3_surfaces/io.h>
#include <Delaunay_from_surface_3_surfaces/lattice_surface.h>
#include <Delaunay_from_surface_3_surfaces/parametric.h>
#include <Delaunay_from_surface_3_surfaces/refine.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using surfaces::Indexed_surface;
using surfaces::Mesh;

bool same(const Indexed_surface& a, const Indexed_surface& b)
{
  return a.points == b.points && a.faces == b.faces;
}

// Every point on a face, no edge with more than two faces, no pinched vertex, all triangles.
Mesh manifold(const Indexed_surface& surface)
{
  BOOST_REQUIRE(PMP::is_polygon_soup_a_polygon_mesh(surface.faces));
  Mesh mesh = surfaces::to_mesh<Mesh>(surface);
  BOOST_TEST(mesh.is_valid(false));
  BOOST_TEST(CGAL::is_triangle_mesh(mesh));
  BOOST_TEST(mesh.number_of_vertices() == surface.points.size());
  std::vector<Mesh::Halfedge_index> pinched;
  PMP::non_manifold_vertices(mesh, std::back_inserter(pinched));
  BOOST_TEST(pinched.empty());
  return mesh;
}

std::size_t boundary_loops(const Mesh& mesh)
{
  std::set<Mesh::Halfedge_index> seen;
  std::size_t loops = 0;
  for (Mesh::Halfedge_index h : mesh.halfedges())
    if (mesh.is_border(h) && seen.count(h) == 0) {
      ++loops;
      for (Mesh::Halfedge_index b : CGAL::halfedges_around_face(h, mesh))
        seen.insert(b);
    }
  return loops;
}

// A closed manifold of the given genus that bounds a volume, its faces looking outwards.
void check_closed(const Indexed_surface& surface, std::size_t genus, std::size_t components = 1)
{
  const Mesh mesh = manifold(surface);
  BOOST_TEST(CGAL::is_closed(mesh));
  BOOST_TEST(PMP::volume(mesh) > 0);
  BOOST_TEST(surfaces::number_of_components(surface) == components);
  const std::ptrdiff_t expected =
      static_cast<std::ptrdiff_t>(components) * (2 - 2 * static_cast<std::ptrdiff_t>(genus));
  BOOST_TEST(surfaces::euler_characteristic(surface) == expected);
  BOOST_TEST(static_cast<std::ptrdiff_t>(mesh.number_of_vertices() + mesh.number_of_faces()) -
                 static_cast<std::ptrdiff_t>(mesh.number_of_edges()) ==
             expected);
}

void check_count(const Indexed_surface& surface, std::size_t wanted, double tolerance)
{
  const double n = static_cast<double>(wanted);
  BOOST_TEST(std::abs(static_cast<double>(surface.points.size()) - n) <= tolerance * n);
}

void check_all_points_differ(const Indexed_surface& surface)
{
  const std::set<Indexed_surface::Point_3> distinct(surface.points.begin(), surface.points.end());
  BOOST_TEST(distinct.size() == surface.points.size());
}

Mesh octahedron()
{
  return surfaces::to_mesh<Mesh>(surfaces::sphere(6));
}

} // namespace

BOOST_AUTO_TEST_CASE(smooth_surfaces_have_the_genus_and_size_asked_for)
{
  for (std::size_t genus : {0, 1, 2, 3, 5, 20})
    for (std::size_t n : {400 * (genus + 1), std::size_t(20000)}) {
      BOOST_TEST_CONTEXT("genus " << genus << ", " << n << " vertices")
      {
        const Indexed_surface surface = surfaces::genus_surface(genus, n, 0.05, 7);
        check_closed(surface, genus);
        check_count(surface, n, n < 5000 ? 0.05 : 0.02);
        check_all_points_differ(surface);
      }
    }
}

BOOST_AUTO_TEST_CASE(plates_have_the_genus_and_size_asked_for)
{
  for (std::size_t genus : {0, 1, 2, 3, 6})
    for (std::size_t n : {1500 * (genus + 1), std::size_t(30000)}) {
      BOOST_TEST_CONTEXT("genus " << genus << ", " << n << " vertices")
      {
        const Indexed_surface surface = surfaces::plate_surface(genus, n);
        check_closed(surface, genus);
        check_count(surface, n, n < 5000 ? 0.05 : 0.02);
      }
    }
}

BOOST_AUTO_TEST_CASE(polygonising_is_manifold_even_where_the_lattice_is_too_coarse)
{
  // The topology is lost at such spacings, but never the manifold.
  std::size_t wrong = 0;
  for (double spacing = 0.3; spacing < 1.2; spacing += 0.06) {
    const Indexed_surface surface = surfaces::polygonised(surfaces::Torus_chain(4), spacing, 3);
    if (surface.points.empty())
      continue;
    BOOST_TEST(CGAL::is_closed(manifold(surface)));
    wrong += surfaces::euler_characteristic(surface) != 2 - 2 * 4;
  }
  BOOST_TEST(wrong > 0);
}

BOOST_AUTO_TEST_CASE(points_of_a_smooth_surface_lie_on_it)
{
  const surfaces::Torus_chain shape(3);
  for (const Indexed_surface::Point_3& p : surfaces::genus_surface(3, 20000).points)
    BOOST_REQUIRE(std::abs(shape(p)) < 1e-4);
}

BOOST_AUTO_TEST_CASE(a_dense_smooth_surface_is_part_of_the_delaunay_triangulation)
{
  const Indexed_surface surface = surfaces::genus_surface(2, 10000, 0.05, 3);
  CGAL::Delaunay_triangulation_3<Indexed_surface::Kernel> triangulation(surface.points.begin(),
                                                                        surface.points.end());
  using Vertex_handle = decltype(triangulation)::Vertex_handle;
  decltype(triangulation)::Cell_handle c;
  int i, j, k;
  std::map<Indexed_surface::Point_3, Vertex_handle> at;
  for (Vertex_handle v : triangulation.finite_vertex_handles())
    at[v->point()] = v;
  std::size_t delaunay = 0;
  for (const Indexed_surface::Face& face : surface.faces)
    delaunay += triangulation.is_facet(at[surface.points[face[0]]], at[surface.points[face[1]]],
                                       at[surface.points[face[2]]], c, i, j, k);
  BOOST_TEST(delaunay >= surface.faces.size() - surface.faces.size() / 1000);
}

BOOST_AUTO_TEST_CASE(jitter_stays_within_its_share_of_the_edge_length)
{
  const Indexed_surface still = surfaces::genus_surface(1, 5000);
  Indexed_surface moved = still;
  surfaces::jitter(moved, 0.05, 11);
  BOOST_TEST(still.faces == moved.faces);
  const std::vector<double> length = surfaces::local_edge_lengths(still);
  double largest = 0;
  for (std::size_t v = 0; v < length.size(); ++v)
    largest = (std::max)(
        largest, std::sqrt(CGAL::squared_distance(still.points[v], moved.points[v])) / length[v]);
  BOOST_TEST(largest <= 0.05 * 1.000001);
  BOOST_TEST(largest > 0.045);
}

BOOST_AUTO_TEST_CASE(the_same_seed_gives_the_same_surface_and_another_seed_another)
{
  BOOST_TEST(
      same(surfaces::genus_surface(2, 4000, 0.05, 1), surfaces::genus_surface(2, 4000, 0.05, 1)));
  BOOST_TEST(
      !same(surfaces::genus_surface(2, 4000, 0.05, 1), surfaces::genus_surface(2, 4000, 0.05, 2)));
  BOOST_TEST(same(surfaces::sphere(1000, 0.1, 1), surfaces::sphere(1000, 0.1, 1)));
  BOOST_TEST(!same(surfaces::sphere(1000, 0.1, 1), surfaces::sphere(1000, 0.1, 2)));
  BOOST_TEST(same(surfaces::terrain(1000, 1), surfaces::terrain(1000, 1)));
  BOOST_TEST(!same(surfaces::terrain(1000, 1), surfaces::terrain(1000, 2)));
  const Mesh mesh = octahedron();
  BOOST_TEST(
      same(surfaces::densified(mesh, 500, 0.05, 1), surfaces::densified(mesh, 500, 0.05, 1)));
  BOOST_TEST(
      !same(surfaces::densified(mesh, 500, 0.05, 1), surfaces::densified(mesh, 500, 0.05, 2)));
}

BOOST_AUTO_TEST_CASE(spheres_have_exactly_the_points_asked_for)
{
  for (std::size_t n : {5, 6, 7, 8, 9, 10, 11, 12, 13, 20, 31, 50, 100, 999, 20001}) {
    BOOST_TEST_CONTEXT(n << " vertices")
    {
      const Indexed_surface surface = surfaces::sphere(n, 0, n);
      BOOST_TEST(surface.points.size() == n);
      check_closed(surface, 0);
      check_all_points_differ(surface);
    }
  }
  double inner = 1, outer = 1;
  for (const Indexed_surface::Point_3& p : surfaces::sphere(10000, 0.1, 5).points) {
    const double radius = std::sqrt((p - CGAL::ORIGIN).squared_length());
    inner = (std::min)(inner, radius);
    outer = (std::max)(outer, radius);
  }
  BOOST_TEST(inner < 0.8);
  BOOST_TEST(outer > 1.2);
}

BOOST_AUTO_TEST_CASE(integer_spheres_are_exactly_cospherical)
{
  for (std::size_t n : {6, 24, 200, 3000}) {
    const Indexed_surface surface = surfaces::integer_sphere(n);
    check_closed(surface, 0);
    check_count(surface, n, 0.5);
    const double squared_radius = (surface.points[0] - CGAL::ORIGIN).squared_length();
    for (const Indexed_surface::Point_3& p : surface.points) {
      BOOST_REQUIRE((p - CGAL::ORIGIN).squared_length() == squared_radius);
      BOOST_REQUIRE(p.x() == std::floor(p.x()));
    }
  }
  BOOST_TEST(surfaces::integer_points_on_sphere(1).size() == 6);
  BOOST_TEST(surfaces::integer_points_on_sphere(9).size() == 30);
  BOOST_TEST(surfaces::integer_points_on_sphere(7).empty());
}

BOOST_AUTO_TEST_CASE(lattice_surfaces_have_the_genus_asked_for_and_integer_points)
{
  for (std::size_t genus : {0, 1, 2, 5})
    for (std::size_t n : {8, 20000}) {
      const Indexed_surface surface = surfaces::lattice_surface(genus, n);
      check_closed(surface, genus);
      if (n > 1000)
        check_count(surface, n, 0.05);
      for (const Indexed_surface::Point_3& p : surface.points)
        BOOST_REQUIRE(
            p == Indexed_surface::Point_3(std::floor(p.x()), std::floor(p.y()), std::floor(p.z())));
    }
}

BOOST_AUTO_TEST_CASE(plates_and_tori_on_grids)
{
  const Indexed_surface plate = surfaces::thin_plate(5000, 0.001);
  check_closed(plate, 0);
  check_count(plate, 5000, 0.05);
  for (const Indexed_surface::Point_3& p : plate.points)
    BOOST_REQUIRE((p.z() == 0 || p.z() == 0.001));
  const Indexed_surface tube = surfaces::round_tube(5000);
  check_count(tube, 5000, 0.02);
  BOOST_TEST(boundary_loops(manifold(tube)) == 2u);
  for (const std::size_t n : {55, 4000, 5400}) { // 55, 4181 and 6765 points
    const Indexed_surface winding = surfaces::winding_torus(n);
    check_count(winding, n, 0.26);
    check_closed(winding, 1);
    check_all_points_differ(winding);
  }
  const Indexed_surface torus = surfaces::grid_torus(5000);
  check_closed(torus, 1);
  check_count(torus, 5000, 0.02);
  check_all_points_differ(torus);
}

BOOST_AUTO_TEST_CASE(surfaces_with_boundary)
{
  const Indexed_surface land = surfaces::terrain(2500, 3);
  const Mesh disc = manifold(land);
  BOOST_TEST(land.points.size() == 2500);
  BOOST_TEST(boundary_loops(disc) == 1);
  BOOST_TEST(surfaces::euler_characteristic(land) == 1);

  Indexed_surface surface = surfaces::genus_surface(2, 3000);
  surfaces::puncture(surface, 7, 1);
  BOOST_TEST(boundary_loops(manifold(surface)) == 7);
  BOOST_TEST(surfaces::euler_characteristic(surface) == 2 - 2 * 2 - 7);
}

BOOST_AUTO_TEST_CASE(several_components)
{
  check_closed(surfaces::copies(surfaces::genus_surface(2, 2000), 3), 2, 3);
  Indexed_surface surface = surfaces::genus_surface(3, 3000);
  surfaces::append(surface, surfaces::sphere(100), Indexed_surface::Vector_3(0, 0, 5));
  BOOST_TEST(CGAL::is_closed(manifold(surface)));
  BOOST_TEST(surfaces::number_of_components(surface) == 2);
  BOOST_TEST(surfaces::euler_characteristic(surface) == -4 + 2);
}

BOOST_AUTO_TEST_CASE(shuffling_keeps_the_surface)
{
  const Indexed_surface before = surfaces::genus_surface(1, 2000);
  Indexed_surface after = before;
  surfaces::shuffle(after, 4);
  BOOST_TEST(before.points != after.points);
  check_closed(after, 1);
  BOOST_TEST(PMP::volume(manifold(before)) == PMP::volume(manifold(after)),
             boost::test_tools::tolerance(1e-9));
  std::vector<Indexed_surface::Point_3> a = before.points, b = after.points;
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  BOOST_TEST(a == b);
}

BOOST_AUTO_TEST_CASE(refined_meshes)
{
  const Mesh mesh = octahedron();
  const Indexed_surface twice = surfaces::loop_subdivided(mesh, 2, 0.05, 1);
  check_closed(twice, 0);
  BOOST_TEST(twice.faces.size() == 8 * 16);
  check_all_points_differ(twice);
  for (std::size_t n : {6, 7, 17, 18, 19, 1000, 5000}) {
    BOOST_TEST_CONTEXT(n << " vertices")
    {
      const Indexed_surface surface = surfaces::densified(mesh, n);
      BOOST_TEST(surface.points.size() == n);
      check_closed(surface, 0);
    }
  }
  const Indexed_surface land =
      surfaces::densified(surfaces::to_mesh<Mesh>(surfaces::terrain(100)), 1000);
  BOOST_TEST(land.points.size() == 1000);
  BOOST_TEST(boundary_loops(manifold(land)) == 1);
}

BOOST_AUTO_TEST_CASE(degenerate_sets)
{
  for (std::size_t n = 0; n <= 3; ++n)
    BOOST_TEST(surfaces::few_points(n).points.size() == n);

  const Indexed_surface line = surfaces::collinear(50);
  manifold(line);
  for (const Indexed_surface::Point_3& p : line.points)
    BOOST_TEST(CGAL::collinear(line.points[0], line.points[1], p));

  const Indexed_surface plane = surfaces::coplanar(400);
  manifold(plane);
  BOOST_TEST(plane.points.size() == 400);
  for (const Indexed_surface::Point_3& p : plane.points)
    BOOST_TEST(CGAL::coplanar(plane.points[0], plane.points[1], plane.points[20], p));

  Indexed_surface surface = surfaces::sphere(100);
  surfaces::duplicate_points(surface, 10, 1);
  BOOST_TEST(surface.points.size() == 110);
  BOOST_TEST(
      std::set<Indexed_surface::Point_3>(surface.points.begin(), surface.points.end()).size() ==
      100);

  surface = surfaces::sphere(100);
  surfaces::separate_faces(surface);
  BOOST_TEST(surface.points.size() == 3 * 196);
  BOOST_TEST(surfaces::number_of_components(surface) == 196);
}

BOOST_AUTO_TEST_CASE(conversion_to_a_polyhedron_and_back)
{
  const Indexed_surface surface = surfaces::genus_surface(1, 1000);
  using Polyhedron = CGAL::Polyhedron_3<Indexed_surface::Kernel>;
  const Polyhedron polyhedron = surfaces::to_mesh<Polyhedron>(surface);
  BOOST_TEST(polyhedron.is_closed());
  BOOST_TEST(surfaces::from_mesh(polyhedron).points == surface.points);
}

BOOST_AUTO_TEST_CASE(files_keep_every_digit)
{
  const Indexed_surface surface = surfaces::genus_surface(1, 1000, 0.05, 1);
  for (const std::string name : {"test_surfaces_written.off", "test_surfaces_written.ply"}) {
    surfaces::write_surface(surface, name);
    BOOST_TEST(surfaces::from_mesh(surfaces::read_mesh(name)).points == surface.points);
    std::remove(name.c_str());
  }
  BOOST_CHECK_THROW(surfaces::write_surface(surface, "test_surfaces_written.txt"),
                    std::runtime_error);
  BOOST_CHECK_THROW(surfaces::write_surface(surface, "no_such_folder/written.off"),
                    std::runtime_error);
  BOOST_CHECK_THROW(surfaces::read_mesh("no_such_file.off"), std::runtime_error);
}

BOOST_AUTO_TEST_CASE(arguments_without_sense_are_refused)
{
  BOOST_CHECK_THROW(surfaces::genus_surface(50, 100), std::invalid_argument);
  BOOST_CHECK_THROW(surfaces::genus_surface(0, 0), std::invalid_argument);
  BOOST_CHECK_THROW(surfaces::genus_surface(0, 1000, 0.5), std::invalid_argument);
  BOOST_CHECK_THROW(surfaces::genus_surface(0, 1000, std::nan("")), std::invalid_argument);
  BOOST_CHECK_THROW(surfaces::sphere(4), std::invalid_argument);
  BOOST_CHECK_THROW(surfaces::sphere(10, -1), std::invalid_argument);
  BOOST_CHECK_THROW(surfaces::integer_sphere(5), std::invalid_argument);
  BOOST_CHECK_THROW(surfaces::thin_plate(100, 0), std::invalid_argument);
  BOOST_CHECK_THROW(surfaces::few_points(4), std::invalid_argument);
  BOOST_CHECK_THROW(surfaces::collinear(2), std::invalid_argument);
  BOOST_CHECK_THROW(surfaces::densified(octahedron(), 5), std::invalid_argument);
  BOOST_CHECK_THROW(surfaces::loop_subdivided(octahedron(), 20), std::invalid_argument);
  BOOST_CHECK_THROW(surfaces::loop_subdivided(Mesh(), 1), std::invalid_argument);
  BOOST_CHECK_THROW(surfaces::copies(surfaces::sphere(10), 0), std::invalid_argument);
  Indexed_surface surface = surfaces::sphere(20);
  BOOST_CHECK_THROW(surfaces::puncture(surface, 10, 0), std::invalid_argument);
  surface.faces.push_back(surface.faces.front());
  BOOST_CHECK_THROW(surfaces::to_mesh<Mesh>(surface), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(cad_solids_are_closed)
{
  using surfaces::Numbering;
  for (const surfaces::Cad_family& family : surfaces::cad_families())
    for (const std::uint64_t seed : {1, 2, 3})
      BOOST_TEST_CONTEXT(family.name << ", seed " << seed)
      {
        const Indexed_surface surface = family.make(3000, seed, Numbering::BY_PROFILE);
        BOOST_TEST(surface.points.size() >= 2700u);
        BOOST_TEST(surface.points.size() <= 3500u);
        const Mesh mesh = manifold(surface);
        BOOST_TEST(CGAL::is_closed(mesh));
        BOOST_TEST(surfaces::number_of_components(surface) == 1u);
        BOOST_TEST(PMP::volume(mesh) > 0);
        BOOST_TEST(!PMP::does_self_intersect(mesh));
        // The same solid in every numbering.
        const std::set<Indexed_surface::Point_3> points(surface.points.begin(),
                                                        surface.points.end());
        for (const Numbering numbering : {Numbering::BY_RING, Numbering::SHUFFLED}) {
          const Indexed_surface other = family.make(3000, seed, numbering);
          BOOST_TEST(!same(surface, other));
          BOOST_TEST((std::set<Indexed_surface::Point_3>(other.points.begin(),
                                                         other.points.end()) == points));
          BOOST_TEST(PMP::volume(manifold(other)) == PMP::volume(mesh),
                     boost::test_tools::tolerance(1e-9));
        }
      }
}

BOOST_AUTO_TEST_CASE(cad_numbering_follows_profiles_or_rings)
{
  using surfaces::Numbering;
  const Indexed_surface by_profile =
      surfaces::cad_families()[0].make(3000, 1, Numbering::BY_PROFILE);
  const Indexed_surface by_ring = surfaces::cad_families()[0].make(3000, 1, Numbering::BY_RING);
  BOOST_TEST(by_profile.points[0].z() == by_profile.points[1].z());
  BOOST_TEST(by_ring.points[0].x() == by_ring.points[1].x());
  BOOST_TEST(by_ring.points[0].z() < by_ring.points[1].z());
}

BOOST_AUTO_TEST_CASE(rounded_coordinates)
{
  Indexed_surface surface = surfaces::sphere(100, 0.01);
  Indexed_surface decimals = surface;
  surfaces::round_to_float(surface);
  surfaces::round_to_decimals(decimals, 3);
  for (std::size_t i = 0; i < 100; ++i) {
    BOOST_TEST(surface.points[i].x() == double(float(surface.points[i].x())));
    BOOST_TEST(decimals.points[i].x() == std::round(decimals.points[i].x() * 1000) / 1000);
    BOOST_TEST(std::abs(decimals.points[i].x() - surface.points[i].x()) < 0.000501);
  }
}

BOOST_AUTO_TEST_CASE(misleading_surfaces)
{
  BOOST_TEST(surfaces::star(500, 1).points.size() == 500u);
  BOOST_TEST(surfaces::number_of_components(surfaces::star(500, 1)) == 1u);
  for (const Indexed_surface::Face& face : surfaces::star(500, 1).faces)
    BOOST_TEST(face[0] == 0u);
  BOOST_TEST(surfaces::faces_at_random(500, 1).faces.size() == 1000u);
  BOOST_TEST(surfaces::two_lines(500).points.size() == 500u);
  BOOST_TEST(surfaces::number_of_components(surfaces::two_lines(500)) == 1u);
  const Indexed_surface stars = surfaces::skew_stars(500, 1);
  BOOST_TEST(stars.points.size() == 496u);
  BOOST_TEST(surfaces::number_of_components(stars) == 31u);
  check_all_points_differ(stars);
  for (const Indexed_surface::Point_3& p : surfaces::nearly_flat(500, 1e-12, 1).points)
    BOOST_TEST(std::abs(p.z()) <= 1e-12);
  for (const surfaces::Flat_or_far_family& family : surfaces::flat_and_far_families()) {
    const Indexed_surface surface = family.make(500, 1);
    check_count(surface, 500, 0.1);
    check_all_points_differ(surface);
  }
  BOOST_TEST(surfaces::all_equal(500).points.front() == surfaces::all_equal(500).points.back());
  const Indexed_surface room = surfaces::room(500, 1);
  check_count(room, 500, 0.1);
  check_all_points_differ(room);
  BOOST_TEST(surfaces::euler_characteristic({room.points, room.faces}) == 3); // with the middle
  BOOST_CHECK_THROW(surfaces::star(2, 1), std::invalid_argument);
  BOOST_CHECK_THROW(surfaces::room(8, 1), std::invalid_argument);
  BOOST_CHECK_THROW(surfaces::two_lines(3), std::invalid_argument);
  BOOST_CHECK_THROW(surfaces::winding_torus(54), std::invalid_argument);
  BOOST_CHECK_THROW(surfaces::round_tube(59), std::invalid_argument);
  BOOST_CHECK_THROW(surfaces::skew_stars(63, 1), std::invalid_argument);
}
