// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Several threads make the same graph of a soup, and the same order, as one does.

#define BOOST_TEST_MODULE test_order_by_threads
#include <boost/test/included/unit_test.hpp>

#include "Thread_executor.h"
#include "rounding_modes.h"

#include <Delaunay_from_surface_3_surfaces/genus_surface.h>

#include <CGAL/Delaunay_from_surface_3/door/soup_graph.h>
#include <CGAL/Delaunay_from_surface_3/paper/Surface_net_rounds.h>
#include <CGAL/Delaunay_from_surface_3/support/permutation.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cstddef>
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
DFS::internal::Soup_graph graph_of(const Indexed_surface& surface, const Executor& executor)
{
  return DFS::internal::soup_graph(surface.faces, surface.points.size(), executor);
}

template <class Executor>
DFS::Insertion_order order_of(const Indexed_surface& surface, const Executor& executor)
{
  const auto soup = graph_of(surface, DFS::internal::Alone());
  return DFS::Surface_net_rounds(5)(surface.points, CGAL::Epick(), soup.graph,
                                    DFS::internal::Identity_index_map(), executor);
}

void check(const Indexed_surface& surface)
{
  const auto alone = graph_of(surface, DFS::internal::Alone());
  const auto order = order_of(surface, DFS::internal::Alone());
  BOOST_TEST_REQUIRE(alone.graph.number_of_edges() > 32768u); // so that threads have a part
  for (const std::size_t number : {1, 2, 5}) {
    const tests::Thread_executor executor(number);
    const auto soup = graph_of(surface, executor);
    BOOST_TEST((soup.graph.lists().first == alone.graph.lists().first));
    BOOST_TEST((soup.graph.lists().items == alone.graph.lists().items));
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
        graph_of(surface, executor), CGAL::Surface_input_error,
        [](const std::exception& e) { return std::string(e.what()).find("face 20000: ") == 0; });
  }
}

// What is not executed is no result.
BOOST_AUTO_TEST_CASE(a_part_left_out_is_noticed)
{
  const Indexed_surface surface = surfaces::genus_surface(3, 60000, 0.1);
  const tests::Forgetful_executor executor(2);
  const auto order = order_of(surface, DFS::internal::Alone()).order;
  BOOST_CHECK_THROW(graph_of(surface, executor), std::logic_error);
  BOOST_CHECK_THROW(order_of(surface, executor), std::logic_error);
  BOOST_CHECK_THROW(DFS::internal::permuted(order, order, executor), std::logic_error);
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
