// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures what threads gain: whole calls into an ordinary triangulation and into arrays, by one
// thread and by more, beside plain CGAL and its Parallel_tag, in turn; and, by simulation, how often up to 64
// workers would get into each other's way. Writes JSON.

#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_comparison/peers.h>
#include <Delaunay_from_surface_3_comparison/run_program.h>
#include <Delaunay_from_surface_3_comparison/surfaces.h>
#include <Delaunay_from_surface_3_surfaces/clusters.h>
#include <Delaunay_from_surface_3_surfaces/adversarial.h>

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/core/kernel/Ordered_complex.h>
#include <CGAL/Delaunay_from_surface_3/core/order/spaced_rounds.h>
#include <CGAL/Delaunay_from_surface_3/core/threads/Insertion_worker.h>
#include <CGAL/Delaunay_from_surface_3/core/threads/Parallel_triangulation.h>
#include <CGAL/Delaunay_from_surface_3/paper/insertion_plans.h>
#include <CGAL/Delaunay_from_surface_3/support/Executor.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/delaunay_3_arrays.h>
#include <CGAL/insert_points_3.h>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace DFS = CGAL::Delaunay_from_surface_3;
using CGAL::Epick;
using comparison::Json;
using comparison::rounded;
using surfaces::Indexed_surface;
using Triangulation = CGAL::Delaunay_triangulation_3<Epick>;
using Parallel_triangulation = CGAL::Delaunay_triangulation_3<
    Epick, CGAL::Triangulation_data_structure_3<CGAL::Triangulation_vertex_base_3<Epick>,
                                                CGAL::Delaunay_triangulation_cell_base_3<Epick>,
                                                CGAL::Parallel_tag>>;

constexpr std::uint64_t seed = 2024;

// Wall-clock seconds of the parts of a call, and what the insertions did.
struct Watch : CGAL::Default_surface_insertion_visitor_3
{
  double plan = 0, insertion = 0, finish = 0;
  DFS::Insertion_counts counts;

  void phase_begins(CGAL::Surface_insertion_phase phase, std::size_t)
  {
    using Phase = CGAL::Surface_insertion_phase;
    if (phase != Phase::PLAN && phase != Phase::SUBGRAPH && phase != Phase::FINISH &&
        phase != Phase::DONE)
      return; // within the insertion
    const double now = comparison::Steady_seconds()();
    (phase == Phase::SUBGRAPH ? plan
     : phase == Phase::FINISH ? insertion
                              : finish) += phase == Phase::PLAN ? 0 : now - m_since;
    m_since = now;
  }
  template <class Target, class Hints>
  void insertion_ends(const Target& target, const Hints&)
  {
    counts = target.counts();
  }

private:
  double m_since = 0;
};

struct Times
{
  std::vector<double> wall, cpu;

  template <class Work>
  void add(const Work& work)
  {
    const comparison::Time time = comparison::time_of(work);
    wall.push_back(time.wall);
    cpu.push_back(time.cpu);
  }
  Json json() const
  {
    return {{"median_wall", rounded(comparison::median(wall))},
            {"median_cpu", rounded(comparison::median(cpu))},
            {"wall", wall}};
  }
};

struct Options
{
  std::vector<std::string> names, peers;
  std::vector<std::size_t> sizes = {64000, 256000, 1000000};
  std::vector<std::size_t> threads = {1, 2};
  std::vector<unsigned> simulated;
  std::size_t repetitions = 5;
  bool memory = false;
  std::string data_dir = "build/data/meshes";
};

template <class F>
void with_threads(std::size_t number, const F& f)
{
  tbb::global_control control(tbb::global_control::max_allowed_parallelism, number);
  tbb::task_arena(int(number)).execute(f);
}

void insert(Triangulation& tr, const Indexed_surface& surface, std::size_t threads, Watch& watch)
{
  const auto np = CGAL::parameters::visitor(std::ref(watch));
  if (threads == 1)
    CGAL::insert_points_3<CGAL::Sequential_tag>(tr, surface.points, surface.faces, np);
  else
    CGAL::insert_points_3<CGAL::Parallel_tag>(tr, surface.points, surface.faces, np);
}

Json phases(const Watch& watch)
{
  return {{"plan", rounded(watch.plan)},
          {"insertion", rounded(watch.insertion)},
          {"finish", rounded(watch.finish)},
          {"clashes", watch.counts.clashes},
          {"put_off", watch.counts.put_off}};
}

// Whole calls on one surface, in turn, and those of other programs.
class Turns
{
public:
  Turns(const Indexed_surface& surface, const Options& options, comparison::Launcher* launcher)
    : m_surface(surface)
    , m_options(options)
    , m_launcher(launcher)
  {
    for (const std::string& text : options.peers)
      m_peers.emplace_back(comparison::parse_peer(text));
    if (!m_peers.empty())
      m_points.emplace(surface.points);
  }

  // Adds "times" and, with peers, "peers" to `result`.
  void run(Json& result)
  {
    for (std::size_t r = 0; r < m_options.repetitions; ++r)
      take_turn(r == 0);
    result["times"] = times();
    const double plain_cpu = comparison::median(m_plain.cpu);
    for (const auto& peer : m_peers)
      result["peers"].push_back(peer.as_json(plain_cpu, m_tetrahedra));
  }

private:
  void take_turn(bool is_compared)
  {
    Triangulation expected;
    m_plain.add([&] { expected.insert(m_surface.points.begin(), m_surface.points.end()); });
    m_tetrahedra = expected.number_of_finite_cells();
    for (const std::size_t threads : m_options.threads)
      with_threads(threads, [&] {
        insert_ours(threads, is_compared ? &expected : nullptr);
        make_arrays(threads);
      });
    with_threads(m_options.threads.back(), [&] { insert_in_parallel(); });
    for (auto& peer : m_peers)
      peer.run(*m_launcher, m_points->name());
  }

  void insert_ours(std::size_t threads, const Triangulation* expected)
  {
    Triangulation tr;
    Watch watch;
    m_ours[threads].add([&] { insert(tr, m_surface, threads, watch); });
    m_watches[threads] = watch;
    if (expected && tr != *expected)
      throw std::runtime_error("not equal to plain CGAL");
  }

  void make_arrays(std::size_t threads)
  {
    CGAL::Delaunay_3_arrays<> arrays;
    m_arrays[threads].add([&] {
      arrays = threads == 1
                   ? CGAL::delaunay_3_arrays<std::int32_t, CGAL::Sequential_tag>(m_surface.points)
                   : CGAL::delaunay_3_arrays<std::int32_t, CGAL::Parallel_tag>(m_surface.points);
    });
    if (arrays.number_of_simplices() != m_tetrahedra)
      throw std::runtime_error("the arrays have another number of tetrahedra than plain CGAL");
  }

  void insert_in_parallel()
  {
    const CGAL::Bbox_3 box = CGAL::bbox_3(m_surface.points.begin(), m_surface.points.end());
    Parallel_triangulation::Lock_data_structure locks(box, 50);
    Parallel_triangulation tr(Epick(), &locks);
    m_plain_parallel.add([&] { tr.insert(m_surface.points.begin(), m_surface.points.end()); });
  }

  Json times() const
  {
    Json result = {{"plain", m_plain.json()}, {"plain_parallel", m_plain_parallel.json()}};
    for (const std::size_t threads : m_options.threads) {
      Json of_threads = m_ours.at(threads).json();
      of_threads["phases"] = phases(m_watches.at(threads));
      result["threads_" + std::to_string(threads)] = of_threads;
      result["arrays_" + std::to_string(threads)] = m_arrays.at(threads).json();
    }
    return result;
  }

  const Indexed_surface& m_surface;
  const Options& m_options;
  comparison::Launcher* m_launcher; // needed for peers
  Times m_plain, m_plain_parallel;
  std::map<std::size_t, Times> m_ours, m_arrays;
  std::map<std::size_t, Watch> m_watches; // of the last turn
  std::vector<comparison::Peer_record> m_peers;
  std::optional<comparison::Points_file> m_points;
  std::size_t m_tetrahedra = 0;
};

// Of processes that do nothing else, each with its own number of threads.
Json measure_memory(const Indexed_surface& surface, const Options& options)
{
  Json result;
  for (const std::size_t number : options.threads) {
    const std::string name = "threads_" + std::to_string(number);
    const auto build = [&](const auto& look) {
      Triangulation tr;
      Watch watch;
      with_threads(number, [&] { insert(tr, surface, number, watch); });
      look();
    };
    result[name] = comparison::memory_as_json(comparison::memory_of_build(name, build),
                                              double(surface.points.size()));
  }
  return result;
}

// How often many workers get into each other's way, found by one thread that plays them all: in
// turn each writes the star whose zone it announced before, and announces the next, so that every
// zone stays announced while all others act. Wherever many cores can be had they clash less: their
// insertions overlap for a part of the time only.
class Simulation
{
  using Id = DFS::internal::Id;
  using Vertex = DFS::internal::Compact_vertex;
  using Point = Epick::Point_3;
  using Complex = DFS::internal::Compact_complex<Vertex>;
  using Worker = DFS::internal::Insertion_worker<Vertex>;
  using Try = DFS::internal::Insertion_try;

public:
  // Of a plan's points; `points` are in its order.
  Simulation(const std::vector<Point>& points, const DFS::Insertion_order& plan, unsigned workers)
    : m_plan(plan)
    , m_complex(points.size(),
                [&](std::size_t i) {
                  return std::array<double, 3>{points[i].x(), points[i].y(), points[i].z()};
                })
    , m_shared(m_complex, workers)
    , m_vertex_of(points.size(), 0)
  {
    m_any_vertex = DFS::internal::start_complex(
        DFS::internal::starting_simplex(m_vertex_of.size(),
                                        [&](std::size_t i) {
                                          return m_complex.exact_coordinates(
                                              Complex::vertex_of_point(i));
                                        }),
        m_complex, m_vertex_of);
    m_shared.make_room(24 * points.size()); // it cannot grow while zones are announced
    for (unsigned t = 0; t < workers; ++t)
      m_workers.push_back(std::make_unique<Worker>(m_shared, t));
  }

  // Inserts all points; returns for each round the number of insertions that were rolled back.
  std::vector<std::size_t> run()
  {
    std::vector<std::size_t> rolled_back;
    std::size_t first = 0;
    for (const std::size_t last : m_plan.round_ends) {
      rolled_back.push_back(round(first, last));
      first = last;
    }
    return rolled_back;
  }

private:
  // Deals out a round as Parallel_triangulation does a chunk.
  std::size_t round(std::size_t first, std::size_t last)
  {
    namespace internal = DFS::internal;
    const internal::Parallel_rules rules;
    std::size_t number = (std::min)(m_workers.size(), (last - first) / rules.points_per_worker);
    number = first < rules.first_points || number == 0 ? 1 : number;
    internal::Shares shares(first, last, number);
    std::vector<std::size_t> announced(number, none), put_off;
    std::vector<internal::Shares::Range> batches(number, {0, 0});
    std::size_t rolled_back = 0;
    for (bool is_active = true; is_active;) {
      is_active = false;
      for (std::size_t t = 0; t < number; ++t) {
        const auto clash = [&](std::size_t i) {
          ++rolled_back;
          put_off.push_back(i);
        };
        if (announced[t] != none) {
          if (finish(t, announced[t]) == Try::CLASH)
            clash(announced[t]);
          announced[t] = none;
        }
        if (batches[t].first == batches[t].second)
          batches[t] = shares.take(t, rules.batch);
        if (batches[t].first == batches[t].second)
          continue;
        is_active = true;
        const std::size_t i = batches[t].first++;
        if (const Try outcome = announce(t, i); outcome == Try::CLASH)
          clash(i);
        else if (outcome == Try::DONE)
          announced[t] = i;
      }
    }
    for (const std::size_t i : put_off)
      if (announce(0, i) == Try::DONE)
        finish(0, i);
    return rolled_back;
  }

  Try announce(std::size_t t, std::size_t i)
  {
    if (m_vertex_of[i] != 0)
      return Try::PRESENT;
    Id present = Complex::vertex_of_point(i);
    const Try outcome = m_workers[t]->announce(present, start(i), present,
                                               (std::numeric_limits<std::size_t>::max)());
    if (outcome == Try::PRESENT)
      m_vertex_of[i] = present;
    if (outcome == Try::NO_CELLS)
      throw std::length_error("the simulation has too few cells");
    return outcome;
  }

  Try finish(std::size_t t, std::size_t i)
  {
    const Try outcome = m_workers[t]->write(Complex::vertex_of_point(i));
    if (outcome == Try::DONE)
      m_vertex_of[i] = Complex::vertex_of_point(i);
    return outcome;
  }

  Id start(std::size_t i) const
  {
    std::size_t place = m_plan.starting_places[i];
    while (m_vertex_of[place] == 0 && place != 0)
      place = m_plan.starting_places[place];
    const Id v = m_vertex_of[place];
    return m_complex.vertex(v != 0 ? v : m_any_vertex).cell;
  }

  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  const DFS::Insertion_order& m_plan;
  Complex m_complex;
  DFS::internal::Shared_complex<Vertex> m_shared;
  std::vector<Id> m_vertex_of;
  Id m_any_vertex = 0;
  std::vector<std::unique_ptr<Worker>> m_workers;
};

// Per number of workers the insertions rolled back, by round.
Json simulate(const Indexed_surface& surface, const std::vector<unsigned>& numbers)
{
  namespace internal = DFS::internal;
  const auto coordinates = internal::rounded_coordinates(surface.points);
  const DFS::Insertion_order plan =
      internal::spaced_rounds({coordinates.data(), surface.points.size()});
  const auto points = internal::permuted(surface.points, plan.order);
  Json result = {{"round_ends", plan.round_ends}};
  for (const unsigned number : numbers)
    result["workers_" + std::to_string(number)] = Simulation(points, plan, number).run();
  return result;
}

std::vector<comparison::Named_surface> chosen_surfaces(const Options& options)
{
  auto all = comparison::named_surfaces(options.data_dir);
  all.push_back(shuffled(all[0]));
  all.push_back(shuffled(all[1]));
  all.push_back({"plummer", "a star cluster, points alone", 100, surfaces::plummer_sphere});
  all.push_back(
      {"soneira-peebles", "clusters of clusters, points alone", 100, surfaces::soneira_peebles});
  all.push_back({"boxes", "turned boxes over three decades, float coordinates, points alone", 1000,
                 surfaces::boxes_of_gaussians});
  std::vector<comparison::Named_surface> result;
  for (const auto& surface : all)
    if (options.names.empty() ||
        std::find(options.names.begin(), options.names.end(), surface.name) != options.names.end())
      result.push_back(surface);
  return result;
}

void measure_into(const Options& options, Json& report)
{
  std::optional<comparison::Launcher> launcher;
  if (!options.peers.empty())
    launcher.emplace(); // before anything large is in memory
  report["repetitions"] = options.repetitions;
  report["results"] = Json::array();
  for (const std::size_t n : options.sizes)
    for (const auto& named : chosen_surfaces(options)) {
      if (n < named.least_size)
        continue;
      const Indexed_surface surface = named.make(n, seed);
      Json result = {{"surface", named.name}, {"points", surface.points.size()}};
      if (options.memory) // threads that were started would be missing in a child
        result["memory"] = measure_memory(surface, options);
      else if (options.repetitions > 0)
        Turns(surface, options, launcher ? &*launcher : nullptr).run(result);
      if (!options.simulated.empty())
        result["rolled_back"] = simulate(surface, options.simulated);
      std::cerr << result.dump() << "\n";
      report["results"].push_back(std::move(result));
    }
  report["machine"]["load_after"] = comparison::load_average();
}

} // namespace

int main(int argc, char** argv)
{
  Options o;
  comparison::Program program("measure_threads", "Measures what threads gain.");
  program.option("surfaces", o.names, "NAME...", "default: all");
  program.option("sizes", o.sizes, "N...", "numbers of vertices");
  program.option("threads", o.threads, "N...", "numbers of threads");
  program.option("simulate", o.simulated, "N...",
                 "numbers of workers that one thread plays, to count rollbacks");
  program.option("peer", o.peers, "NAME=COMMAND",
                 "one more program, as for compare_with_plain; may be repeated");
  program.option("memory", o.memory, "memory instead of times");
  program.option("repetitions,r", o.repetitions, "N", "of each, in turn; 0: no times");
  program.option("data-dir", o.data_dir, "DIR", "the meshes of libcgal-demo");
  return program.run(argc, argv, [&](Json& report) { measure_into(o, report); });
}
