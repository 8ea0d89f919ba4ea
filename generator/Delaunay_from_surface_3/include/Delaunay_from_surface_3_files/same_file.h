// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_FILES_SAME_FILE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_FILES_SAME_FILE_H

#include <filesystem>
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

} // namespace files

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_FILES_SAME_FILE_H
