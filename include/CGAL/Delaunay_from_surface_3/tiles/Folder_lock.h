// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_FOLDER_LOCK_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_FOLDER_LOCK_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_files_error.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#if !defined(_WIN32) && __has_include(<sys/file.h>)
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#endif

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// A run has its folder alone; who does tasks one by one shares it with others that do, or takes
// turns with them, and waits for its own. What a process has locked nobody has when it is killed.
// Where the system has no such locks, or the folder is on another machine, nobody is refused.
class Folder_lock
{
public:
  enum Way { ALONE, SHARED, IN_TURN };

  Folder_lock(const std::filesystem::path& folder, Way way)
  {
#if !defined(_WIN32) && __has_include(<sys/file.h>)
    std::error_code ignored;
    std::filesystem::create_directories(folder, ignored);
    m_file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const int how = way == IN_TURN ? LOCK_EX : (way == ALONE ? LOCK_EX : LOCK_SH) | LOCK_NB;
    int failed = -1;
    while (m_file >= 0 && (failed = ::flock(m_file, how)) != 0 && errno == EINTR) {
    }
    if (m_file >= 0 && failed != 0 && errno == EWOULDBLOCK) {
      ::close(m_file);
      throw Tile_files_error(folder.string() + ": another run is at work there");
    }
#else
    (void)folder;
    (void)way;
#endif
  }
  Folder_lock(const Folder_lock&) = delete;
  Folder_lock& operator=(const Folder_lock&) = delete;
  ~Folder_lock()
  {
#if !defined(_WIN32) && __has_include(<sys/file.h>)
    if (m_file >= 0) {
      ::flock(m_file, LOCK_UN); // a child of this process may have the file, too
      ::close(m_file);
    }
#endif
  }

private:
  int m_file = -1;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_FOLDER_LOCK_H
