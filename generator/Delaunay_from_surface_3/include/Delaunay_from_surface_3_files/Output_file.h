// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_FILES_OUTPUT_FILE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_FILES_OUTPUT_FILE_H

#include <Delaunay_from_surface_3_files/Remove_on_signal.h>
#include <Delaunay_from_surface_3_files/same_file.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>
#include <system_error>

namespace files {

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
