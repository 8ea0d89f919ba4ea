// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_FILES_READ_POLYGON_SOUP_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_FILES_READ_POLYGON_SOUP_H

#include <Delaunay_from_surface_3_files/parse_text.h>
#include <Delaunay_from_surface_3_files/read_ply.h>
#include <Delaunay_from_surface_3_files/read_stl.h>
#include <Delaunay_from_surface_3_files/read_texts.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <system_error>

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

// What is read, by extension.
inline const char* const formats_read = "off, ply, obj, stl, xyz and pts";

inline bool is_format_read(const std::string& format)
{
  return format == "off" || format == "ply" || format == "obj" || format == "stl" ||
         format == "xyz" || format == "pts";
}

// Says how to read what is compressed.
inline void refuse_compressed(const std::string& file_name, const std::string& format)
{
  static constexpr const char* commands[][2] = {
      {"gz", "zcat"}, {"bz2", "bzcat"}, {"xz", "xzcat"}, {"zst", "zstdcat"}};
  const std::string inner = file_extension(std::filesystem::path(file_name).stem().string());
  for (const auto& [extension, command] : commands)
    if (format == extension)
      throw std::runtime_error(file_name + ": is compressed; remedy: " + command + " " + file_name +
                               " | delaunay_from_surface - --from " +
                               (is_format_read(inner) ? inner : "FORMAT"));
}

// All that comes from the standard input.
inline std::string content_of_standard_input()
{
  std::string content(std::istreambuf_iterator<char>(std::cin), {});
  if (content.empty())
    throw std::runtime_error("the standard input is empty");
  return content;
}

// The content of a file. Says which of the many reasons it is, if it cannot be had.
inline std::string content_of(const std::string& file_name)
{
  std::error_code ignored; // what cannot be asked for cannot be opened
  const std::filesystem::file_status status = std::filesystem::status(file_name, ignored);
  if (std::filesystem::is_directory(status))
    throw std::runtime_error(file_name + ": is a directory");
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw std::runtime_error(file_name + ": is not a plain file; remedy: delaunay_from_surface - "
                                         "--from FORMAT < FILE");
  errno = 0;
  std::ifstream file(file_name, std::ios::binary);
  if (!file)
    throw std::runtime_error(file_name + ": " + std::generic_category().message(errno));
  std::string content(std::filesystem::file_size(file_name), '\0');
  if (content.empty())
    throw std::runtime_error(file_name + ": the file is empty");
  if (!file.read(content.data(), std::streamsize(content.size())))
    throw std::runtime_error(file_name + ": cannot be read");
  return content;
}

inline Polygon_soup soup_in(const std::string& content, const std::string& format,
                            bool with_weights)
{
  if (format == "off")
    return Off_reader(content).read();
  if (format == "ply")
    return Ply_reader(content, with_weights).read();
  if (format == "obj")
    return read_obj(content);
  return format == "stl" ? Stl_reader(content).read() : read_points(content, with_weights);
}

inline void check_indices(const Polygon_soup& soup)
{
  for (std::size_t f = 0; f < soup.faces.size(); ++f)
    for (const std::size_t i : soup.faces[f])
      if (i >= soup.points.size())
        throw Bad_content("face " + std::to_string(f) +
                          ": it has a vertex that is not one of the " +
                          std::to_string(soup.points.size()));
}

// Reads the points and faces of a file in the order of the file, or those of the standard input if
// its name is "-". `format` is one of formats_read, or empty: the extension says it. Weights are
// those of .xyz, .pts or .ply. All indices are in range; coordinates and weights may be infinite or
// NaN. The memory that it takes is bounded by the size of the file. Throws `std::runtime_error`
// with one clear line.
inline Polygon_soup read_polygon_soup(const std::string& file_name, std::string format = "",
                                      bool with_weights = false)
{
  if (format.empty())
    format = file_extension(file_name);
  refuse_compressed(file_name, format);
  if (!is_format_read(format))
    throw std::runtime_error(file_name + ": unknown extension; " + formats_read + " are read");
  const std::string content =
      file_name == "-" ? content_of_standard_input() : content_of(file_name);
  try {
    Polygon_soup soup = soup_in(content, format, with_weights);
    if (soup.points.empty())
      throw Bad_content("there are no vertices in it");
    check_indices(soup);
    return soup;
  } catch (const Bad_content& error) {
    throw std::runtime_error(file_name + ": cannot be read as ." + format + ": " + error.what());
  }
}

} // namespace files

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_FILES_READ_POLYGON_SOUP_H
