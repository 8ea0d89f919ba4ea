// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Does test_workers notice a wrong handshake? Its stress is run with one part of the handshake left
// out after the other, in child processes, until one fails: wrong cells, a crash, an exception, or
// no end.
//
// Left to test_handshake, which tries all orders of steps: the fence and the second reading of
// neighbours. They guard against moments of some nanoseconds, and were not missed when 1,092 and 669
// triangulations were made without them on two busy cores: two to eight threads, batches of one and
// eight, up to 3,000 points, with and without threads that were interrupted every 100 or 300
// microseconds.
//
// Points with weights need two parts more, outside the handshake. Without either every run fails.
//
// Arguments after `--`: seconds per part (30 by default; it ends at the first failure, after one as
// a rule).

#define BOOST_TEST_MODULE test_workers_mutated
#include <boost/test/included/unit_test.hpp>

#include "parallel_case.h"

#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

using CGAL::Delaunay_from_surface_3::internal::Handshake;

struct Without_mask : Handshake
{
  static constexpr bool masks_own_mark = false;
};
struct Without_outside : Handshake
{
  static constexpr bool compares_outside = false;
};
struct Without_busy : Handshake
{
  static constexpr bool heeds_busy = false;
};

double seconds_per_part()
{
  const auto& suite = boost::unit_test::framework::master_test_suite();
  return suite.argc > 1 ? std::atof(suite.argv[1]) : 30;
}

// Dense sets in which workers meet often: few points in many small batches.
template <class Protocol>
bool is_right(unsigned seed)
{
  const char* const kinds[] = {"cube", "sphere", "moment curve", "hub"};
  const std::size_t n = seed % 4 == 2 ? 60 : seed % 8 < 4 ? 100 : 300;
  const auto points = tests::points_of(kinds[seed % 4], n, seed);
  const std::size_t batch = seed % 3 == 0 ? 1 : 8;
  const tests::Thread_executor executor(seed % 2 == 0 ? 2 : 3);
  using Worker =
      CGAL::Delaunay_from_surface_3::internal::Insertion_worker<tests::Compact_vertex, Protocol>;
  const auto many =
      tests::insert_by_many<tests::Compact_vertex, Worker>(points, executor, {30, 8, batch});
  return many.is_valid && many.cells == tests::cells_by_one(points);
}

// How a child process ended.
struct Ending
{
  std::string how; // empty: all was right
  unsigned cases;
};

// Tries seeds first, first + 1, … in a child process for so many seconds.
template <class Protocol>
Ending run_child(unsigned first, double seconds)
{
  int ends[2];
  BOOST_REQUIRE(pipe(ends) == 0);
  const pid_t child = fork();
  BOOST_REQUIRE(child >= 0);
  if (child == 0) {
    for (const int s : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGALRM, SIGTRAP})
      std::signal(s, SIG_DFL); // Boost.Test has its own
    const rlimit no_core = {0, 0}, memory = {rlim_t(2) << 30, rlim_t(2) << 30};
    setrlimit(RLIMIT_CORE, &no_core);
    setrlimit(RLIMIT_AS, &memory);
    alarm(unsigned(seconds) + 5); // a case takes less than a second
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    try {
      for (unsigned seed = first; std::chrono::steady_clock::now() < end; ++seed) {
        (void)!write(ends[1], "", 1);
        if (!is_right<Protocol>(seed))
          _exit(1);
      }
    } catch (...) {
      _exit(2);
    }
    _exit(0);
  }
  close(ends[1]);
  Ending ending{"", 0};
  for (char c; read(ends[0], &c, 1) == 1;)
    ++ending.cases;
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFSIGNALED(status))
    ending.how = WTERMSIG(status) == SIGALRM
                     ? "no end"
                     : "a crash by signal " + std::to_string(WTERMSIG(status));
  else if (WEXITSTATUS(status) != 0)
    ending.how = WEXITSTATUS(status) == 1 ? "wrong cells" : "an exception";
  return ending;
}

template <class Protocol>
std::string failure(const char* name, double seconds = seconds_per_part())
{
  const Ending ending = run_child<Protocol>(1, seconds);
  BOOST_TEST_MESSAGE(name << ": " << (ending.how.empty() ? "no failure" : ending.how) << ", cases "
                          << ending.cases);
  return ending.how;
}

} // namespace

BOOST_AUTO_TEST_CASE(with_all_parts_there_is_no_failure)
{
  BOOST_TEST(failure<Handshake>("all parts", 2) == "");
}

BOOST_AUTO_TEST_CASE(without_the_mask_of_the_own_mark)
{
  BOOST_TEST(failure<Without_mask>("without the mask") != "");
}

BOOST_AUTO_TEST_CASE(without_the_cells_outside)
{
  BOOST_TEST(failure<Without_outside>("without outside") != "");
}

BOOST_AUTO_TEST_CASE(without_the_busy_bit)
{
  BOOST_TEST(failure<Without_busy>("without busy") != "");
}

// --- points with weights -----------------------------------------------------------------------

namespace {

using tests::Id;
using tests::Weighted_vertex;

// Starting_cells without living_cell(). The cell of a vertex that was swallowed may be dead: then
// the walk clashes, even when the caller's thread is alone, and would be tried without end.
class Start_even_if_dead
{
public:
  explicit Start_even_if_dead(const tests::Subject<Weighted_vertex>& subject)
    : m_subject(&subject)
  {
  }

  Id start(std::size_t i)
  {
    m_tries = i == m_last ? m_tries + 1 : 1;
    m_last = i;
    if (m_tries > 10) // three times by its worker, and by the caller when fresh cells lack
      throw std::logic_error("an insertion clashes with nobody");
    using tests::DFS::internal::load_relaxed;
    Id v = load_relaxed(m_subject->vertex_of[i]);
    while (i > 0 && v == 0)
      v = load_relaxed(m_subject->vertex_of[i = m_subject->halves[i]]);
    return load_relaxed(m_subject->complex.vertex(v != 0 ? v : m_subject->any_vertex).cell);
  }
  void after_update(std::size_t, Id) {}

private:
  const tests::Subject<Weighted_vertex>* m_subject;
  std::size_t m_last = 0, m_tries = 0;
};

} // namespace

BOOST_AUTO_TEST_CASE(without_another_start_for_a_dead_one)
{
  using Worker = tests::DFS::internal::Insertion_worker<Weighted_vertex>;
  for (const std::size_t threads : {1, 3}) {
    const tests::Thread_executor executor(threads);
    const auto balls = tests::balls_of("cube", 3000, 1);
    BOOST_TEST(tests::insert_by_many<Weighted_vertex>(balls, executor).is_valid);
    BOOST_CHECK_THROW(
        (tests::insert_by_many<Weighted_vertex, Worker, Start_even_if_dead>(balls, executor)),
        std::logic_error);
  }
}

// leave_out_hidden_vertices() with a look at the cell alone. Its place may have a cell of others.
BOOST_AUTO_TEST_CASE(without_a_look_for_the_vertex_in_its_cell)
{
  tests::Subject<Weighted_vertex> subject(tests::balls_of("cube", 3000, 1));
  tests::insert_by_one(subject);
  BOOST_TEST(subject.knows_hidden_vertices());
  BOOST_TEST(!subject.knows_hidden_vertices([&](Id v) {
    return !tests::Complex::is_dead(subject.complex.cell(subject.complex.vertex(v).cell));
  }));
}
