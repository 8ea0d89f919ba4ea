// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The handshake of the parallel kernel, in a small model whose executions are all tried, under
// three memory models: insertions that clash never both write, no reader takes a torn cell for a
// whole one, and what is there at the end is right, vertices that others swallowed or hid included.
// Without any one of its parts it fails.

#define BOOST_TEST_MODULE test_handshake
#include <boost/test/included/unit_test.hpp>

#include "explore_model.h"

#include <string>
#include <vector>

namespace {

using namespace model;

// The chain has its vertices at 0, 10, 20, … on a parabola. A point in cell c, so far from its left
// end, is in conflict with that cell if it is not more than so high above the parabola; with the
// next cells if it is low enough.
Point above(unsigned cell, int offset, int height)
{
  const int x = 10 * int(cell) + offset;
  return {x, x * x + height};
}
constexpr int one_cell = 10, three_cells = -100; // for an offset of 5
constexpr int two_cells = -50;                   // for an offset of 2: its cell and the one before

// Its walk starts in the cell of the start-th point, counted from 0. At first that is cell `start`.
struct New_point
{
  unsigned worker;
  Point point;
  Byte start;
};

Case make_case(const char* name, unsigned chain, unsigned workers,
               const std::vector<New_point>& points, bool tries_again = false)
{
  Case c{name, {}, chain, std::vector<std::vector<Task>>(workers), 2, tries_again};
  for (unsigned k = 0; k < chain; ++k)
    c.points.push_back(above(k, 0, 0));
  for (const New_point& p : points) {
    c.points.push_back(p.point);
    c.tasks[p.worker].push_back({Byte(c.points.size()), Byte(p.start + 1)});
  }
  return c;
}

std::vector<Case> small_cases()
{
  return {
      make_case("in one cell", 4, 2,
                {{0, above(1, 5, one_cell), 1}, {1, above(1, 3, one_cell), 0}}),
      make_case("zones that are neighbours", 5, 2,
                {{0, above(1, 5, one_cell), 1}, {1, above(2, 5, one_cell), 2}}),
      make_case("zones that share a cell beside them", 6, 2,
                {{0, above(1, 5, one_cell), 1}, {1, above(3, 5, one_cell), 3}}),
      make_case("zones that overlap", 6, 2,
                {{0, above(2, 2, two_cells), 2}, {1, above(3, 2, two_cells), 3}}),
      make_case("a zone that leaves a dead cell", 6, 2,
                {{0, above(2, 5, three_cells), 2}, {1, above(3, 5, one_cell), 3}}),
      make_case("a zone with the cell that the other leaves dead", 6, 2,
                {{0, above(2, 5, three_cells), 2}, {1, above(1, 5, one_cell), 1}}),
      make_case("a zone beside one that leaves a dead cell", 7, 2,
                {{0, above(2, 5, three_cells), 2}, {1, above(4, 5, one_cell), 4}}),
      make_case("a zone beside the cell that the other leaves dead", 7, 2,
                {{0, above(3, 5, three_cells), 3}, {1, above(1, 5, one_cell), 1}}),
      make_case("a start that is swallowed, in a cell left dead", 7, 2,
                {{0, above(2, 5, three_cells), 1}, {1, above(4, 5, one_cell), 3}}),
      make_case("a start that is swallowed, in a cell that others have", 7, 2,
                {{0, above(2, 2, two_cells), 2}, {1, above(4, 5, one_cell), 2}}),
      make_case("a point that the other swallows or hides", 6, 2,
                {{0, above(2, 5, three_cells), 2}, {1, above(2, 3, one_cell), 2}}),
  };
}

std::vector<Case> large_cases()
{
  return {
      make_case(
          "a second point by the same marks", 5, 2,
          {{0, above(1, 5, one_cell), 1}, {0, above(1, 8, 4), 1}, {1, above(2, 5, one_cell), 2}}),
      make_case("a dead cell that comes to life elsewhere", 8, 2,
                {{0, above(2, 5, three_cells), 2},
                 {0, above(5, 5, one_cell), 5},
                 {1, above(3, 5, one_cell), 3}}),
      make_case("a start that the other swallows or hides", 7, 2,
                {{0, above(2, 5, three_cells), 2},
                 {1, above(2, 3, one_cell), 2},
                 {1, above(4, 5, one_cell), 8}}),
      make_case("a second try", 5, 2,
                {{0, above(1, 5, one_cell), 1}, {1, above(2, 5, one_cell), 2}}, true),
      make_case(
          "three workers", 5, 3,
          {{0, above(1, 5, one_cell), 1}, {1, above(2, 5, one_cell), 2}, {2, above(1, 2, 5), 1}}),
  };
}

std::string report(const char* memory, const Case& c, const Outcome& outcome)
{
  return std::string(memory) + ", " + c.name + ": " + std::to_string(outcome.states) + " states, " +
         std::to_string(outcome.ends) + " ends, at most " + std::to_string(outcome.most_clashes) +
         " clashes" + (outcome.error.empty() ? "" : ": " + outcome.error);
}

template <class Memory>
void check_right(const std::vector<Case>& cases)
{
  for (const Case& c : cases) {
    const Protocol protocol;
    const Outcome outcome = Exploration<Memory>(c, protocol)();
    const std::string text = report(Memory::name, c, outcome);
    BOOST_TEST_MESSAGE(text);
    BOOST_TEST(outcome.error == "", text);
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(sequentially_consistent)
{
  check_right<Sequential_consistency>(small_cases());
  check_right<Sequential_consistency>(large_cases());
}

BOOST_AUTO_TEST_CASE(total_store_order)
{
  check_right<Total_store_order>(small_cases());
  check_right<Total_store_order>(large_cases());
}

BOOST_AUTO_TEST_CASE(relaxed_acquire_release)
{
  check_right<Views>(small_cases());
  check_right<Views>(large_cases());
}

// --- without one part --------------------------------------------------------------------------

namespace {

// The first error in any of the cases.
template <class Memory>
std::string error(const Protocol& protocol)
{
  for (const auto& cases : {small_cases(), large_cases()})
    for (const Case& c : cases) {
      const Outcome outcome = Exploration<Memory>(c, protocol)();
      if (!outcome.error.empty()) {
        BOOST_TEST_MESSAGE(report(Memory::name, c, outcome));
        return outcome.error;
      }
    }
  BOOST_TEST_MESSAGE(Memory::name << ": no error");
  return "";
}

Protocol without(bool Protocol::*part)
{
  Protocol protocol;
  protocol.*part = false;
  return protocol;
}

} // namespace

// Where all threads see one order of steps, no fence is needed.
BOOST_AUTO_TEST_CASE(without_the_fence)
{
  BOOST_TEST(error<Sequential_consistency>(without(&Protocol::has_fence)) == "");
  BOOST_TEST(error<Total_store_order>(without(&Protocol::has_fence)) != "");
  BOOST_TEST(error<Views>(without(&Protocol::has_fence)) != "");
}

namespace {

void check_wrong(bool Protocol::*part)
{
  BOOST_TEST(error<Sequential_consistency>(without(part)) != "");
  BOOST_TEST(error<Total_store_order>(without(part)) != "");
  BOOST_TEST(error<Views>(without(part)) != "");
}

} // namespace

BOOST_AUTO_TEST_CASE(without_the_mask_of_the_own_mark)
{
  check_wrong(&Protocol::masks_own_mark);
}

BOOST_AUTO_TEST_CASE(without_the_second_reading_of_neighbors)
{
  check_wrong(&Protocol::compares_neighbors);
}

BOOST_AUTO_TEST_CASE(without_the_cells_outside)
{
  check_wrong(&Protocol::compares_outside);
}

BOOST_AUTO_TEST_CASE(without_the_busy_bit)
{
  check_wrong(&Protocol::heeds_busy);
}

// In the end the caller walks alone from the cell that is dead, and comes to no end.
BOOST_AUTO_TEST_CASE(without_another_start_for_a_dead_one)
{
  check_wrong(&Protocol::replaces_dead_starts);
}

// A swallowed vertex passes for one that is there, since its cell has been made anew for others.
BOOST_AUTO_TEST_CASE(without_a_look_for_the_vertex_in_its_cell)
{
  check_wrong(&Protocol::looks_for_vertex);
}

// Each order of a load or store that is needed where processors reorder. That outer neighbours are
// released is not: the release fence when the cell behind was opened does as well.
BOOST_AUTO_TEST_CASE(without_an_order)
{
  BOOST_TEST(error<Views>(without(&Protocol::acquires_words)) != "");
  BOOST_TEST(error<Views>(without(&Protocol::acquires_marks)) != "");
  BOOST_TEST(error<Views>(without(&Protocol::releases_marks)) != "");
  BOOST_TEST(error<Views>(without(&Protocol::releases_words)) != "");
  BOOST_TEST(error<Views>(without(&Protocol::has_release_fence)) != "");
  BOOST_TEST(error<Views>(without(&Protocol::has_acquire_fence)) != "");
}
