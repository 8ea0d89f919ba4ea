// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Parallel_tag: any triangulation filled by many threads is the one that plain CGAL makes; and what
// callers do with threads, stops and exceptions.

#define BOOST_TEST_MODULE test_threads
#include <boost/test/included/unit_test.hpp>

#include <Delaunay_from_surface_3_meters/Surface_net_rounds.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Tracing_traits_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/delaunay_3_arrays.h>
#include <CGAL/insert_points_3.h>

#ifdef CGAL_LINKED_WITH_TBB

#include "cancelled_tasks.h"
#include "check_arrays.h"
#include "rounding_modes.h"

#include <Delaunay_from_surface_3_surfaces/adversarial.h>
#include <Delaunay_from_surface_3_surfaces/genus_surface.h>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Epick::Point_3;
using Triangulation = CGAL::Delaunay_triangulation_3<Epick>;
namespace DFS = CGAL::Delaunay_from_surface_3;
using surfaces::Indexed_surface;

struct Counting_visitor : CGAL::Default_surface_insertion_visitor_3
{
  std::size_t threads = 0, stops_at = std::size_t(-1), asked = 0;
  std::size_t farthest = 0, farthest_before_replaced = 0;
  bool throws = false;

  void notice(CGAL::Surface_insertion_notice what, const std::string&)
  {
    if (what == CGAL::Surface_insertion_notice::ORDER_IS_REPLACED)
      farthest_before_replaced = farthest;
  }
  void phase_begins(CGAL::Surface_insertion_phase phase, std::size_t number)
  {
    if (phase == CGAL::Surface_insertion_phase::INSERTION)
      threads = number;
  }
  bool go_further(std::size_t i)
  {
    farthest = i;
    if (asked++ != stops_at)
      return true;
    if (throws)
      throw std::runtime_error("the visitor's own");
    return false;
  }
};

// In an arena of eight threads, on whatever cores there are.
template <class F>
void with_eight_threads(const F& f)
{
  tbb::global_control eight(tbb::global_control::max_allowed_parallelism, 8);
  tbb::task_arena(8).execute(f);
}

std::vector<std::pair<const char*, Indexed_surface>> cases()
{
  Indexed_surface doubled = surfaces::genus_surface(0, 6000, 0.1);
  surfaces::duplicate_points(doubled, 3000, 5);
  return {{"genus 3 with noise", surfaces::genus_surface(3, 12000, 0.1)},
          {"plate without noise", surfaces::plate_surface(2, 9000)},
          {"duplicates", doubled},
          {"star", surfaces::star(9000, 1)},
          {"faces at random", surfaces::faces_at_random(6000, 1)},
          {"two lines", surfaces::two_lines(3000)},
          {"nearly flat", surfaces::nearly_flat(6000, 1e-12, 1)},
          {"noisy sheet", surfaces::noisy_sheet(6000, 60, 1)},
          {"thin tube", surfaces::thin_tube(3000, 60)},
          {"far points", surfaces::far_points(6000, 123, 1)},
          {"sentinels", surfaces::sentinels(6000, 123, 1)}};
}

template <class Tr>
void check(Tr& tr, const Indexed_surface& surface, const Tr& plain)
{
  std::vector<std::pair<std::size_t, typename Tr::Vertex_handle>> map;
  Counting_visitor visitor;
  const std::ptrdiff_t gained = CGAL::insert_points_3<CGAL::Parallel_tag>(
      tr, surface.points, surface.faces,
      CGAL::parameters::visitor(std::ref(visitor))
          .vertex_to_vertex_output_iterator(std::back_inserter(map)));
  BOOST_TEST(visitor.threads == 8u);
  BOOST_TEST((tr == plain));
  BOOST_TEST(tr.tds().is_valid());
  BOOST_TEST(std::size_t(gained) == plain.number_of_vertices());
  BOOST_TEST(map.size() == surface.points.size());
  for (const auto& [i, v] : map)
    if (v->point() != surface.points[i]) {
      BOOST_ERROR("a vertex is not that of its point");
      break;
    }
}

} // namespace

BOOST_AUTO_TEST_CASE(surfaces_by_many_threads)
{
  for (const auto& [name, surface] : cases()) {
    const Triangulation plain(surface.points.begin(), surface.points.end());
    BOOST_TEST_CONTEXT(name)
    with_eight_threads([&, &surface = surface] {
      Triangulation tr;
      check(tr, surface, plain);
    });
  }
}

struct Numbers_visitor : CGAL::Default_surface_insertion_visitor_3
{
  std::vector<std::size_t> numbers;

  bool go_further(std::size_t inserted)
  {
    numbers.push_back(inserted);
    return true;
  }
};

// Though the caller's thread takes batches from others, which may lie before its own.
BOOST_AUTO_TEST_CASE(progress_never_falls)
{
  const Indexed_surface surface = surfaces::genus_surface(3, 60000, 0.1);
  with_eight_threads([&] {
    for (int i = 0; i < 5; ++i) {
      Triangulation tr;
      Numbers_visitor visitor;
      CGAL::insert_points_3<CGAL::Parallel_tag>(tr, surface.points,
                                                CGAL::parameters::visitor(std::ref(visitor)));
      BOOST_TEST(visitor.numbers.size() > 20u);
      BOOST_TEST(std::is_sorted(visitor.numbers.begin(), visitor.numbers.end()));
      BOOST_TEST(visitor.numbers.back() <= surface.points.size());
    }
  });
}

BOOST_AUTO_TEST_CASE(a_triangulation_for_many_threads)
{
  using Tds = CGAL::Triangulation_data_structure_3<CGAL::Triangulation_vertex_base_3<Epick>,
                                                   CGAL::Delaunay_triangulation_cell_base_3<Epick>,
                                                   CGAL::Parallel_tag>;
  using Parallel = CGAL::Delaunay_triangulation_3<Epick, Tds>;
  const Indexed_surface surface = surfaces::genus_surface(1, 12000, 0.1);
  const Parallel plain(surface.points.begin(), surface.points.end());
  with_eight_threads([&] {
    Parallel tr;
    check(tr, surface, plain);
    Counting_visitor by_default;
    Parallel other;
    insert_points_3(other, surface.points, surface.faces,
                    CGAL::parameters::visitor(std::ref(by_default)));
    BOOST_TEST(by_default.threads == 8u);
    BOOST_TEST((other == plain));
    other.clear();
    CGAL::insert_points_3<CGAL::Sequential_tag>(other, surface.points,
                                                CGAL::parameters::visitor(std::ref(by_default)));
    BOOST_TEST(by_default.threads == 1u);
    BOOST_TEST((other == plain));
  });
}

BOOST_AUTO_TEST_CASE(points_alone)
{
  for (const auto& [name, surface] : cases()) {
    const Triangulation plain(surface.points.begin(), surface.points.end());
    BOOST_TEST_CONTEXT(name)
    with_eight_threads([&, &surface = surface] {
      Triangulation tr;
      Counting_visitor visitor;
      CGAL::insert_points_3<CGAL::Parallel_tag>(tr, surface.points,
                                                CGAL::parameters::visitor(std::ref(visitor)));
      BOOST_TEST(visitor.threads == 8u);
      BOOST_TEST((tr == plain));
    });
  }
}

// In nets the hubs come first, and two thousand of them have a million cells.
BOOST_AUTO_TEST_CASE(an_order_over_its_budget_is_found_early)
{
  const Indexed_surface surface = surfaces::skew_stars(36000, 1);
  const Triangulation plain(surface.points.begin(), surface.points.end());
  with_eight_threads([&] {
    Triangulation tr;
    Counting_visitor visitor;
    const CGAL::Surface_insertion_policies_3<DFS::No_subgraph, DFS::Surface_net_rounds,
                                             DFS::Planned_hints_3>
        by_nets;
    CGAL::insert_points_3<CGAL::Parallel_tag>(tr, surface.points, surface.faces, by_nets,
                                              CGAL::parameters::visitor(std::ref(visitor)));
    BOOST_TEST((tr == plain));
    BOOST_TEST(visitor.farthest_before_replaced > 0u);
    BOOST_TEST(visitor.farthest_before_replaced < 2000u); // the end of a chunk
  });
}

// Of equal points the one with the smallest index gives the info, whichever thread came first.
BOOST_AUTO_TEST_CASE(infos_of_duplicates)
{
  using Vb = CGAL::Triangulation_vertex_base_with_info_3<std::size_t, Epick>;
  using Tds =
      CGAL::Triangulation_data_structure_3<Vb, CGAL::Delaunay_triangulation_cell_base_3<Epick>>;
  Indexed_surface surface = surfaces::genus_surface(0, 4000, 0.1);
  surfaces::duplicate_points(surface, 4000, 3);
  std::vector<std::pair<Point, std::size_t>> pairs;
  for (const Point& p : surface.points)
    pairs.push_back({p, pairs.size()});
  with_eight_threads([&] {
    CGAL::Delaunay_triangulation_3<Epick, Tds> one, many;
    CGAL::insert_points_3<CGAL::Sequential_tag>(one, pairs);
    CGAL::insert_points_3<CGAL::Parallel_tag>(many, pairs);
    BOOST_TEST((one == many));
    std::map<Point, std::size_t> infos;
    for (const auto v : one.finite_vertex_handles())
      infos[v->point()] = v->info();
    for (const auto v : many.finite_vertex_handles())
      if (infos.at(v->point()) != v->info()) {
        BOOST_ERROR("another info");
        break;
      }
  });
}

// Traces follow one insertion after the other.
BOOST_AUTO_TEST_CASE(hints_that_are_not_concurrent)
{
  const Indexed_surface surface = surfaces::genus_surface(1, 4000, 0.1);
  const Triangulation plain(surface.points.begin(), surface.points.end());
  with_eight_threads([&] {
    Triangulation tr;
    Counting_visitor visitor;
    CGAL::insert_points_3<CGAL::Parallel_tag>(tr, surface.points, surface.faces,
                                              CGAL::Tracing_traits_3(),
                                              CGAL::parameters::visitor(std::ref(visitor)));
    BOOST_TEST(visitor.threads == 1u);
    BOOST_TEST((tr == plain));
  });
}

BOOST_AUTO_TEST_CASE(stops_and_exceptions_leave_an_empty_triangulation)
{
  const Indexed_surface surface = surfaces::genus_surface(1, 12000, 0.1);
  const Triangulation plain(surface.points.begin(), surface.points.end());
  with_eight_threads([&] {
    Triangulation tr;
    // The caller is asked once a batch, and the first eight rounds have fewer points than one.
    for (const std::size_t stops_at : {0, 5, 10, 15})
      for (const bool throws : {false, true}) {
        Counting_visitor visitor;
        visitor.stops_at = stops_at;
        visitor.throws = throws;
        const auto insert = [&] {
          return CGAL::insert_points_3<CGAL::Parallel_tag>(
              tr, surface.points, surface.faces, CGAL::parameters::visitor(std::ref(visitor)));
        };
        if (throws)
          BOOST_CHECK_THROW(insert(), std::runtime_error);
        else
          BOOST_TEST(insert() == 0);
        BOOST_TEST(tr.number_of_vertices() == 0u);
        BOOST_TEST(tr.dimension() == -1);
      }
    check(tr, surface, plain);
  });
}

// The limit of a caller is kept. That workers may run one after the other is for test_workers.
BOOST_AUTO_TEST_CASE(a_limit_of_one_thread)
{
  const Indexed_surface surface = surfaces::genus_surface(1, 12000, 0.1);
  const Triangulation plain(surface.points.begin(), surface.points.end());
  tbb::task_arena(8).execute([&] {
    Triangulation tr;
    tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    Counting_visitor visitor;
    CGAL::insert_points_3<CGAL::Parallel_tag>(tr, surface.points, surface.faces,
                                              CGAL::parameters::visitor(std::ref(visitor)));
    BOOST_TEST(visitor.threads == 1u);
    BOOST_TEST((tr == plain));
  });
}

BOOST_AUTO_TEST_CASE(in_the_loop_of_a_caller)
{
  const Indexed_surface surface = surfaces::genus_surface(2, 6000, 0.1);
  const Triangulation plain(surface.points.begin(), surface.points.end());
  std::vector<Triangulation> triangulations(6);
  with_eight_threads([&] {
    tbb::parallel_for(std::size_t(0), triangulations.size(), [&](std::size_t k) {
      CGAL::insert_points_3<CGAL::Parallel_tag>(triangulations[k], surface.points, surface.faces);
    });
  });
  for (const Triangulation& tr : triangulations)
    BOOST_TEST((tr == plain));
}

namespace {

// When a call's own group of tasks is cancelled.
struct Moment
{
  const char* name;
  bool is_before_call = false;
  std::optional<std::size_t> face = std::nullopt; // that is read
  std::optional<CGAL::Surface_insertion_phase> phase = std::nullopt;
  std::optional<std::size_t> insertion = std::nullopt;
};

const Moment moments[] = {
    {"before the call", true},
    {"reading faces", false, 5000},
    {"before the order", false, {}, CGAL::Surface_insertion_phase::PLAN},
    {"before the subgraph", false, {}, CGAL::Surface_insertion_phase::SUBGRAPH},
    {"first insertion", false, {}, {}, 0},
    {"insertions by many", false, {}, {}, 12},
    {"before the export", false, {}, CGAL::Surface_insertion_phase::FINISH},
    {"after the export", false, {}, CGAL::Surface_insertion_phase::DONE}};

struct Cancelling_visitor : Counting_visitor
{
  const Moment& moment;
  std::function<void()> cancel;

  Cancelling_visitor(const Moment& m, std::function<void()> c)
    : moment(m)
    , cancel(std::move(c))
  {
  }
  void phase_begins(CGAL::Surface_insertion_phase phase, std::size_t number)
  {
    Counting_visitor::phase_begins(phase, number);
    if (phase == moment.phase)
      cancel();
  }
  bool go_further(std::size_t inserted)
  {
    if (asked == moment.insertion)
      cancel();
    return Counting_visitor::go_further(inserted);
  }
};

using Faces = decltype(Indexed_surface::faces);

// Reads a face; one of them cancels.
struct Read_face
{
  const Faces* faces;
  const Moment* moment;
  const std::function<void()>* cancel;

  const Faces::value_type& operator()(std::size_t f) const
  {
    if (f == moment->face)
      (*cancel)();
    return (*faces)[f];
  }
};

// What calls of all forms are to make of a surface; each says whether it was made.
struct Calls
{
  const Indexed_surface& surface;
  const Triangulation plain{surface.points.begin(), surface.points.end()};
  const tests::arrays::Cells cells =
      tests::arrays::cells_of(CGAL::delaunay_3_arrays(surface.points));

  using Cancel = std::function<void()>;
  using Call = std::function<bool(const Moment&, const Cancel&)>;

  std::vector<std::pair<const char*, Call>> all() const
  {
    return {{"soup", [this](const Moment& m, const Cancel& c) { return soup(m, c); }},
            {"points", [this](const Moment& m, const Cancel& c) { return points(m, c); }},
            {"arrays of a soup",
             [this](const Moment& m, const Cancel& c) {
               return arrays(m, c, [&](const auto&... np) {
                 return CGAL::delaunay_3_arrays<std::int32_t, CGAL::Parallel_tag>(
                     surface.points, faces(m, c), np...);
               });
             }},
            {"arrays of points", [this](const Moment& m, const Cancel& c) {
               return arrays(m, c, [&](const auto&... np) {
                 return CGAL::delaunay_3_arrays<std::int32_t, CGAL::Parallel_tag>(surface.points,
                                                                                  np...);
               });
             }}};
  }

private:
  using Face_iterator = boost::transform_iterator<Read_face, boost::counting_iterator<std::size_t>>;

  CGAL::Iterator_range<Face_iterator> faces(const Moment& moment, const Cancel& cancel) const
  {
    const Read_face read{&surface.faces, &moment, &cancel};
    return {Face_iterator(boost::counting_iterator<std::size_t>(0), read),
            Face_iterator(boost::counting_iterator<std::size_t>(surface.faces.size()), read)};
  }

  bool soup(const Moment& moment, const Cancel& cancel) const
  {
    Triangulation tr;
    Cancelling_visitor visitor(moment, cancel);
    CGAL::insert_points_3<CGAL::Parallel_tag>(tr, surface.points, faces(moment, cancel),
                                              CGAL::parameters::visitor(std::ref(visitor)));
    return visitor.threads == 8 && tr == plain && tr.tds().is_valid();
  }

  bool points(const Moment& moment, const Cancel& cancel) const
  {
    Triangulation tr;
    Cancelling_visitor visitor(moment, cancel);
    CGAL::insert_points_3<CGAL::Parallel_tag>(tr, surface.points,
                                              CGAL::parameters::visitor(std::ref(visitor)));
    return visitor.threads == 8 && tr == plain && tr.tds().is_valid();
  }

  template <class Make>
  bool arrays(const Moment& moment, const Cancel& cancel, const Make& make) const
  {
    Cancelling_visitor visitor(moment, cancel);
    const auto made = make(CGAL::parameters::visitor(std::ref(visitor)));
    return visitor.threads == 8 && tests::arrays::cells_of(made) == cells;
  }
};

} // namespace

// Who cancels the group of tasks that a call is one of does not cancel the call's own tasks.
BOOST_AUTO_TEST_CASE(in_a_cancelled_group)
{
  const Indexed_surface surface = surfaces::genus_surface(1, 9000, 0.1);
  const Calls calls{surface};
  for (const auto& [form, call] : calls.all())
    for (const Moment& moment : moments)
      for (const bool throws : {false, true}) {
        bool is_right = false, arrives = false;
        with_eight_threads([&, &call = call] {
          const auto check = [&](const auto& cancel) {
            if (moment.is_before_call)
              cancel();
            is_right = call(moment, cancel);
          };
          if (throws)
            arrives = tests::call_beside_one_that_throws(check);
          else
            tests::call_in_group(check);
        });
        BOOST_TEST_CONTEXT(form << ", " << moment.name)
        {
          BOOST_TEST(is_right);
          BOOST_TEST(arrives == throws);
        }
      }
}

// The lines of the manual's page on threads, where a call is to end with the group it is in.
BOOST_AUTO_TEST_CASE(a_visitor_that_asks_for_cancellation)
{
  const Indexed_surface surface = surfaces::genus_surface(1, 12000, 0.1);
  const auto& points = surface.points;
  const auto& faces = surface.faces;
  const auto goes_on = [](double) { return !tbb::is_current_task_group_canceling(); };
  const tbb::global_control two(tbb::global_control::max_allowed_parallelism, 2);
  tbb::task_arena(2).execute([&] {
    Triangulation tr;
    tests::call_in_group([&](const auto&) {
      CGAL::insert_points_3<CGAL::Parallel_tag>(tr, points, faces,
                                                CGAL::parameters::visitor(goes_on));
    });
    BOOST_TEST((tr == Triangulation(points.begin(), points.end())));

    for (const double share : {0., .1, .17}) { // the last is when both threads work
      tr.clear();
      double told = -1;
      tests::call_in_group([&](const auto& cancel) {
        CGAL::insert_points_3<CGAL::Parallel_tag>(tr, points, faces,
                                                  CGAL::parameters::visitor([&](double inserted) {
                                                    told = inserted;
                                                    if (inserted >= share)
                                                      cancel();
                                                    return goes_on(inserted);
                                                  }));
      });
      BOOST_TEST(tr.number_of_vertices() == 0u);
      BOOST_TEST(told >= share);
      BOOST_TEST(told < 1);
    }
  });
}

BOOST_AUTO_TEST_CASE(several_callers_at_once)
{
  const Indexed_surface surface = surfaces::genus_surface(2, 6000, 0.1);
  const Triangulation plain(surface.points.begin(), surface.points.end());
  const tbb::global_control eight(tbb::global_control::max_allowed_parallelism, 8);
  std::vector<Triangulation> triangulations(4);
  std::vector<std::thread> callers;
  for (Triangulation& tr : triangulations)
    callers.emplace_back(
        [&] { CGAL::insert_points_3<CGAL::Parallel_tag>(tr, surface.points, surface.faces); });
  for (std::thread& caller : callers)
    caller.join();
  for (const Triangulation& tr : triangulations)
    BOOST_TEST((tr == plain));
}

BOOST_AUTO_TEST_CASE(rounding_modes)
{
  const Indexed_surface surface = surfaces::plate_surface(1, 6000);
  const Triangulation plain(surface.points.begin(), surface.points.end());
  std::vector<Point> denormals;
  for (const Point& p : surface.points)
    denormals.emplace_back(std::ldexp(p.x(), -1060), std::ldexp(p.y(), -1060),
                           std::ldexp(p.z(), -1060));
  const Triangulation tiny(denormals.begin(), denormals.end());
  for (const fuzz::Rounding_mode& mode : fuzz::rounding_modes) {
    Triangulation tr, other;
    bool is_kept = false;
    {
      const fuzz::Rounding rounding(mode);
      with_eight_threads([&] {
        CGAL::insert_points_3<CGAL::Parallel_tag>(tr, surface.points, surface.faces);
        CGAL::insert_points_3<CGAL::Parallel_tag>(other, denormals, surface.faces);
      });
      is_kept = rounding.is_kept();
    }
    BOOST_TEST_CONTEXT(mode.name)
    {
      BOOST_TEST((tr == plain));
      BOOST_TEST((other == tiny));
      BOOST_TEST(is_kept);
    }
  }
}

#else

BOOST_AUTO_TEST_CASE(skipped)
{
  BOOST_TEST_MESSAGE("skipped: Parallel_tag, as TBB was not found");
  BOOST_TEST(true);
}

#endif
