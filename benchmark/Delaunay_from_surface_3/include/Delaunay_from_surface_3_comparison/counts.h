// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_COUNTS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_COUNTS_H

// What the insertions of a method do, counted in a run of its own. They do not depend on the
// machine.

#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_comparison/phases.h>
#include <Delaunay_from_surface_3_comparison/triangulations.h>

#include <Delaunay_from_surface_3_meters/Metering_visitor_3.h>
#include <CGAL/insert_surface_vertices_3.h>
#include <Delaunay_from_surface_3_meters/Predicate_counting_traits_3.h>

#include <cstddef>
#include <functional>
#include <iterator>
#include <numeric>
#include <string>

namespace comparison {

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

inline Json calls_per_point(const meters::Predicate_counts& counts, double n)
{
  return {{"cells_entered", rounded(double(counts.cells_entered()) / n, 1e4)},
          {"orientation", rounded(double(counts.orientation) / n, 1e4)},
          {"in_sphere", rounded(double(counts.in_sphere) / n, 1e4)},
          {"other", rounded(double(counts.other) / n, 1e4)}};
}

// In the phase UPDATE a negative orientation is no step of a walk.
inline Json predicates_as_json(const Counting_visitor& visitor, double n)
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
        rounded(double(visitor.total(Phase::TRACE).cells_entered()) / double(traced), 1e4);
  return result;
}

inline Json cells_as_json(std::size_t destroyed, std::size_t created, double n)
{
  return {{"destroyed", rounded(double(destroyed) / n, 1e4)},
          {"created", rounded(double(created) / n, 1e4)}};
}

// CGAL's insertion of a range: all that can be seen from outside.
inline Json counts_of_plain(const Mesh& mesh)
{
  Counted_triangulation tr;
  insert_plain(tr, mesh);
  const double all = double(tr.geom_traits().counts().all());
  return {{"predicates",
           {{"all_calls_per_point", rounded(all / double(mesh.number_of_vertices()), 1e4)}}}};
}

// This package through CGAL's insertion: predicate calls, and in a run of its own cells, since
// whoever looks at conflict zones makes CGAL test one cell more.
template <class Traits>
Json predicates_of_insertion(const Mesh& mesh, unsigned int seed)
{
  Counted_triangulation tr;
  Counting_visitor visitor(Counted_calls{&tr.geom_traits().counts()});
  CGAL::insert_surface_vertices_3(tr, mesh, Traits(),
                                  CGAL::parameters::random_seed(seed).visitor(std::ref(visitor)));
  const double n = double(mesh.number_of_vertices());
  Json predicates = {
      {"all_calls_per_point", rounded(double(tr.geom_traits().counts().all()) / n, 1e4)}};
  predicates.update(predicates_as_json(visitor, n));
  return predicates;
}

template <class Traits>
Json counts_of_insertion(const Mesh& mesh, unsigned int seed)
{
  Take_counts counts;
  Triangulation tr;
  CGAL::insert_surface_vertices_3(tr, mesh, Zone_counting_traits<Traits>(),
                                  CGAL::parameters::random_seed(seed).visitor(std::ref(counts)));
  const std::size_t destroyed = counts.cells_destroyed;
  return {{"predicates", predicates_of_insertion<Traits>(mesh, seed)},
          {"cells", cells_as_json(destroyed, destroyed + tr.number_of_cells(),
                                  double(mesh.number_of_vertices()))}};
}

// This package through the core: its own counts.
template <class Traits>
Json counts_of_kernel(const Mesh& mesh, unsigned int seed)
{
  Take_counts visitor;
  Triangulation tr;
  CGAL::insert_surface_vertices_3(tr, mesh, Traits(),
                                  CGAL::parameters::random_seed(seed).visitor(std::ref(visitor)));
  const auto& counts = visitor.kernel;
  const double n = double(mesh.number_of_vertices());
  const auto per_point = [n](std::size_t count) { return rounded(double(count) / n, 1e4); };
  const auto by_stage = [&](const std::size_t* decided) {
    using namespace CGAL::Delaunay_from_surface_3;
    return Json{{"half_digit", per_point(decided[HALF_DIGIT])},
                {"one_digit", per_point(decided[ONE_DIGIT])},
                {"balanced", per_point(decided[BALANCED])},
                {"double_double", per_point(decided[DOUBLE_DOUBLE])},
                {"two_digits", per_point(decided[TWO_DIGITS])},
                {"any_width", per_point(decided[ANY_WIDTH])}};
  };
  // What the first filter left open, and what all of them did.
  const auto& decided = counts.sphere_tests_by_stage;
  const std::size_t open = std::accumulate(std::begin(decided), std::end(decided), std::size_t(0));
  const std::size_t last = decided[CGAL::Delaunay_from_surface_3::ANY_WIDTH];
  return {{"kernel",
           {{"cells_tested_to_start", per_point(counts.cells_tested_to_start)},
            {"sphere_tests", per_point(counts.sphere_tests)},
            {"first_filter_failures", per_point(open)},
            {"second_filter_failures", per_point(last)},
            {"sphere_tests_by_stage", by_stage(counts.sphere_tests_by_stage)},
            {"facet_tests_by_stage", by_stage(counts.facet_tests_by_stage)},
            {"perturbed", per_point(counts.perturbed)}}},
          {"cells", cells_as_json(counts.cells_destroyed, counts.cells_created, n)}};
}

} // namespace comparison

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_COUNTS_H
