// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_COUNTS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_COUNTS_H

// The types that are compared. Where the time of an insertion goes: its three stages, which cost nothing
// to tell apart, and its phases, for which the clock is read twice per point. And what the insertions of
// a method do, counted in a run of its own: these counts do not depend on the machine.

#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_meters/meters.h>

#include <CGAL/Delaunay_from_surface_3/Default_surface_insertion_visitor_3.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/insert_surface_vertices_3.h>

#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <numeric>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace comparison {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Counting_kernel = meters::Predicate_counting_traits_3<Kernel>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;
using Fast_triangulation = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Fast_location>;
using Counted_triangulation = CGAL::Delaunay_triangulation_3<Counting_kernel>;

// Looks at a triangulation of one of the types that are timed.
using Look = std::function<void(std::variant<const Triangulation*, const Fast_triangulation*>)>;

// CGAL's own insertion of a range of points, in the order of the mesh.
template <class Tr>
void insert_plain(Tr& tr, const Mesh& mesh)
{
  tr.insert(mesh.points().begin(), mesh.points().end());
}

template <class Traits, class Tr, class Visitor>
void insert_by_package(Tr& tr, const Mesh& mesh, unsigned int seed, Visitor& visitor)
{
  CGAL::insert_surface_vertices_3(tr, mesh, Traits(),
                                  CGAL::parameters::random_seed(seed).visitor(std::ref(visitor)));
}

using Phase = CGAL::Surface_insertion_phase;
using Timing_visitor = meters::Metering_visitor_3<Steady_seconds>;

inline const std::vector<std::pair<const char*, Phase>>& phases()
{
  static const std::vector<std::pair<const char*, Phase>> all = {
      {"plan", Phase::PLAN},         {"subgraph", Phase::SUBGRAPH}, {"trace", Phase::TRACE},
      {"location", Phase::LOCATION}, {"update", Phase::UPDATE},     {"finish", Phase::FINISH}};
  return all;
}

inline constexpr std::array<const char*, 3> stage_names = {"plan", "build", "export"};

// CPU seconds of the plan; of all that comes then, subgraph and traces too; and of the export.
class Stage_visitor : public CGAL::Default_surface_insertion_visitor_3
{
public:
  void phase_begins(Phase phase, std::size_t)
  {
    // Where points are inserted, a few comparisons are left of this.
    if (phase == Phase::PLAN)
      begin(0);
    else if (phase == Phase::SUBGRAPH)
      begin(1);
    else if (phase == Phase::FINISH)
      begin(2);
    else if (phase == Phase::DONE)
      begin(3);
  }

  std::array<double, 3> seconds() const
  {
    return {m_begins[1] - m_begins[0], m_begins[2] - m_begins[1], m_begins[3] - m_begins[2]};
  }

private:
  void begin(std::size_t stage) { m_begins[stage] = cpu_seconds(); }

  std::array<double, 4> m_begins = {};
};

// Of one metered run. The clock runs while other processes do; so the shares count, and
// `scale_to_cpu` turns them into CPU time.
inline Json phases_as_json(const Time& total, const Timing_visitor& visitor)
{
  Json seconds;
  double rest = total.wall;
  for (const auto& [name, phase] : phases()) {
    seconds[name] = rounded(visitor.total(phase));
    rest -= visitor.total(phase);
  }
  seconds["input_and_output"] = rounded(rest);
  return {{"wall", rounded(total.wall)},
          {"cpu", rounded(total.cpu)},
          {"scale_to_cpu", rounded(total.cpu / total.wall)},
          {"seconds", seconds}};
}

struct Counted_calls
{
  const meters::Predicate_counts* counts;
  meters::Predicate_counts operator()() const { return *counts; }
};

using Counting_visitor = meters::Metering_visitor_3<Counted_calls>;

// What core and hints have counted is taken at the end of an insertion, inside which they live.
struct Take_counts : CGAL::Default_surface_insertion_visitor_3
{
  CGAL::Delaunay_from_surface_3::Insertion_counts kernel;
  std::size_t cells_destroyed = 0; // that the hints have seen
  bool order_was_replaced = false;

  void notice(CGAL::Surface_insertion_notice what, const std::string&)
  {
    order_was_replaced |= what == CGAL::Surface_insertion_notice::ORDER_IS_REPLACED;
  }

  template <class Target, class Hints>
  void insertion_ends(const Target& target, const Hints& hints)
  {
    kernel = target.counts();
    cells_destroyed = destroyed_seen_by(hints, 0);
  }

private:
  template <class Hints>
  static auto destroyed_seen_by(const Hints& hints, int) -> decltype(hints.cells_destroyed())
  {
    return hints.cells_destroyed();
  }
  template <class Hints>
  static std::size_t destroyed_seen_by(const Hints&, long)
  {
    return 0;
  }
};

// The hints, watching what CGAL's insertion destroys.
template <class Hints>
class Zone_counting_hints : public Hints
{
public:
  using Hints::Hints;

  static constexpr bool observes_conflict_zone = true;

  template <class CellIterator>
  void before_update(std::size_t i, CellIterator first, CellIterator last)
  {
    m_cells_destroyed += std::size_t(std::distance(first, last));
    if constexpr (Hints::observes_conflict_zone)
      Hints::before_update(i, first, last);
  }

  std::size_t cells_destroyed() const { return m_cells_destroyed; }

private:
  std::size_t m_cells_destroyed = 0;
};

template <class Traits>
struct Zone_counting_traits : Traits
{
  template <class Target, class Subgraph>
  using Insertion_hints_3 =
      Zone_counting_hints<typename Traits::template Insertion_hints_3<Target, Subgraph>>;
};

inline Json calls_per_point(const meters::Predicate_counts& counts, std::size_t n)
{
  return {{"cells_entered", per_point(counts.cells_entered(), n)},
          {"orientation", per_point(counts.orientation, n)},
          {"in_sphere", per_point(counts.in_sphere, n)},
          {"other", per_point(counts.other, n)}};
}

// In the phase UPDATE a negative orientation is no step of a walk.
inline Json predicates_as_json(const Counting_visitor& visitor, std::size_t n)
{
  Json result;
  for (const auto& [name, phase] : {phases()[2], phases()[3], phases()[4]})
    result[name] = calls_per_point(visitor.total(phase), n);
  result["update"].erase("cells_entered");
  std::size_t traced = 0;
  for (const auto& round : visitor.rounds())
    traced += round[Phase::TRACE].all() > 0 ? round.number_of_traced_points : 0;
  result["rounds"] = visitor.rounds().size() - 1;
  result["traced_points"] = traced;
  if (traced > 0)
    result["cells_entered_per_traced_point"] =
        per_point(visitor.total(Phase::TRACE).cells_entered(), traced);
  return result;
}

inline Json cells_as_json(std::size_t destroyed, std::size_t created, std::size_t n)
{
  return {{"destroyed", per_point(destroyed, n)}, {"created", per_point(created, n)}};
}

// CGAL's insertion of a range: all that can be seen from outside.
inline Json counts_of_plain(const Mesh& mesh)
{
  Counted_triangulation tr;
  insert_plain(tr, mesh);
  const std::size_t all = tr.geom_traits().counts().all();
  return {{"predicates", {{"all_calls_per_point", per_point(all, mesh.number_of_vertices())}}}};
}

// This package through CGAL's insertion: predicate calls, and in a run of its own cells, since
// whoever looks at conflict zones makes CGAL test one cell more.
template <class Traits>
Json predicates_of_insertion(const Mesh& mesh, unsigned int seed)
{
  Counted_triangulation tr;
  Counting_visitor visitor(Counted_calls{&tr.geom_traits().counts()});
  insert_by_package<Traits>(tr, mesh, seed, visitor);
  const std::size_t n = mesh.number_of_vertices();
  Json predicates = {{"all_calls_per_point", per_point(tr.geom_traits().counts().all(), n)}};
  predicates.update(predicates_as_json(visitor, n));
  return predicates;
}

template <class Traits>
Json counts_of_insertion(const Mesh& mesh, unsigned int seed)
{
  Take_counts counts;
  Triangulation tr;
  insert_by_package<Zone_counting_traits<Traits>>(tr, mesh, seed, counts);
  const std::size_t destroyed = counts.cells_destroyed;
  return {{"predicates", predicates_of_insertion<Traits>(mesh, seed)},
          {"cells",
           cells_as_json(destroyed, destroyed + tr.number_of_cells(), mesh.number_of_vertices())}};
}

// This package through the core: its own counts.
template <class Traits>
Json counts_of_kernel(const Mesh& mesh, unsigned int seed)
{
  Take_counts visitor;
  Triangulation tr;
  insert_by_package<Traits>(tr, mesh, seed, visitor);
  const auto& counts = visitor.kernel;
  const std::size_t n = mesh.number_of_vertices();
  // What the first filter left open, and what all of them did.
  const auto& decided = counts.sphere_tests_by_stage;
  const std::size_t open = std::accumulate(std::begin(decided), std::end(decided), std::size_t(0));
  const std::size_t last = decided[CGAL::Delaunay_from_surface_3::ANY_WIDTH];
  return {{"kernel",
           {{"cells_tested_to_start", per_point(counts.cells_tested_to_start, n)},
            {"sphere_tests", per_point(counts.sphere_tests, n)},
            {"first_filter_failures", per_point(open, n)},
            {"second_filter_failures", per_point(last, n)},
            {"sphere_tests_by_stage", by_exact_stage(counts.sphere_tests_by_stage, n)},
            {"facet_tests_by_stage", by_exact_stage(counts.facet_tests_by_stage, n)},
            {"perturbed", per_point(counts.perturbed, n)}}},
          {"cells", cells_as_json(counts.cells_destroyed, counts.cells_created, n)}};
}

} // namespace comparison

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_COUNTS_H
