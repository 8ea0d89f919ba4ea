// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Every kind of triangulation a user may bring, empty or not, and every kernel of the mesh.

#define BOOST_TEST_MODULE test_triangulations
#include <boost/test/included/unit_test.hpp>

#include "check_arrays.h"
#include "check_equal.h"
#include "recording_kernel.h"

#include <Delaunay_from_surface_3_meters/meters.h>
#include <Delaunay_from_surface_3_meters/Surface_net_rounds.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_insertion_traits_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tracing_traits_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/delaunay_3_arrays.h>
#include <CGAL/insert_points_3.h>
#include <CGAL/insert_surface_vertices_3.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <set>
#include <stdexcept>
#include <vector>

namespace DFS = CGAL::Delaunay_from_surface_3;

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Epick::Point_3;
using Triangulation = CGAL::Delaunay_triangulation_3<Epick>;
using CGAL::insert_points_3;
using tests::Indexed_surface;
using tests::Named_surface;

namespace {

Indexed_surface torus()
{
  static const Indexed_surface surface = surfaces::genus_surface(1, 700, 0.05);
  return surface;
}

template <class Tr>
std::vector<typename Tr::Point> finite_points(const Tr& tr)
{
  std::vector<typename Tr::Point> points;
  for (auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
    points.push_back(v->point());
  return points;
}

// Inserts a torus into triangulations that hold other points already.
template <class Traits, class Tr>
void check_non_empty(const std::vector<Point>& old_points)
{
  const Indexed_surface surface = torus();
  Tr tr(old_points.begin(), old_points.end()), plain(tr);
  std::vector<std::pair<typename Tr::Vertex_handle, Point>> old_vertices;
  for (auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
    old_vertices.emplace_back(v, v->point());
  const auto infinite = tr.infinite_vertex();

  const auto gained = insert_points_3(tr, surface.points, surface.faces, Traits());
  BOOST_TEST(gained == plain.insert(surface.points.begin(), surface.points.end()));
  BOOST_TEST((tr == plain));
  BOOST_TEST(tr.is_valid());
  for (const auto& [v, p] : old_vertices) {
    BOOST_TEST_REQUIRE(tr.tds().is_vertex(v));
    BOOST_TEST(v->point() == p);
  }
  BOOST_TEST((old_vertices.empty() || tr.infinite_vertex() == infinite));
}

template <class Tr>
void check_non_empty_of_all_dimensions()
{
  const std::vector<Point> on_surface = torus().points;
  const std::vector<std::vector<Point>> olds = {{},
                                                {{5, 5, 5}},
                                                {{5, 5, 5}, {6, 6, 6}},
                                                {{5, 5, 5}, {6, 6, 6}, {7, 7, 7}},
                                                {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
                                                {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1}},
                                                {on_surface.begin(), on_surface.begin() + 300},
                                                on_surface,
                                                surfaces::sphere(300, 0.3).points};
  for (std::size_t k = 0; k < olds.size(); ++k)
    BOOST_TEST_CONTEXT("old points: case " << k)
    {
      check_non_empty<CGAL::Surface_insertion_traits_3, Tr>(olds[k]);
      check_non_empty<CGAL::Tracing_traits_3, Tr>(olds[k]);
      check_non_empty<CGAL::Plain_insertion_traits_3, Tr>(olds[k]);
    }
}

// Infos that CGAL's own insertion leaves alone, as it makes no copy of a vertex.
struct Movable_info
{
  std::unique_ptr<int> held = std::make_unique<int>(0);
  int& value() { return *held; }
};
struct List_info // std::is_copy_constructible says that it can be copied
{
  List_info() { held.push_back(std::make_unique<int>(0)); }
  std::vector<std::unique_ptr<int>> held;
  int& value() { return *held.front(); }
};
struct Copyable_info
{
  int held = 0;
  int& value() { return held; }
};
struct Constant_info
{
  const std::shared_ptr<int> held = std::make_shared<int>(0);
  int& value() { return *held; }
};
struct Immovable_info
{
  std::atomic<int> held{0};
  std::atomic<int>& value() { return held; }
};

template <class Info, class... Location_policy>
void check_info(bool infinite_vertex_keeps_it)
{
  using Vb = CGAL::Triangulation_vertex_base_with_info_3<Info, Epick>;
  using Cb = CGAL::Delaunay_triangulation_cell_base_3<Epick>;
  using Tr = CGAL::Delaunay_triangulation_3<Epick, CGAL::Triangulation_data_structure_3<Vb, Cb>,
                                            Location_policy...>;
  const auto& [points, faces] = torus();
  Tr tr, plain;
  plain.insert(points.begin(), points.end());
  tr.infinite_vertex()->info().value() = 4711;
  const std::vector<std::vector<int>> bad_faces = {{-1}};
  BOOST_CHECK_THROW(insert_points_3(tr, points, bad_faces), CGAL::Surface_input_error);
  BOOST_TEST(tr.infinite_vertex()->info().value() == 4711);
  insert_points_3(tr, points, faces);
  BOOST_TEST(tr.infinite_vertex()->info().value() == (infinite_vertex_keeps_it ? 4711 : 0));
  BOOST_TEST(tr.number_of_cells() == plain.number_of_cells());
  BOOST_TEST(tr.is_valid());
}

// The vertex base of a container that numbers its elements.
template <class Vb = CGAL::Triangulation_vertex_base_3<Epick>>
class Stamped_vertex_base : public Vb
{
public:
  using Has_timestamp = CGAL::Tag_true;
  template <class Tds>
  struct Rebind_TDS
  {
    using Other = Stamped_vertex_base<typename Vb::template Rebind_TDS<Tds>::Other>;
  };
  using Vb::Vb;
  std::size_t time_stamp() const { return m_time_stamp; }
  void set_time_stamp(std::size_t time_stamp) { m_time_stamp = time_stamp; }

private:
  std::size_t m_time_stamp = std::size_t(-1);
};

// A mesh whose points are of MeshKernel, next to plain CGAL triangulation of the converted points.
template <class MeshKernel, class Kernel>
void check_kernels()
{
  BOOST_TEST_CONTEXT(boost::typeindex::type_id<MeshKernel>().pretty_name())
  {
    using Tr = CGAL::Delaunay_triangulation_3<Kernel>;
    using Mesh = CGAL::Surface_mesh<typename MeshKernel::Point_3>;
    const CGAL::Cartesian_converter<Epick, MeshKernel> to_mesh;
    const CGAL::Cartesian_converter<MeshKernel, Kernel> to_triangulation;
    const auto source = surfaces::to_mesh<CGAL::Surface_mesh<Point>>(surfaces::terrain(300));
    Mesh mesh;
    for (const auto v : source.vertices()) // by thirds: no double holds them exactly
      mesh.add_vertex(CGAL::ORIGIN +
                      (to_mesh(source.point(v)) - CGAL::ORIGIN) / typename MeshKernel::FT(3));
    for (const auto f : source.faces()) {
      std::vector<typename Mesh::Vertex_index> corners;
      for (const auto v : vertices_around_face(source.halfedge(f), source))
        corners.emplace_back(v.idx());
      mesh.add_face(corners);
    }
    std::vector<typename Kernel::Point_3> points;
    for (const auto v : mesh.vertices())
      points.push_back(to_triangulation(mesh.point(v)));
    Tr tr, plain(points.begin(), points.end());
    CGAL::insert_surface_vertices_3(tr, mesh);
    BOOST_TEST((tr == plain));
    BOOST_TEST(tr.is_valid());
  }
}

template <class Kernel>
std::vector<std::size_t> calls_of_plain(const std::vector<Point>& points)
{
  CGAL::Delaunay_triangulation_3<Kernel> tr;
  tr.insert(points.begin(), points.end());
  return tr.geom_traits().calls();
}

} // namespace

BOOST_AUTO_TEST_CASE(non_empty_triangulation)
{
  check_non_empty_of_all_dimensions<Triangulation>();
}

BOOST_AUTO_TEST_CASE(fast_location)
{
  using Tr = CGAL::Delaunay_triangulation_3<Epick, CGAL::Fast_location>;
  check_non_empty_of_all_dimensions<Tr>();

  const Indexed_surface surface = surfaces::genus_surface(2, 20000, 0.05);
  const Triangulation plain(surface.points.begin(), surface.points.end());
  Tr tr;
  insert_points_3(tr, surface.points, surface.faces);
  BOOST_TEST(tr.is_valid()); // all levels
  BOOST_TEST(tr.number_of_cells() == plain.number_of_cells());

  // The upper levels are used by locate(), insert() and remove(), and follow a copy.
  Tr copy(tr);
  BOOST_TEST(copy.is_valid());
  for (Tr* t : {&tr, &copy}) {
    for (std::size_t i = 0; i < surface.points.size(); i += 97) {
      int li, lj;
      Tr::Locate_type type;
      const auto cell = t->locate(surface.points[i], type, li, lj);
      BOOST_TEST_REQUIRE(type == Tr::VERTEX);
      BOOST_TEST(cell->vertex(li)->point() == surface.points[i]);
    }
    t->insert(Point(0.001, 0.002, 0.003));
    t->remove(t->nearest_vertex(surface.points[0]));
    BOOST_TEST(t->is_valid());
    BOOST_TEST(t->number_of_vertices() == plain.number_of_vertices());
  }
}

BOOST_AUTO_TEST_CASE(fast_location_written_the_long_way)
{
  using Tds = Triangulation::Triangulation_data_structure;
  using Vb = CGAL::Triangulation_vertex_base_3<Epick>;
  using Cb = CGAL::Delaunay_triangulation_cell_base_3<Epick>;
  static_assert(std::is_same<Tds, CGAL::Triangulation_data_structure_3<Vb, Cb>>::value, "");
  check_non_empty<CGAL::Tracing_traits_3,
                  CGAL::Delaunay_triangulation_3<Epick, Tds, CGAL::Fast_location>>({});
}

BOOST_AUTO_TEST_CASE(info_is_kept)
{
  struct Info
  {
    int value = 0;
  };
  using Vb = CGAL::Triangulation_vertex_base_with_info_3<Info, Epick>;
  using Cb =
      CGAL::Triangulation_cell_base_with_info_3<int, Epick,
                                                CGAL::Delaunay_triangulation_cell_base_3<Epick>>;
  using Tr = CGAL::Delaunay_triangulation_3<Epick, CGAL::Triangulation_data_structure_3<Vb, Cb>>;
  const Indexed_surface surface = torus();

  Tr empty;
  empty.infinite_vertex()->info().value = 4711;
  insert_points_3(empty, surface.points, surface.faces);
  BOOST_TEST(empty.infinite_vertex()->info().value == 4711);
  BOOST_TEST(empty.number_of_vertices() == surface.points.size());

  Tr tr(surface.points.begin(), surface.points.begin() + 300);
  tr.infinite_vertex()->info().value = 4711;
  for (auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
    v->info().value = 1;
  insert_points_3(tr, surface.points, surface.faces);
  BOOST_TEST(tr.infinite_vertex()->info().value == 4711);
  std::size_t marked = 0;
  for (auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
    marked += v->info().value == 1;
  BOOST_TEST(marked == 300u);
  BOOST_TEST(tr.is_valid());

  // The map is what a user fills the info with.
  std::vector<std::pair<std::size_t, Tr::Vertex_handle>> map;
  insert_points_3(tr, surface.points, surface.faces,
                  CGAL::parameters::vertex_to_vertex_output_iterator(std::back_inserter(map)));
  for (const auto& [i, v] : map)
    v->info().value = int(i);
  for (auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
    BOOST_TEST((v->point() == surface.points[std::size_t(v->info().value)]));
}

// An empty triangulation is built aside, and no vertex is copied for that.
BOOST_AUTO_TEST_CASE(infos_that_cannot_be_copied)
{
  check_info<Movable_info>(true);
  check_info<List_info>(true);
  check_info<Constant_info>(true);
  check_info<Immovable_info>(false);
  check_info<Copyable_info, CGAL::Fast_location>(true); // which CGAL makes only of such
}

// The infinite vertex gets its content from another, and not its number.
BOOST_AUTO_TEST_CASE(time_stamps_stay_different)
{
  using Cb = CGAL::Delaunay_triangulation_cell_base_3<Epick>;
  using Tds = CGAL::Triangulation_data_structure_3<Stamped_vertex_base<>, Cb>;
  const auto& [points, faces] = torus();
  CGAL::Delaunay_triangulation_3<Epick, Tds> tr;
  tr.infinite_vertex()->set_time_stamp(7);
  insert_points_3(tr, points, faces);
  std::set<std::size_t> time_stamps;
  for (auto v = tr.all_vertices_begin(); v != tr.all_vertices_end(); ++v)
    time_stamps.insert(v->time_stamp());
  BOOST_TEST(time_stamps.size() == points.size() + 1);
}

#ifdef CGAL_LINKED_WITH_TBB
BOOST_AUTO_TEST_CASE(parallel_tag)
{
  using Tds = CGAL::Triangulation_data_structure_3<CGAL::Triangulation_vertex_base_3<Epick>,
                                                   CGAL::Delaunay_triangulation_cell_base_3<Epick>,
                                                   CGAL::Parallel_tag>;
  using Tr = CGAL::Delaunay_triangulation_3<Epick, Tds>;
  const Indexed_surface surface = surfaces::genus_surface(1, 4000, 0.05);
  Tr::Lock_data_structure locks(CGAL::Bbox_3(-9, -9, -9, 9, 9, 9), 20);
  const auto middle = surface.points.begin() + 2000;
  Tr without_locks, with_locks(Epick(), &locks),
      half(surface.points.begin(), middle, Epick(), &locks);
  const Tr plain(surface.points.begin(), surface.points.end());
  for (Tr* tr : {&without_locks, &with_locks, &half}) {
    const auto lock_structure = tr->get_lock_data_structure();
    insert_points_3(*tr, surface.points, surface.faces);
    BOOST_TEST((*tr == plain));
    BOOST_TEST(tr->is_valid());
    BOOST_TEST(tr->get_lock_data_structure() == lock_structure);
    BOOST_TEST(tr->is_parallel() == (lock_structure != nullptr));
    // The parallel insertion of CGAL can go on from there.
    const std::vector<Point> more = surfaces::sphere(3000, 0.1).points;
    Tr plain_of_both(plain);
    plain_of_both.insert(more.begin(), more.end());
    tr->insert(more.begin(), more.end());
    BOOST_TEST((*tr == plain_of_both));
  }
}

BOOST_AUTO_TEST_CASE(arrays_by_many_threads)
{
  for (const tests::Named_surface& named : tests::degenerate_surfaces(6000))
    BOOST_TEST_CONTEXT(named.name)
    {
      const auto& [points, faces] = named.surface;
      tests::arrays::check_arrays(CGAL::delaunay_3_arrays<std::int32_t, CGAL::Parallel_tag>(points),
                                  points);
      tests::arrays::check_arrays(
          CGAL::delaunay_3_arrays<std::int32_t, CGAL::Parallel_tag>(points, faces), points);
    }
}
#else
BOOST_AUTO_TEST_CASE(parallel_tag)
{
  BOOST_TEST_MESSAGE("skipped: Parallel_tag, as TBB was not found");
  BOOST_TEST(true);
}
#endif

BOOST_AUTO_TEST_CASE(kernels_that_differ)
{
  check_kernels<Epick, Epick>();
  check_kernels<Epeck, Epick>();
  check_kernels<Epick, Epeck>();
  check_kernels<Epeck, Epeck>();
  check_kernels<CGAL::Simple_cartesian<double>, Epick>();
  check_kernels<CGAL::Simple_cartesian<float>, Epick>();
  check_kernels<CGAL::Simple_cartesian<CGAL::Exact_rational>, Epick>();
  check_kernels<CGAL::Simple_cartesian<CGAL::Exact_rational>, Epeck>();
}

BOOST_AUTO_TEST_CASE(numbers_that_are_not_finite_with_exact_kernels)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<std::vector<std::size_t>> no_faces;
  for (const double x : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
    CGAL::Delaunay_triangulation_3<Epeck> tr;
    BOOST_CHECK_THROW(insert_points_3(tr, std::vector<Point>{{0, 0, 0}, {1, x, 0}}, no_faces),
                      CGAL::Surface_input_error);
    BOOST_TEST(tr.number_of_vertices() == 0u);
  }

  // Larger than any double: good for an exact triangulation, refused by the other.
  const Epeck::FT huge = Epeck::FT(1e200) * Epeck::FT(1e200);
  const std::vector<Epeck::Point_3> points = {{0, 0, 0},     {huge, 0, 0}, {0, huge, 0},
                                              {0, 0, -huge}, {1, 2, 3},    {huge, 1, 1}};
  const CGAL::Delaunay_triangulation_3<Epeck> plain(points.begin(), points.end());
  CGAL::Delaunay_triangulation_3<Epeck> exact;
  Triangulation inexact;
  insert_points_3(exact, points, no_faces);
  BOOST_TEST((exact == plain));
  BOOST_CHECK_THROW(insert_points_3(inexact, points, no_faces), CGAL::Surface_input_error);
  BOOST_TEST(inexact.number_of_vertices() == 0u);
}

// A class such as Alpha_shape_3: it is served as the triangulation it is derived from, and its own
// members are left alone.
BOOST_AUTO_TEST_CASE(class_derived_from_a_triangulation)
{
  struct Derived : Triangulation
  {
    int mine = 42;
  };
  const Indexed_surface surface = torus();
  const Triangulation plain(surface.points.begin(), surface.points.end());
  Derived derived;
  insert_points_3(derived, surface.points, surface.faces);
  BOOST_TEST((static_cast<const Triangulation&>(derived) == plain));
  BOOST_TEST(derived.mine == 42);
}

BOOST_AUTO_TEST_CASE(spatial_order_is_that_of_plain_insertion_by_insertion)
{
  using Tr = CGAL::Delaunay_triangulation_3<tests::Recording_kernel>;
  std::vector<Named_surface> all = tests::tiny_and_flat_surfaces();
  all.push_back({"torus", torus()});
  all.push_back({"lattice", surfaces::lattice_surface(2, 2000)});
  Indexed_surface torn = surfaces::sphere(500, 0.01);
  surfaces::duplicate_points(torn, 300, 3);
  all.push_back({"sphere with duplicates", torn});
  for (const Named_surface& named : all)
    BOOST_TEST_CONTEXT(named.name)
    {
      const auto& [points, faces] = named.surface;
      const auto plain_calls = calls_of_plain<tests::Recording_kernel>(points);
      Tr plain_order, tracing;
      insert_points_3(plain_order, points, faces, CGAL::Plain_insertion_traits_3());
      BOOST_TEST((plain_order.geom_traits().calls() == plain_calls));
      // The record would show a difference: the paper's order calls other predicates.
      insert_points_3(tracing, points, faces, CGAL::Tracing_traits_3());
      BOOST_TEST((points.size() < 500 || tracing.geom_traits().calls() != plain_calls));

      using Counting = meters::Predicate_counting_traits_3<Epick>;
      CGAL::Delaunay_triangulation_3<Counting> counted_plain, counted;
      counted_plain.insert(points.begin(), points.end());
      insert_points_3(counted, points, faces, CGAL::Plain_insertion_traits_3());
      const meters::Predicate_counts a = counted_plain.geom_traits().counts();
      const meters::Predicate_counts b = counted.geom_traits().counts();
      BOOST_TEST(a.orientation == b.orientation);
      BOOST_TEST(a.negative_orientation == b.negative_orientation);
      BOOST_TEST(a.in_sphere == b.in_sphere);
      BOOST_TEST(a.other == b.other);
    }
}

BOOST_AUTO_TEST_CASE(spatial_order_is_that_of_plain_in_a_triangulation_with_points)
{
  using Tr = CGAL::Delaunay_triangulation_3<tests::Recording_kernel>;
  const auto& [points, faces] = torus();
  const std::vector<Point> old_points = surfaces::sphere(200, 0.3).points;
  Tr plain, tr;
  plain.insert(old_points.begin(), old_points.end());
  plain.insert(points.begin(), points.end());
  tr.insert(old_points.begin(), old_points.end());
  insert_points_3(tr, points, faces, CGAL::Plain_insertion_traits_3());
  BOOST_TEST((plain.geom_traits().calls() == tr.geom_traits().calls()));
}

BOOST_AUTO_TEST_CASE(exception_of_a_predicate_leaves_an_empty_triangulation_alone)
{
  using Tr = CGAL::Delaunay_triangulation_3<tests::Recording_kernel>;
  const auto& [points, faces] = torus();
  for (const std::size_t call : {0, 1, 10, 1000, 20000}) {
    Tr tr;
    const auto infinite = tr.infinite_vertex();
    tr.geom_traits().fail_at_call(call);
    BOOST_CHECK_THROW(insert_points_3(tr, points, faces), std::runtime_error);
    BOOST_TEST(tr.number_of_vertices() == 0u);
    BOOST_TEST((tr.infinite_vertex() == infinite));
    tr.geom_traits().fail_at_call(std::size_t(-1));
    insert_points_3(tr, points, faces);
    BOOST_TEST((tr == Tr(points.begin(), points.end())));
  }
}

BOOST_AUTO_TEST_CASE(a_seed_determines_everything)
{
  const Indexed_surface surface = torus();
  const auto insert = [&](auto traits, unsigned int seed) {
    CGAL::Delaunay_triangulation_3<tests::Recording_kernel> tr;
    insert_points_3(tr, surface.points, surface.faces, traits, CGAL::parameters::random_seed(seed));
    return tr;
  };
  const auto check = [&](auto traits, bool draws) {
    const auto one = insert(traits, 1), again = insert(traits, 1), two = insert(traits, 2);
    BOOST_TEST((one.geom_traits().calls() == again.geom_traits().calls()));
    BOOST_TEST((finite_points(one) == finite_points(again))); // the order of the handles
    BOOST_TEST((one.geom_traits().calls() != two.geom_traits().calls()) == draws);
    BOOST_TEST((finite_points(one) != finite_points(two)) == draws);
    BOOST_TEST((one == two));
    const auto by_default = insert(traits, 0);
    CGAL::Delaunay_triangulation_3<tests::Recording_kernel> unnamed;
    insert_points_3(unnamed, surface.points, surface.faces, traits);
    BOOST_TEST((finite_points(by_default) == finite_points(unnamed)));
  };
  check(CGAL::Tracing_traits_3(), true);
  check(CGAL::Surface_insertion_policies_3<DFS::No_subgraph, DFS::Surface_net_rounds,
                                           DFS::Planned_hints_3>(),
        true);
  check(CGAL::Surface_insertion_traits_3(), false);
  check(CGAL::Plain_insertion_traits_3(), false);
}
