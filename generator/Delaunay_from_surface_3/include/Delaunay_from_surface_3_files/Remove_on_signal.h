// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_FILES_REMOVE_ON_SIGNAL_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_FILES_REMOVE_ON_SIGNAL_H

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <string>

namespace files {

// Names of unfinished files, where a signal handler can read them: it may allocate nothing.
struct Files_to_remove
{
  struct Name
  {
    std::atomic<bool> is_taken{false};
    std::array<char, 4096> text; // a longer name stays behind
  };
  std::array<Name, 8> names;
};

inline Files_to_remove& files_to_remove()
{
  static Files_to_remove instance;
  return instance;
}

extern "C" inline void remove_files_and_die(int signal)
{
  for (auto& name : files_to_remove().names)
    if (name.is_taken)
      std::remove(name.text.data()); // where it matters, a call of unlink()
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

// From now on, SIGINT and SIGTERM remove unfinished files before they end the program.
inline void remove_files_on_signal()
{
  files_to_remove(); // made before a handler can need it
  for (const int signal : {SIGINT, SIGTERM})
    if (std::signal(signal, remove_files_and_die) == SIG_IGN)
      std::signal(signal, SIG_IGN); // as nohup and shells' background jobs have it
}

// Is one of these files as long as it lives.
class Remove_on_signal
{
public:
  Remove_on_signal() = default;
  Remove_on_signal(const Remove_on_signal&) = delete;
  Remove_on_signal& operator=(const Remove_on_signal&) = delete;
  ~Remove_on_signal() { forget(); }

  void watch(const std::string& name)
  {
    for (auto& entry : files_to_remove().names)
      if (m_entry == nullptr && !entry.is_taken && name.size() < entry.text.size()) {
        std::copy_n(name.c_str(), name.size() + 1, entry.text.begin());
        entry.is_taken = true;
        m_entry = &entry;
      }
  }
  void forget()
  {
    if (m_entry != nullptr)
      m_entry->is_taken = false;
    m_entry = nullptr;
  }

private:
  Files_to_remove::Name* m_entry = nullptr;
};

} // namespace files

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_FILES_REMOVE_ON_SIGNAL_H
