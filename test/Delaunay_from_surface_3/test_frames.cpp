// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// From the call of a user to the core's loop of rounds there are four functions at most, as
// CONTRIBUTING.md draws them: what is read in a debugger is what is drawn. Without optimization,
// since what is inline is no frame.

#define BOOST_TEST_MODULE test_frames
#include <boost/test/included/unit_test.hpp>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/delaunay_3_arrays.h>
#include <CGAL/insert_points_3.h>
#include <CGAL/insert_points_along_graph_3.h>
#include <CGAL/insert_surface_vertices_3.h>

#include <boost/graph/adjacency_list.hpp>

#include <cxxabi.h>
#include <execinfo.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;
using Mesh = CGAL::Surface_mesh<Point>;
using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;

namespace {

// The name of a function without scopes, arguments and parameters.
std::string short_name(const std::string& symbol)
{
  const std::size_t open = symbol.find('('), plus = symbol.find('+', open);
  const std::string mangled = symbol.substr(open + 1, plus - open - 1);
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> demangled(
      abi::__cxa_demangle(mangled.c_str(), nullptr, nullptr, &status), &std::free);
  std::string name = status == 0 ? demangled.get() : mangled;
  int depth = 0;
  std::string outside; // of brackets
  for (const char c : name) {
    depth -= c == '>';
    if (depth == 0 && c != '>')
      outside += c;
    depth += c == '<';
  }
  outside.erase(std::remove(outside.begin(), outside.end(), '<'), outside.end());
  const std::string scoped = outside.substr(0, outside.find('('));
  return scoped.substr(scoped.find_last_of(':') + 1);
}

std::vector<std::string> frames()
{
  void* addresses[64];
  const int n = backtrace(addresses, 64);
  const std::unique_ptr<char*, decltype(&std::free)> symbols(backtrace_symbols(addresses, n),
                                                             &std::free);
  std::vector<std::string> names;
  for (int k = 0; k < n; ++k)
    names.push_back(short_name(symbols.get()[k]));
  return names;
}

} // namespace

// Looks at the stack when the first round begins. Functions with it must be seen from outside.
struct Looking_visitor : CGAL::Default_surface_insertion_visitor_3
{
  std::vector<std::string> stack;
  void phase_begins(CGAL::Surface_insertion_phase phase, std::size_t)
  {
    if (phase == CGAL::Surface_insertion_phase::ROUND && stack.empty())
      stack = frames();
  }
};

// A user's function; it has a name that is found again.
extern "C" void the_user_calls(const std::function<void()>& call)
{
  call();
}

namespace {

using Names = std::vector<std::string>;

// From the loop of rounds to the function that is called by the user.
Names way_of(const std::string& function, const std::function<void(Looking_visitor&)>& call)
{
  Looking_visitor visitor;
  the_user_calls([&] { call(visitor); });
  Names way;
  bool is_inside = false;
  for (const std::string& name : visitor.stack) {
    is_inside = is_inside || name == "insert_in_rounds";
    if (is_inside)
      way.push_back(name);
    if (name == function)
      break;
  }
  return way;
}

const Mesh& mesh()
{
  static const Mesh the_mesh = [] {
    Mesh m;
    CGAL::make_tetrahedron(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1), m);
    return m;
  }();
  return the_mesh;
}

const std::vector<Point>& points()
{
  static const std::vector<Point> the_points(mesh().points().begin(), mesh().points().end());
  return the_points;
}

const std::vector<std::array<int, 3>> faces = {{0, 1, 2}, {0, 1, 3}};

auto looking(Looking_visitor& visitor)
{
  return CGAL::parameters::visitor(std::ref(visitor));
}

} // namespace

BOOST_AUTO_TEST_CASE(into_a_triangulation)
{
  const auto way = [](const char* function) {
    return Names{"insert_in_rounds", "build", "insert_through_core", "insert_surface", function};
  };
  Triangulation tr;
  const auto insert = [&](const std::string& function, const auto& call) {
    return way_of(function, [&](Looking_visitor& visitor) {
      tr.clear();
      call(looking(visitor));
    });
  };
  BOOST_TEST(insert("insert_surface_vertices_3", [&](const auto& np) {
               CGAL::insert_surface_vertices_3(tr, mesh(), np);
             }) == way("insert_surface_vertices_3"));
  BOOST_TEST(insert("insert_surface_vertices_3", [&](const auto& np) {
               CGAL::insert_surface_vertices_3(tr, mesh(), CGAL::Surface_insertion_traits_3(), np);
             }) == way("insert_surface_vertices_3"));
  BOOST_TEST(insert("insert_points_3", [&](const auto& np) {
               CGAL::insert_points_3(tr, points(), faces, np);
             }) == way("insert_points_3"));
  BOOST_TEST(insert("insert_points_3", [&](const auto& np) {
               CGAL::insert_points_3(tr, points(), np);
             }) == way("insert_points_3"));
  BOOST_TEST(insert("insert_points_along_graph_3", [&](const auto& np) {
               CGAL::insert_points_along_graph_3(tr, points(), Graph(points().size()), np);
             }) == way("insert_points_along_graph_3"));
}

BOOST_AUTO_TEST_CASE(into_arrays)
{
  const Names way = {"insert_in_rounds", "build", "insert_into_arrays", "delaunay_3_arrays"};
  BOOST_TEST(way_of("delaunay_3_arrays", [](Looking_visitor& visitor) {
               CGAL::delaunay_3_arrays(points(), looking(visitor));
             }) == way);
  BOOST_TEST(way_of("delaunay_3_arrays", [](Looking_visitor& visitor) {
               CGAL::delaunay_3_arrays(points(), faces, looking(visitor));
             }) == way);
}
