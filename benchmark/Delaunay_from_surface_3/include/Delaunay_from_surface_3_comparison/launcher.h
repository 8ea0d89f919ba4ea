// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_LAUNCHER_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_LAUNCHER_H

// Runs commands and tells what they printed and how much memory they took.

#include <cerrno>
#include <cstddef>
#include <stdexcept>
#include <string>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

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

} // namespace comparison

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_LAUNCHER_H
