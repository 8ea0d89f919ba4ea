// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_SRC_TILES_TILE_FOLDER_H
#define DELAUNAY_FROM_SURFACE_3_SRC_TILES_TILE_FOLDER_H

// The folder with the state of a run of tiles has files with these names and contents. Ranges of
// the input are numbered like tiles.
//
//   input            the points and options of the run
//   range-K          the summary of range K; then: tiling
//   home-K           its points, by owner; then: homes
//   tile-T-R         the state of tile T after round R, if it took part in this round
//   post-T-R         its messages in this round; then: closed-R, with the place of each message
//   show-R           pairs of tiles that show each other in round R why they differ
//   piece-T, certificate-T    the result and the certificate of tile T; then: certified

#include "Records.h"

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Delaunay_tile.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_certificate.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_options.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiling.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <numeric>
#include <random>
#include <string>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

#if !defined(_WIN32) && __has_include(<sys/file.h>)
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#endif

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// A run has its folder alone. Processes that do tasks one by one share it with each other. A process
// that closes a stage takes a turn alone, others share one; both wait until they may. A killed
// process loses its locks. If the system has no such locks, or the folder is on another machine, no
// process is refused.
class Folder_lock
{
public:
  enum Way { ALONE, SHARED, IN_TURN, SHARED_IN_TURN };

  Folder_lock(const std::filesystem::path& folder, Way way)
  {
#if !defined(_WIN32) && __has_include(<sys/file.h>)
    std::error_code ignored;
    std::filesystem::create_directories(folder, ignored);
    m_file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const int how = (way == ALONE || way == IN_TURN ? LOCK_EX : LOCK_SH) |
                    (way == ALONE || way == SHARED ? LOCK_NB : 0);
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

// The input of a run.
struct Tiles_input
{
  std::uint64_t points, fingerprint, sample_share, points_at_once, most_points_kept, tiles;
};

// The place of a message in the file of its sender, and the number of its points.
struct Posted
{
  std::uint32_t from, to;
  std::uint64_t offset, number;
};

inline bool is_to_an_earlier_tile(const Posted& p, const Posted& q)
{
  return p.to < q.to;
}

struct Closed_round
{
  std::uint64_t told = 0, told_before = 0; // in the rounds before it
  std::uint64_t seed = 0;                  // for certificates, if nothing was told
  std::vector<Posted> posts;               // by receiver, then by sender
  std::vector<std::uint32_t> last_rounds;  // by tile: the round of its last state

  auto parts() { return std::tie(told, told_before, seed, posts, last_rounds); }
};

class Tile_folder
{
public:
  explicit Tile_folder(std::filesystem::path place)
    : m_place(std::move(place))
  {
  }

  const std::filesystem::path& place() const { return m_place; }
  void set_run(std::uint64_t run) { m_run = run; }

  // Returns the place of a file, for example file("tile", t, round).
  template <class... Numbers>
  std::filesystem::path file(std::string name, Numbers... numbers) const
  {
    ((name += "-" + std::to_string(numbers)), ...);
    return m_place / name;
  }

  // Writes such a file with one item, and reads the first item of one.
  template <class T, class... Numbers>
  void write(const T& item, const char* kind, Numbers... numbers) const
  {
    Record_writer to(file(kind, numbers...), kind, m_run);
    to.put(item);
    to.finish();
  }
  template <class T, class... Numbers>
  T read(const char* kind, Numbers... numbers) const
  {
    T item{};
    Record_reader(file(kind, numbers...), kind, m_run).get(item);
    return item;
  }

  void write_mark(const char* name) const { Record_writer(file(name), name, m_run).finish(); }

  Tiles_input read_input()
  {
    Record_reader from(file("input"), "input", 0);
    m_run = from.run();
    Tiles_input input{};
    from.get(input);
    return input;
  }

  // Writes such a file with items by part: of so many parts, part_of(item) is an item's. Each part
  // can be read alone, and has its items in their order.
  template <class T, class Part>
  void write_parts(const std::vector<T>& items, std::size_t parts, const Part& part_of,
                   const char* kind, std::size_t k) const
  {
    std::vector<std::uint32_t> part;
    part.reserve(items.size());
    std::vector<std::uint64_t> ends(parts + 1);
    for (const T& item : items) {
      part.push_back(part_of(item));
      ++ends[part.back() + 1];
    }
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<std::uint64_t> next = ends;
    std::vector<T> sorted(items.size());
    for (std::size_t i = 0; i < items.size(); ++i)
      sorted[std::size_t(next[part[i]]++)] = items[i];
    Record_writer to(file(kind, k), kind, m_run);
    to.put_parts(ends, sorted);
    to.finish();
  }
  template <class T>
  void append_part(const char* kind, std::size_t k, std::uint32_t part, std::vector<T>& items) const
  {
    Record_reader(file(kind, k), kind, m_run).append_part(part, items);
  }

  void write_post(std::uint32_t t, std::size_t round,
                  const std::vector<Tile_message>& messages) const
  {
    std::vector<Posted> posts;
    constexpr std::uint64_t size_of_none = Record_writer::size_of_record<std::uint64_t>;
    std::uint64_t offset =
        Record_writer::size_of_head + size_of_none + sizeof(Posted) * messages.size();
    for (const Tile_message& m : messages) {
      posts.push_back({m.from, m.to, offset, m.points.size()});
      offset += size_of_none + sizeof(Tile_point) * m.points.size();
    }
    Record_writer to(file("post", t, round), "post", m_run);
    to.put(posts);
    for (const Tile_message& m : messages)
      to.put(m.points);
    to.finish();
  }
  void append_message(const Posted& posted, std::size_t round,
                      std::vector<Tile_point>& points) const
  {
    Record_reader(file("post", posted.from, round), "post", m_run).append_at(posted.offset, points);
  }

  void write_piece(const Piece_of_tile& piece) const
  {
    Record_writer to(file("piece", piece.number()), "piece", m_run);
    to.put_each(piece.number_of_vertices(), [&](const auto& put) {
      piece.for_each_vertex([&](const Tile_point& p) { put(p.id); });
    });
    to.put_each(piece.number_of_vertices(), [&](const auto& put) {
      piece.for_each_vertex([&](const Tile_point& p) { put(p.coordinates); });
    });
    to.put(std::uint64_t(piece.number_of_own_vertices()));
    to.put_each(piece.number_of_cells(), [&](const auto& put) { piece.for_each_cell(put); });
    to.put(std::uint64_t(piece.number_of_owned_cells()));
    to.put(std::uint64_t(piece.number_of_owned_finite_cells()));
    to.put(piece.equal_points());
    to.finish();
  }
  Delaunay_3_tile read_piece(std::uint32_t t) const
  {
    Delaunay_3_tile piece;
    std::uint64_t own = 0, owned = 0, finite = 0;
    Record_reader from(file("piece", t), "piece", m_run);
    from.get(piece.ids);
    from.get(piece.points);
    from.get(own);
    from.get(piece.cells);
    from.get(owned);
    from.get(finite);
    from.get(piece.equal_points);
    piece.number = t;
    piece.number_of_own_vertices = std::size_t(own);
    piece.number_of_owned_cells = std::size_t(owned);
    piece.number_of_owned_finite_cells = std::size_t(finite);
    return piece;
  }

private:
  const std::filesystem::path m_place;
  std::uint64_t m_run = 0;
};

// A run knows the files that it writes into its folder (Tiles_to_files.cpp) by their names, and
// touches no others. It never overwrites its input.

// Returns whether a file of this name belongs to one tile, or to all for ParaView.
inline bool is_file_of_tiles(const std::string& name)
{
  if (name == "tiles.pvtu")
    return true;
  const std::size_t dash = name.find('-');
  const std::size_t dot = name.find_first_not_of("0123456789", dash + 1);
  if (dash == std::string::npos || dot == std::string::npos || dot < dash + 6)
    return false;
  const std::string kind = name.substr(0, dash), extension = name.substr(dot);
  if (extension == ".vtu")
    return kind == "tile";
  return extension == ".npy" &&
         (kind == "cells" || kind == "ids" || kind == "points" || kind == "neighbors");
}

// Returns whether a file of this name belongs to one tile or to all, or is the report.
inline bool is_file_of_run(const std::string& name)
{
  return is_file_of_tiles(name) || name == "tiles.json" || name == "tiles.begun";
}

// Returns whether a file of this name would be one of a run, where a system may take capital letters
// and others for the same. For what is refused; what is removed must have exactly such a name.
inline bool may_be_file_of_run(std::string name)
{
  for (char& c : name)
    c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
  return is_file_of_run(name);
}

// Returns the names in a folder, but not below it; the list is empty if there is no folder.
inline std::vector<std::string> names_in(const std::filesystem::path& folder)
{
  std::vector<std::string> names;
  std::error_code error;
  std::filesystem::directory_iterator entry(folder, error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error))
    names.push_back(entry->path().filename().string());
  if (error && error != std::errc::no_such_file_or_directory && error != std::errc::not_a_directory)
    throw Tile_files_error(folder.string() + ": cannot be read: " + error.message());
  std::sort(names.begin(), names.end());
  return names;
}

// Returns whether a file of this name is an incomplete one of a run, which a killed process left.
inline bool is_left_by_run(const std::string& name)
{
  return is_file_of_run(name_when_finished(name));
}

// Returns the files in a folder whose names are such.
template <class Names>
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder, const Names& names)
{
  std::vector<std::filesystem::path> files;
  for (const std::string& name : names_in(folder))
    if (names(name))
      files.push_back(folder / name);
  return files;
}

[[noreturn]] inline void refuse_file_of_others(const std::filesystem::path& file)
{
  throw Tile_files_error(file.string() + ": is of another run: remove all files of its tiles, or "
                                         "name another folder");
}

// Returns the place to which a name leads through links. The place need not exist; a name that the
// system cannot follow is only made absolute.
inline std::filesystem::path place_of(const std::filesystem::path& name)
{
  std::error_code error;
  const std::filesystem::path absolute = std::filesystem::absolute(name);
  const std::filesystem::path place = std::filesystem::weakly_canonical(absolute, error);
  return error ? absolute.lexically_normal() : place;
}

// Returns whether a run in this folder writes a file of this name, or removes it with its state.
inline bool is_of_run(const std::filesystem::path& file, const std::filesystem::path& folder)
{
  const std::filesystem::path parent = place_of(file.parent_path()),
                              state = place_of(folder / "state");
  return (may_be_file_of_run(file.filename().string()) && parent == place_of(folder)) ||
         std::mismatch(state.begin(), state.end(), parent.begin(), parent.end()).first ==
             state.end();
}

// Throws if a run in this folder would write a file that points are read from.
inline void refuse_to_overwrite(const Tile_source_3& source, const std::filesystem::path& folder)
{
  std::error_code error; // a file that is not there is not overwritten
  for (const std::filesystem::path& file : source.files())
    for (const auto& place : {std::filesystem::absolute(file, error), place_of(file)})
      if (is_of_run(place, folder))
        throw Tile_files_error(file.string() +
                               ": would be overwritten: name another folder for the tiles");
}

// Throws if a file that is written beside those of a run in this folder is one of these, or one
// that points are read from.
inline void refuse_output(const Tile_source_3& source, const std::filesystem::path& folder,
                          const std::filesystem::path& output)
{
  std::error_code error;
  for (const std::filesystem::path& file : source.files())
    if (std::filesystem::equivalent(file, output, error))
      throw Tile_files_error(output.string() + ": would overwrite the points of " + file.string() +
                             ": name another file");
  for (const auto& place : {std::filesystem::absolute(output, error), place_of(output)})
    if (is_of_run(place, folder))
      throw Tile_files_error(output.string() +
                             ": would overwrite a file of the run: name another file");
}

// A folder vanishes at once: a process that is killed while it removes the files leaves none in it.

// Renames the folder first; the new name ends like those of incomplete files.
inline void forget_folder(const std::filesystem::path& place)
{
  std::random_device random;
  std::filesystem::path aside = place;
  aside += "-" + std::to_string(random()) + unfinished;
  std::error_code error;
  std::filesystem::rename(place, aside, error);
  if (error && std::filesystem::exists(place))
    fail_to_write(place, error.value());
  std::filesystem::remove_all(aside, error);
}

// Removes the remains that processes left when they were killed while forgetting the folder.
inline void remove_forgotten(const std::filesystem::path& place)
{
  std::error_code ignored; // it may belong to another process, or be gone
  for (const std::string& name : names_in(place.parent_path()))
    if (name_when_finished(name) == place.filename().string())
      std::filesystem::remove_all(place.parent_path() / name, ignored);
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // DELAUNAY_FROM_SURFACE_3_SRC_TILES_TILE_FOLDER_H
