// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_FILES_FILE_EXTENSION_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_FILES_FILE_EXTENSION_H

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

namespace files {

// "off" for "a/b.OFF"; empty if there is none.
inline std::string file_extension(const std::string& file_name)
{
  std::string extension = std::filesystem::path(file_name).extension().string();
  extension.erase(0, 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return extension;
}

} // namespace files

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_FILES_FILE_EXTENSION_H
