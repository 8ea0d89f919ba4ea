// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_FILES_OUTPUT_FILE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_FILES_OUTPUT_FILE_H

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>
#include <system_error>

namespace files {

// The file that a name means, by way of all links, also if there is no such file yet: a link may
// lead to nothing.
inline std::filesystem::path place_of(const std::string& name, std::error_code& error)
{
  namespace fs = std::filesystem;
  const bool is_there = fs::exists(name, error);
  if (error)
    return name;
  if (is_there)
    return fs::canonical(name, error);
  fs::path place = fs::absolute(name, error);
  constexpr int most_links = 40; // more would have been an error
  for (int k = 0; k < most_links && !error && fs::is_symlink(fs::symlink_status(place, error)); ++k)
    place = place.parent_path() / fs::read_symlink(place, error); // which may be absolute
  return fs::weakly_canonical(place, error);
}

// Do two names mean the same file, there or not? If that cannot be found out, they do not.
inline bool are_same_file(const std::string& a, const std::string& b)
{
  std::error_code error, other_error;
  if (std::filesystem::equivalent(a, b, error)) // hard links, too
    return true;
  const std::filesystem::path place = place_of(a, error);
  return place == place_of(b, other_error) && !error && !other_error;
}

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

// From now on, signals that end a program on request remove unfinished files before they do.
inline void remove_files_on_signal()
{
  files_to_remove(); // made before a handler can need it
  for (const int signal : {
           SIGINT, SIGTERM,
#ifdef SIGHUP
           SIGHUP, // of a terminal that is closed
#endif
       })
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

// A file that appears, or replaces an older one, only when it is complete. The constructor finds
// out whether it can be written, so that nobody waits for a result that has nowhere to go. Until
// then it is written beside its place, under a name that no other file has.
class Output_file
{
public:
  explicit Output_file(const std::string& name)
    : m_name(name)
  {
    std::error_code error;           // what cannot be asked for cannot be written
    m_place = place_of(name, error); // a link stays, its file is replaced
    const bool is_there = !error && std::filesystem::exists(m_place, error);
    if (error)
      fail(error.value());
    if (is_there) {
      if (!std::filesystem::is_regular_file(m_place, error))
        throw std::runtime_error(name + ": cannot be written: it exists and is not a plain file");
      errno = 0;
      if (!std::ofstream(m_place, std::ios::app))
        fail(errno);
    }
    create_unfinished();
    if (is_there)
      std::filesystem::permissions(m_unfinished, std::filesystem::status(m_place).permissions(),
                                   error);
    m_stream.open(m_unfinished, std::ios::binary);
    if (!m_stream)
      remove_and_fail(errno);
  }

  Output_file(const Output_file&) = delete;
  Output_file& operator=(const Output_file&) = delete;

  ~Output_file()
  {
    if (!m_is_finished)
      remove();
  }

  std::ostream& stream() { return m_stream; }

  // Says that all is written. If several files belong together, each is closed before any is finished.
  void close()
  {
    if (!m_stream.is_open())
      return;
    errno = 0;
    m_stream.close();
    if (!m_stream)
      fail(errno);
  }

  void finish()
  {
    close();
    std::error_code error;
    std::filesystem::rename(m_unfinished, m_place, error);
    if (error)
      fail(error.value());
    m_is_finished = true;
    m_remove_on_signal.forget();
  }

private:
  // An empty file with a name that no other has, and the permissions that the user gives to new
  // files.
  void create_unfinished()
  {
    static const char letters[] = "abcdefghijklmnopqrstuvwxyz0123456789";
    std::random_device random;
    std::FILE* file = nullptr;
    for (int tries = 0; file == nullptr && tries < 100; ++tries) {
      std::string name = ".unfinished-";
      for (int k = 0; k < 8; ++k)
        name += letters[random() % (sizeof(letters) - 1)];
      m_unfinished = m_place.parent_path() / name;
      m_remove_on_signal.watch(m_unfinished.string());
      errno = 0;
      file = std::fopen(m_unfinished.string().c_str(), "wbx"); // not if it exists
      if (file == nullptr)
        m_remove_on_signal.forget();
      if (file == nullptr && errno != EEXIST)
        break;
    }
    if (file == nullptr)
      fail(errno);
    std::fclose(file);
  }

  void remove()
  {
    m_stream.close();
    std::error_code ignored;
    std::filesystem::remove(m_unfinished, ignored);
  }

  [[noreturn]] void remove_and_fail(int error)
  {
    remove();
    fail(error);
  }

  [[noreturn]] void fail(int error) const
  {
    throw std::runtime_error(m_name + ": cannot be written: " +
                             (error != 0 ? std::generic_category().message(error) : "disk full?"));
  }

  std::string m_name;
  std::filesystem::path m_place, m_unfinished;
  std::ofstream m_stream;
  bool m_is_finished = false;
  Remove_on_signal m_remove_on_signal;
};

} // namespace files

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_FILES_OUTPUT_FILE_H
