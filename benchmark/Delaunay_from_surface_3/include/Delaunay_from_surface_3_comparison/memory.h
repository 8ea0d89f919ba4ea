// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_MEMORY_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_MEMORY_H

// The memory that a method needs, told by a child process that does nothing else.

#include <Delaunay_from_surface_3_comparison/measure.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <fstream>
#include <stdexcept>
#include <string>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace comparison {

// Gives what is free back to the system, which else counts as resident.
inline void release_free_memory()
{
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
}

// Bytes of the process that are in memory now; Linux only, 0 elsewhere.
inline std::size_t resident_bytes()
{
  std::size_t all = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return resident * std::size_t(sysconf(_SC_PAGESIZE));
}

// The most there have been.
inline std::size_t peak_bytes(const rusage& usage)
{
  return std::size_t(usage.ru_maxrss) * 1024;
}

// Resident bytes with the input alone, with the result as well, and at the peak.
struct Memory
{
  std::size_t input, result, peak;
};

// build(look) calls look() when the result is there. An exception ends the process, which is not the
// one that has anything to clean up.
template <class Build>
Memory memory_of_build_here(const Build& build) noexcept
{
  Memory memory = {resident_bytes(), 0, 0};
  build([&memory] {
    rusage usage = {};
    getrusage(RUSAGE_SELF, &usage);
    memory.peak = peak_bytes(usage);
    release_free_memory();
    memory.result = resident_bytes();
  });
  return memory;
}

// In a child, whose peak begins with what the parent holds: input and program. The parent must not
// have started threads: a child has but one.
template <class Build>
Memory memory_of_build(const std::string& name, const Build& build)
{
  release_free_memory();
  int ends[2];
  if (pipe(ends) != 0)
    throw std::runtime_error("cannot make a pipe");
  const pid_t child = fork();
  if (child < 0)
    throw std::runtime_error("cannot start a process");
  if (child == 0) {
    const Memory memory = memory_of_build_here(build);
    const bool written = write(ends[1], &memory, sizeof memory) == sizeof memory;
    _exit(written ? 0 : 1);
  }
  close(ends[1]);
  Memory memory = {};
  const bool is_read = read(ends[0], &memory, sizeof memory) == sizeof memory;
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!is_read || status != 0)
    throw std::runtime_error("the process that measures memory has failed: " + name);
  return memory;
}

inline Json memory_as_json(const Memory& memory, double n)
{
  const auto above_input = [&](std::size_t bytes) {
    return rounded((double(bytes) - double(memory.input)) / n, 10);
  };
  return {{"input_bytes", memory.input},
          {"peak_bytes", memory.peak},
          {"result_above_input_per_point", above_input(memory.result)},
          {"peak_above_input_per_point", above_input(memory.peak)}};
}

} // namespace comparison

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_MEMORY_H
