// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Several threads make the same graph of a soup, the same order, and of the same cells the same arrays
// as one does.

#define BOOST_TEST_MODULE test_order_by_threads
#include <boost/test/included/unit_test.hpp>

#include "Thread_executor.h"
#include "build_in_order.h"
#include "check_arrays.h"
#include "rounding_modes.h"

#include <Delaunay_from_surface_3_surfaces/genus_surface.h>
#include <Delaunay_from_surface_3_surfaces/parametric.h>

#include <CGAL/Delaunay_from_surface_3/arrays/arrays_of_built.h>
#include <CGAL/Delaunay_from_surface_3/core/order/spaced_rounds.h>
#include <CGAL/Delaunay_from_surface_3/surface/soup_edges.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace DFS = CGAL::Delaunay_from_surface_3;
using surfaces::Indexed_surface;

void shuffle(Indexed_surface& surface)
{
  std::vector<std::size_t> order(surface.points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::shuffle(order.begin(), order.end(), std::mt19937(1));
  const auto places = DFS::internal::inverse(order);
  surface.points = DFS::internal::permuted(surface.points, order);
  for (auto& face : surface.faces)
    for (auto& i : face)
      i = places[i];
}

template <class Executor>
DFS::internal::Soup_edges edges_of(const Indexed_surface& surface, const Executor& executor)
{
  return DFS::internal::soup_edges(surface.faces, surface.points.size(), executor);
}

template <class Executor>
DFS::Insertion_order order_of(const Indexed_surface& surface, const Executor& executor)
{
  const auto coordinates = DFS::internal::rounded_coordinates(surface.points);
  return DFS::internal::spaced_rounds({coordinates.data(), surface.points.size()}, executor);
}

void check(const Indexed_surface& surface)
{
  const auto alone = edges_of(surface, DFS::internal::Alone());
  const auto order = order_of(surface, DFS::internal::Alone());
  BOOST_TEST_REQUIRE(alone.lower.items.size() > 32768u); // so that threads have a part
  for (const std::size_t number : {1, 2, 5}) {
    const tests::Thread_executor executor(number);
    const auto soup = edges_of(surface, executor);
    BOOST_TEST((soup.lower.first == alone.lower.first));
    BOOST_TEST((soup.lower.items == alone.lower.items));
    BOOST_TEST(soup.irregularity.value_or("") == alone.irregularity.value_or(""));
    const auto same = order_of(surface, executor);
    BOOST_TEST((same.order == order.order));
    BOOST_TEST((same.round_ends == order.round_ends));
    BOOST_TEST((same.starting_places == order.starting_places));
    BOOST_TEST((DFS::internal::permuted(order.order, order.order, executor) ==
                DFS::internal::permuted(order.order, order.order)));
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(the_same_graph_and_the_same_order)
{
  Indexed_surface surface = surfaces::genus_surface(3, 60000, 0.1);
  check(surface);
  shuffle(surface);
  check(surface);
}

// Sides that are there once, twice and more often, in the parts of all threads.
BOOST_AUTO_TEST_CASE(the_same_irregular_soup)
{
  Indexed_surface surface = surfaces::genus_surface(3, 60000, 0.1);
  for (std::size_t f = 0; f < surface.faces.size(); f += 7)
    surface.faces.push_back(surface.faces[f]);
  check(surface);
}

BOOST_AUTO_TEST_CASE(the_first_bad_face_is_named)
{
  Indexed_surface surface = surfaces::genus_surface(3, 60000, 0.1);
  for (const std::size_t f : {100000, 60000, 20000})
    surface.faces[f][1] = surface.points.size();
  for (const std::size_t number : {1, 2, 5}) {
    const tests::Thread_executor executor(number);
    BOOST_CHECK_EXCEPTION(
        edges_of(surface, executor), CGAL::Surface_input_error,
        [](const std::exception& e) { return std::string(e.what()).find("face 20000: ") == 0; });
  }
}

// What is not executed is no result.
BOOST_AUTO_TEST_CASE(a_part_left_out_is_noticed)
{
  const Indexed_surface surface = surfaces::genus_surface(3, 60000, 0.1);
  const tests::Forgetful_executor executor(2);
  const auto order = order_of(surface, DFS::internal::Alone()).order;
  BOOST_CHECK_THROW(edges_of(surface, executor), std::logic_error);
  BOOST_CHECK_THROW(order_of(surface, executor), std::logic_error);
  BOOST_CHECK_THROW(DFS::internal::permuted(order, order, executor), std::logic_error);
}

// Of points alone, too, whose parts are sorted by whoever comes first: on a surface, in space, and where
// the sample tells nothing, so that nothing is put in parts.
BOOST_AUTO_TEST_CASE(the_same_order_of_points)
{
  const auto on_surface =
      DFS::internal::rounded_coordinates(surfaces::genus_surface(3, 50000, 0.05).points);
  std::vector<double> in_space(on_surface.size()), near_some(on_surface.size());
  std::mt19937 random(1);
  for (double& x : in_space)
    x = std::uniform_real_distribution<double>()(random);
  for (std::size_t i = 0; i < near_some.size(); i += 2)
    near_some[i] = in_space[i % 9];
  const double* const inputs[] = {on_surface.data(), in_space.data(), near_some.data()};
  for (const double* const coordinates : inputs) {
    const DFS::internal::Point_array points(coordinates, in_space.size() / 3);
    const DFS::Insertion_order alone = DFS::internal::spaced_rounds(points);
    for (const std::size_t number : {2, 5}) {
      const auto same = DFS::internal::spaced_rounds(points, tests::Thread_executor(number));
      BOOST_TEST((same.order == alone.order));
      BOOST_TEST((same.round_ends == alone.round_ends));
      BOOST_TEST((same.starting_places == alone.starting_places));
    }
  }
}

// An index of 8 bits stands for one of 32 that numbers the facets of too many simplices.
BOOST_AUTO_TEST_CASE(too_many_items_for_their_numbers)
{
  using Index = unsigned char;
  const auto lists_of = [](std::size_t size, const DFS::internal::Executor& executor) {
    return DFS::internal::in_lists<Index>(
        7,
        DFS::internal::Listed_items(
            size, [](std::size_t k) { return k % 7; }, [](std::size_t k) { return Index(k); }),
        executor);
  };
  const auto most = lists_of(255, DFS::internal::Alone());
  BOOST_TEST(most.items.size() == 255u);
  BOOST_TEST(int(most.end(6)[-1]) == 251);
  BOOST_CHECK_THROW(lists_of(256, DFS::internal::Alone()), std::length_error);
  BOOST_CHECK_THROW(lists_of(40000, tests::Thread_executor(3)), std::length_error);
}

// In whatever mode a thread begins.
BOOST_AUTO_TEST_CASE(every_part_rounds_to_nearest)
{
  for (const fuzz::Rounding_mode& mode : fuzz::rounding_modes) {
    std::vector<char> is_right(4, false);
    bool is_kept = false;
    {
      const fuzz::Rounding rounding(mode);
      DFS::internal::for_each_block(
          tests::Thread_executor(4), 4, 4, [&](std::size_t, std::size_t, std::size_t b) {
            volatile double large = 1, least = 5e-324, least_again = least;
            is_right[b] = least * large > 0 && least + least_again > 0 && large + 1e-16 == 1 &&
                          -large - 1e-16 == -1;
          });
      is_kept = rounding.is_kept();
    }
    BOOST_TEST_CONTEXT(mode.name)
    {
      BOOST_TEST(std::count(is_right.begin(), is_right.end(), true) == 4);
      BOOST_TEST(is_kept);
    }
  }
}

// The cells that one thread has built, of which some are dead, as arrays; of a sphere a third of them
// are infinite, and of points that are there twice one has a vertex.
BOOST_AUTO_TEST_CASE(arrays)
{
  using Index = std::int32_t;
  for (const bool is_sphere : {false, true}) {
    auto points =
        (is_sphere ? surfaces::sphere(40000, 0) : surfaces::genus_surface(3, 40000, 0.05)).points;
    for (std::size_t i = 0; i < 5000; ++i)
      points.push_back(points[(7 * i) % points.size()]);
    const auto coordinates = DFS::internal::rounded_coordinates(points);
    DFS::internal::Given_points source({coordinates.data(), points.size()});
    const DFS::Insertion_order order = DFS::internal::spaced_rounds(source.points());
    const DFS::internal::Order_view view = DFS::internal::view_of(order);
    DFS::internal::Build_options options;
    options.given = &view;
    options.cells_per_point = DFS::internal::Build_options::any_number;
    options.adds_apex = true;
    const auto arrays_by = [&](const DFS::internal::Executor& executor, bool infinite = true) {
      DFS::internal::Observer nobody;
      const auto built =
          DFS::internal::build_by<DFS::internal::Compact_vertex, DFS::internal::Insert_alone>(
              source, options, nobody, executor);
      BOOST_TEST_REQUIRE(built->cells_end > 3u * 65536); // so that threads have a part
      return DFS::internal::arrays_of_built<Index>(*built, source, executor, infinite);
    };
    const CGAL::Delaunay_3_arrays<Index> alone = arrays_by(DFS::internal::Alone());
    tests::arrays::check_arrays(alone, points);
    const std::size_t size = alone.number_of_cells() * alone.stride();
    for (const std::size_t number : {2, 5}) {
      const auto same = arrays_by(tests::Thread_executor(number));
      BOOST_TEST_REQUIRE(same.number_of_cells() == alone.number_of_cells());
      BOOST_TEST(same.number_of_simplices() == alone.number_of_simplices());
      BOOST_TEST(
          std::equal(alone.vertices_data(), alone.vertices_data() + size, same.vertices_data()));
      BOOST_TEST((same.vertices_of_points() == alone.vertices_of_points()));
    }
    CGAL::Delaunay_3_arrays<Index> finite = alone;
    finite.drop_infinite_cells();
    const std::size_t size_of_finite = finite.number_of_cells() * finite.stride();
    for (const std::size_t number : {1, 2}) {
      const auto same = arrays_by(tests::Thread_executor(number), false);
      BOOST_TEST_REQUIRE(same.number_of_cells() == finite.number_of_cells());
      BOOST_TEST(std::equal(same.vertices_data(), same.vertices_data() + size_of_finite,
                            finite.vertices_data()));
    }
  }
}
