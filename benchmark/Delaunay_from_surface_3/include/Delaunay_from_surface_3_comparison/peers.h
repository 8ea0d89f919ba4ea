// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_PEERS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_PEERS_H

// Other processes: commands, what they print and how much memory they take; the memory that a method
// needs, told by a child process that does nothing else; and programs that build the same triangulation
// in their own way. README.md says what is asked of one.

#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_comparison/points_file.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace comparison {

struct Outcome
{
  int exit_code = 127;        // 128 + the signal that ended it, as in a shell
  std::size_t peak_bytes = 0; // of the largest process of the command
  std::string output;         // what it printed on the standard output
};

// The commands are started by a process that was forked when this object was made, which should be
// early: to a program's peak Linux adds that of the process that became it.
class Launcher
{
public:
  Launcher()
  {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0)
      throw std::runtime_error("cannot make a pair of sockets");
    m_child = fork();
    if (m_child < 0)
      throw std::runtime_error("cannot start a process");
    close(ends[m_child == 0 ? 1 : 0]);
    m_end = ends[m_child == 0 ? 0 : 1];
    if (m_child == 0)
      serve();
  }

  Launcher(const Launcher&) = delete;
  Launcher& operator=(const Launcher&) = delete;

  ~Launcher()
  {
    close(m_end);
    waitpid(m_child, nullptr, 0);
  }

  // `command` is one of the shell.
  Outcome run(const std::string& command)
  {
    send_text(command);
    Outcome outcome;
    if (!receive(&outcome.exit_code, sizeof outcome.exit_code) ||
        !receive(&outcome.peak_bytes, sizeof outcome.peak_bytes) || !receive_text(outcome.output))
      throw std::runtime_error("the process that starts commands has gone");
    return outcome;
  }

private:
  [[noreturn]] void serve()
  {
    for (std::string command; receive_text(command);) {
      const Outcome outcome = run_here(command);
      send(&outcome.exit_code, sizeof outcome.exit_code);
      send(&outcome.peak_bytes, sizeof outcome.peak_bytes);
      send_text(outcome.output);
    }
    _exit(0);
  }

  static Outcome run_here(const std::string& command)
  {
    Outcome outcome;
    int ends[2];
    if (pipe(ends) != 0)
      return outcome;
    const pid_t child = fork();
    if (child == 0)
      become(command, ends);
    close(ends[1]);
    char buffer[4096];
    for (ssize_t n; (n = ::read(ends[0], buffer, sizeof buffer)) > 0;)
      outcome.output.append(buffer, std::size_t(n));
    close(ends[0]);
    int status = 0;
    rusage usage = {};
    if (child > 0 && wait4(child, &status, 0, &usage) == child) {
      outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
      outcome.peak_bytes = std::size_t(usage.ru_maxrss) * 1024;
    }
    return outcome;
  }

  [[noreturn]] static void become(const std::string& command, const int (&ends)[2])
  {
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, STDIN_FILENO);
    dup2(ends[1], STDOUT_FILENO);
    close(ends[0]);
    close(ends[1]);
    execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }

  // --- Messages between the two processes: all bytes, or none when the other end is closed ---------

  void send(const void* data, std::size_t size)
  {
    for (const char* at = static_cast<const char*>(data); size > 0;) {
      const ssize_t sent = ::send(m_end, at, size, MSG_NOSIGNAL);
      if (sent <= 0)
        throw std::runtime_error("the process that starts commands has gone");
      at += sent;
      size -= std::size_t(sent);
    }
  }

  bool receive(void* data, std::size_t size)
  {
    for (char* at = static_cast<char*>(data); size > 0;) {
      const ssize_t received = ::read(m_end, at, size);
      if (received <= 0)
        return false;
      at += received;
      size -= std::size_t(received);
    }
    return true;
  }

  void send_text(const std::string& text)
  {
    const std::size_t size = text.size();
    send(&size, sizeof size);
    send(text.data(), size);
  }

  bool receive_text(std::string& text)
  {
    std::size_t size = 0;
    if (!receive(&size, sizeof size))
      return false;
    text.resize(size);
    return receive(&text[0], size);
  }

  pid_t m_child = -1;
  int m_end = -1;
};

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

struct Peer
{
  std::string name, command;
};

// From NAME=COMMAND.
inline Peer parse_peer(const std::string& text)
{
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string::npos || equals + 1 == text.size())
    throw std::invalid_argument("a peer is given as NAME=COMMAND, not as '" + text + "'");
  return {text.substr(0, equals), text.substr(equals + 1)};
}

// The points of a mesh in a file that lives as long as this.
class Points_file
{
public:
  template <class Points>
  explicit Points_file(const Points& points)
    : m_name((std::filesystem::temp_directory_path() /
              ("delaunay_from_surface_3-" + std::to_string(getpid()) + ".points"))
                 .string())
  {
    write_points_file(points, m_name);
  }
  Points_file(const Points_file&) = delete;
  Points_file& operator=(const Points_file&) = delete;
  ~Points_file()
  {
    std::error_code ignored;
    std::filesystem::remove(m_name, ignored);
  }

  const std::string& name() const { return m_name; }

private:
  std::string m_name;
};

// What comes after `key` on the line that begins with it.
inline std::optional<std::string> value_in_output(const std::string& output, const std::string& key)
{
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word, value;
    if (words >> word && word == key && std::getline(words >> std::ws, value) && !value.empty())
      return value;
  }
  return std::nullopt;
}

// What a peer did on one surface, run by run. A peer that fails once is not asked again.
class Peer_record
{
public:
  explicit Peer_record(Peer peer)
    : m_peer(std::move(peer))
  {
  }

  void run(Launcher& launcher, const std::string& points_file)
  {
    if (!m_failure.empty())
      return;
    const Outcome outcome = launcher.run(m_peer.command + " '" + points_file + "'");
    const auto seconds = value_in_output(outcome.output, "cpu_seconds");
    const auto tetrahedra = value_in_output(outcome.output, "tetrahedra");
    if (outcome.exit_code != 0)
      m_failure = "exit code " + std::to_string(outcome.exit_code);
    else if (!seconds || !tetrahedra)
      m_failure = "it does not print cpu_seconds and tetrahedra";
    if (!m_failure.empty())
      return;
    m_cpu.push_back(std::stod(*seconds));
    if (const auto wall = value_in_output(outcome.output, "wall_seconds"))
      m_wall.push_back(std::stod(*wall));
    m_threads = value_in_output(outcome.output, "threads");
    m_library = value_in_output(outcome.output, "library");
    m_tetrahedra = std::stoul(*tetrahedra);
    m_peak_bytes = std::max(m_peak_bytes, outcome.peak_bytes);
  }

  const std::string& failure() const { return m_failure; }

  // `plain`: its median time, and what it found.
  Json as_json(double plain_cpu, std::size_t plain_tetrahedra) const
  {
    Json result = {{"method", m_peer.name}, {"command", m_peer.command}};
    if (!m_failure.empty()) {
      result["left_out"] = m_failure;
      return result;
    }
    if (m_library)
      result["library"] = *m_library;
    if (m_threads)
      result["threads"] = std::stoul(*m_threads);
    result.update(with_median("cpu", m_cpu));
    if (!m_wall.empty())
      result.update(with_median("wall", m_wall));
    result["ratio_plain_to_method"] = rounded(plain_cpu / double(result["median_cpu"]), 1e4);
    result["tetrahedra"] = m_tetrahedra;
    result["has_as_many_tetrahedra"] = m_tetrahedra == plain_tetrahedra;
    result["memory"] = {{"peak_bytes", m_peak_bytes}};
    return result;
  }

private:
  Peer m_peer;
  std::vector<double> m_cpu, m_wall;
  std::optional<std::string> m_threads, m_library;
  std::size_t m_tetrahedra = 0, m_peak_bytes = 0;
  std::string m_failure;
};

} // namespace comparison

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_PEERS_H
