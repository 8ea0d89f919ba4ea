// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_OUTPUT_FILE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_OUTPUT_FILE_H

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>

// A file that appears, or replaces an older one, only when it is complete. The constructor finds
// out whether it can be written, so that nobody waits for a result that has nowhere to go.
class Output_file
{
public:
  explicit Output_file(const std::string& name)
    : m_name(name)
    , m_unfinished(name + ".part")
  {
    if (std::filesystem::exists(name) && !std::filesystem::is_regular_file(name))
      throw std::runtime_error(name + ": cannot be written: it exists and is not a plain file");
    errno = 0;
    if (std::filesystem::exists(name) && !std::ofstream(name, std::ios::app))
      fail(errno);
    m_stream.open(m_unfinished, std::ios::binary);
    if (!m_stream)
      fail(errno);
  }

  Output_file(const Output_file&) = delete;
  Output_file& operator=(const Output_file&) = delete;

  ~Output_file()
  {
    if (m_is_finished)
      return;
    m_stream.close();
    std::error_code ignored;
    std::filesystem::remove(m_unfinished, ignored);
  }

  std::ostream& stream() { return m_stream; }

  void finish()
  {
    errno = 0;
    m_stream.close();
    if (!m_stream)
      fail(errno);
    std::filesystem::rename(m_unfinished, m_name);
    m_is_finished = true;
  }

private:
  [[noreturn]] void fail(int error) const
  {
    throw std::runtime_error(m_name + ": cannot be written: " +
                             (error != 0 ? std::generic_category().message(error) : "disk full?"));
  }

  std::string m_name, m_unfinished;
  std::ofstream m_stream;
  bool m_is_finished = false;
};

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_OUTPUT_FILE_H
