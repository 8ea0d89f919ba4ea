// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_FUZZ_CAMPAIGN_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_FUZZ_CAMPAIGN_H

// Runs the cases of a fuzzer for some minutes, and makes each that fails as small as it can.
//
// Cases run in a child process, one after the other: one that crashes, or takes too much time, ends
// that child and is reported as any other failure; the next child goes on after it.
//
//   --minutes M            how long; else the environment variable FUZZ_MINUTES, or one
//   --first SEED           the first case; the next are SEED + 1, …; default 1
//   --failures N           ends after N failures; default 10
//   --case SEED            repeats one case, in this process (for a debugger)
//   --keep I,J,…           of that case only these parts
//
// An interrupt (Ctrl-C) or a termination ends it after the present case, with its counts.

#include "fuzz_subject.h"
#include "fuzz_tally.h"

#include <sys/mman.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace fuzz {

// In memory that child processes see too.
inline volatile std::sig_atomic_t* stop_flag = nullptr;

class Campaign
{
  using Clock = std::chrono::steady_clock;

public:
  Campaign(const Subject& subject, int argc, char** argv)
    : m_subject(subject)
  {
    if (const char* minutes = std::getenv("FUZZ_MINUTES"))
      m_minutes = std::stod(minutes);
    for (int i = 1; i < argc; i += 2) {
      if (i + 1 == argc)
        throw std::invalid_argument(std::string("no value for ") + argv[i]);
      set(argv[i], argv[i + 1]);
    }
    void* const memory =
        mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED)
      throw std::bad_alloc();
    m_shared = new (memory) Shared();
  }

  ~Campaign() { munmap(m_shared, sizeof(Shared)); }
  Campaign(const Campaign&) = delete;
  Campaign& operator=(const Campaign&) = delete;

  // The exit status.
  int run()
  {
    if (m_is_one_case)
      return repeat();
    const auto start = Clock::now();
    m_end = start + std::chrono::milliseconds(std::int64_t(60000 * m_minutes));
    std::size_t failures = 0;
    m_shared->seed = m_first;
    stop_flag = &m_shared->stops;
    for (const int signal : {SIGINT, SIGTERM})
      std::signal(signal, [](int) { *stop_flag = 1; });
    while (goes_on() && failures < m_max_failures) {
      const std::string failure = in_child(seconds_per_case, [this] { return run_cases(); });
      if (failure.empty())
        break;
      ++failures;
      report(failure, seconds_since(start));
      ++m_shared->seed;
    }
    m_shared->tally.print();
    std::printf("%llu cases from seed %llu on in %.0f s, %zu failures; the longest took %.1f s of "
                "CPU time, seed %llu\n",
                static_cast<unsigned long long>(m_shared->cases),
                static_cast<unsigned long long>(m_first), seconds_since(start), failures,
                m_shared->longest, static_cast<unsigned long long>(m_shared->longest_seed));
    return failures == 0 && m_shared->cases > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
  }

private:
  // An endless loop is one that lasts so long, in CPU time of the process. A case takes
  // milliseconds.
  static constexpr int seconds_per_case = 20, seconds_per_smaller_case = 4, seconds_to_shrink = 90;

  // What parent and child both see.
  struct Shared
  {
    volatile std::sig_atomic_t stops = 0;
    Seed seed = 0;
    std::uint64_t cases = 0;
    double longest = 0;
    Seed longest_seed = 0;
    char message[1000] = "";
    Tally tally;
  };

  void set(const std::string& name, const std::string& value)
  {
    if (name == "--minutes")
      m_minutes = std::stod(value);
    else if (name == "--first")
      m_first = std::stoull(value);
    else if (name == "--failures")
      m_max_failures = std::stoull(value);
    else if (name == "--case") {
      m_is_one_case = true;
      m_first = std::stoull(value);
    } else if (name == "--keep") {
      std::istringstream list(value);
      for (std::string index; std::getline(list, index, ',');)
        m_kept.push_back(std::stoull(index));
    } else
      throw std::invalid_argument("unknown option " + name);
  }

  static double seconds_since(Clock::time_point start)
  {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }

  Indices whole(Seed seed) const { return all_parts(m_subject.number_of_parts(seed)); }

  bool goes_on() const { return Clock::now() < m_end && m_shared->stops == 0; }

  // --- in this process ---------------------------------------------------------------------------

  std::string check(Seed seed, const Indices& parts)
  {
    try {
      return m_subject.check(seed, parts, m_shared->tally);
    } catch (const std::exception& e) {
      return std::string("exception: ") + e.what();
    }
  }

  int repeat()
  {
    const Indices parts = m_kept.empty() ? whole(m_first) : m_kept;
    std::printf("%s\n", m_subject.description(m_first, parts).c_str());
    std::fflush(stdout);
    const std::string failure = check(m_first, parts);
    m_shared->tally.print();
    std::printf("%s\n", failure.empty() ? "no failure" : failure.c_str());
    return failure.empty() ? EXIT_SUCCESS : EXIT_FAILURE;
  }

  // Until the end, or the first failure.
  std::string run_cases()
  {
    for (; goes_on(); ++m_shared->seed) {
      limit_time(seconds_per_case);
      const std::clock_t start = std::clock();
      const Seed seed = m_shared->seed;
      const std::string failure = check(seed, whole(seed));
      ++m_shared->cases;
      const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
      if (seconds > m_shared->longest) {
        m_shared->longest = seconds;
        m_shared->longest_seed = seed;
      }
      if (!failure.empty())
        return failure;
    }
    return "";
  }

  // --- in a child --------------------------------------------------------------------------------

  static void limit_time(int seconds)
  {
    const itimerval timer = {{0, 0}, {seconds, 0}};
    setitimer(ITIMER_PROF, &timer, nullptr);
  }

  // What `function` says, or how it died.
  template <class Function>
  std::string in_child(int seconds, const Function& function)
  {
    std::fflush(nullptr);
    m_shared->message[0] = 0;
    const pid_t child = fork();
    if (child < 0)
      throw std::runtime_error("no child process");
    if (child == 0) {
      limit_time(seconds);
      const std::string message = function();
      std::strncpy(m_shared->message, message.c_str(), sizeof(m_shared->message) - 1);
      std::exit(EXIT_SUCCESS); // with the sanitizers: looks for leaks
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
      ;
    if (WIFSIGNALED(status))
      return WTERMSIG(status) == SIGPROF
                 ? "endless loop: more than " + std::to_string(seconds) + " s"
                 : std::string("ended by signal: ") + strsignal(WTERMSIG(status));
    if (WEXITSTATUS(status) != EXIT_SUCCESS)
      return "ended with status " + std::to_string(WEXITSTATUS(status));
    return m_shared->message;
  }

  void report(const std::string& failure, double seconds)
  {
    const Seed seed = m_shared->seed;
    const Indices all = whole(seed);
    std::printf("FAILURE after %llu cases and %.1f s: %s\nall %zu parts: %s\n",
                static_cast<unsigned long long>(m_shared->cases), seconds, failure.c_str(),
                all.size(), m_subject.description(seed, {}).c_str());
    std::fflush(stdout);
    const Tally counts = m_shared->tally; // of cases, not of attempts to make one smaller
    const Indices few = shrunk(seed, all);
    const std::string smaller = fails(seed, few);
    m_shared->tally = counts;
    std::string list;
    for (const std::size_t i : few)
      list += (list.empty() ? "" : ",") + std::to_string(i);
    std::printf("%zu parts suffice (%s): %s\nto be repeated by: --case %llu --keep %s\n\n",
                few.size(), smaller.c_str(), m_subject.description(seed, few).c_str(),
                static_cast<unsigned long long>(seed), list.c_str());
    std::fflush(stdout);
  }

  std::string fails(Seed seed, const Indices& parts)
  {
    return in_child(seconds_per_smaller_case, [&] { return check(seed, parts); });
  }

  // Leaves out ever smaller runs of parts for as long as the case fails (Zeller, Hildebrandt 2002).
  Indices shrunk(Seed seed, Indices parts)
  {
    const auto end = Clock::now() + std::chrono::seconds(seconds_to_shrink);
    for (std::size_t run = (parts.size() + 1) / 2; run > 0;) {
      bool is_smaller = false;
      for (std::size_t first = 0; first < parts.size() && Clock::now() < end;) {
        Indices fewer(parts.begin(), parts.begin() + std::ptrdiff_t(first));
        if (first + run < parts.size())
          fewer.insert(fewer.end(), parts.begin() + std::ptrdiff_t(first + run), parts.end());
        if (!fewer.empty() && !fails(seed, fewer).empty()) {
          parts = fewer;
          is_smaller = true;
        } else
          first += run;
      }
      if (Clock::now() >= end || (run == 1 && !is_smaller))
        break;
      run = run == 1 ? 1 : (run + 1) / 2;
    }
    return parts;
  }

  const Subject& m_subject;
  Shared* m_shared;
  Clock::time_point m_end;
  double m_minutes = 1;
  Seed m_first = 1;
  std::size_t m_max_failures = 10;
  bool m_is_one_case = false;
  Indices m_kept;
};

} // namespace fuzz

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_FUZZ_CAMPAIGN_H
