// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_RECORDS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_RECORDS_H

// Files of records, which appear only when they are complete: they are written beside their place
// and renamed, so what a killed process or a crash of the machine leaves is never taken for a whole.
//
// Each begins with a word that says what it is and of which version, and the number of the run.
// Numbers are those of the machine.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_files_error.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <ios>
#include <memory>
#include <random>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

#if !defined(_WIN32) && __has_include(<unistd.h>)
#include <unistd.h>
#endif

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The end of the name of what is not complete.
constexpr const char* unfinished = ".unfinished";

// What a file that is not complete will be called: its name without a number and `unfinished` at the
// end; empty if it is none.
inline std::string name_when_finished(const std::string& name)
{
  const std::string end = unfinished;
  if (name.size() <= end.size() || name.compare(name.size() - end.size(), end.size(), end) != 0)
    return "";
  const std::size_t dash = name.find_last_not_of("0123456789", name.size() - end.size() - 1);
  if (dash == std::string::npos || name[dash] != '-' || dash + 1 == name.size() - end.size())
    return "";
  return name.substr(0, dash);
}

[[noreturn]] inline void fail_to_write(const std::filesystem::path& place, int error)
{
  throw Tile_files_error(place.string() + ": cannot be written: " +
                         (error != 0 ? std::generic_category().message(error) : "disk full?"));
}

class Bytes_writer
{
public:
  explicit Bytes_writer(std::filesystem::path place)
    : m_place(std::move(place))
  {
    std::error_code ignored;
    if (std::filesystem::is_directory(m_place, ignored)) // or renaming fails, when all is written
      fail_to_write(m_place, EISDIR);
    const auto there = std::filesystem::status(m_place, ignored);
    if (std::filesystem::exists(there) && !std::filesystem::is_regular_file(there))
      throw Tile_files_error(m_place.string() + ": cannot be written: it is no regular file");
    std::random_device random;
    m_unfinished = m_place.string() + "-" + std::to_string(random()) + unfinished;
    errno = 0;
    m_file.reset(std::fopen(m_unfinished.string().c_str(), "wb"));
    if (!m_file)
      fail_to_write(m_place, errno);
  }
  Bytes_writer(const Bytes_writer&) = delete;
  Bytes_writer& operator=(const Bytes_writer&) = delete;
  ~Bytes_writer()
  {
    m_file.reset();
    if (!m_is_finished) {
      std::error_code ignored;
      std::filesystem::remove(m_unfinished, ignored);
    }
  }

  void write(const void* bytes, std::size_t n)
  {
    errno = 0;
    if (n > 0 && std::fwrite(bytes, 1, n, m_file.get()) != n)
      fail_to_write(m_place, errno);
  }

  void finish()
  {
    errno = 0;
    if (std::fflush(m_file.get()) != 0 || !is_on_disk() || std::fclose(m_file.release()) != 0)
      fail_to_write(m_place, errno);
    std::error_code error;
    std::filesystem::rename(m_unfinished, m_place, error);
    if (error)
      fail_to_write(m_place, error.value());
    m_is_finished = true;
  }

private:
  // Before it is renamed: else the name may outlive a crash of the machine, and not what it names.
  bool is_on_disk() const
  {
#if !defined(_WIN32) && __has_include(<unistd.h>)
    return ::fsync(::fileno(m_file.get())) == 0 || errno == EINVAL; // of what is no disk
#else
    return true;
#endif
  }

  struct Close
  {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  const std::filesystem::path m_place;
  std::filesystem::path m_unfinished;
  std::unique_ptr<std::FILE, Close> m_file;
  bool m_is_finished = false;
};

class Bytes_reader
{
public:
  explicit Bytes_reader(std::filesystem::path place)
    : m_place(std::move(place))
  {
    errno = 0;
    m_stream.open(m_place, std::ios::binary);
    if (!m_stream)
      throw Tile_files_error(m_place.string() + ": cannot be read: " +
                             std::generic_category().message(errno != 0 ? errno : ENOENT));
  }

  void seek(std::uint64_t offset) { m_stream.seekg(std::streamoff(offset)); }
  void read(void* bytes, std::size_t n)
  {
    m_stream.read(static_cast<char*>(bytes), std::streamsize(n));
    if (std::size_t(m_stream.gcount()) != n)
      throw Tile_files_error(m_place.string() + ": ends early");
  }

  const std::filesystem::path& place() const { return m_place; }

private:
  const std::filesystem::path m_place;
  std::ifstream m_stream;
};

// What stands at the beginning of each file of a run.
struct Record_head
{
  char what[32] = {}; // "dfs3 tiles 2 tiling"
  std::uint64_t run;

  Record_head(const char* kind, std::uint64_t run_number)
    : run(run_number)
  {
    std::snprintf(what, sizeof(what), "dfs3 tiles 2 %s", kind);
  }
};

class Record_writer
{
public:
  Record_writer(const std::filesystem::path& place, const char* kind, std::uint64_t run)
    : m_bytes(place)
  {
    put(Record_head(kind, run));
  }

  template <class T>
  void put(const T& record)
  {
    static_assert(std::is_trivially_copyable<T>::value, "records are written as bytes");
    m_bytes.write(&record, sizeof(T));
  }

  // The number of the items, and then these.
  template <class T>
  void put(const std::vector<T>& items)
  {
    static_assert(std::is_trivially_copyable<T>::value, "records are written as bytes");
    put(std::uint64_t(items.size()));
    m_bytes.write(items.data(), items.size() * sizeof(T));
  }

  // So many items, which give(put) gives to put() one after the other.
  template <class Give>
  void put_each(std::uint64_t n, const Give& give)
  {
    put(n);
    give([&](const auto& item) { put(item); });
  }
  void finish() { m_bytes.finish(); }

private:
  Bytes_writer m_bytes;
};

class Record_reader
{
public:
  // The run: 0 if any will do.
  Record_reader(const std::filesystem::path& place, const char* kind, std::uint64_t run)
    : m_bytes(place)
  {
    Record_head head("", 0);
    const Record_head expected(kind, run);
    get(head);
    if (std::memcmp(head.what, expected.what, sizeof(head.what)) != 0)
      throw Tile_files_error(place.string() + ": not a file of this version of the program");
    if (run != 0 && head.run != run)
      throw Tile_files_error(place.string() + ": belongs to another run");
    m_run = head.run;
  }

  std::uint64_t run() const { return m_run; }

  template <class T>
  void get(T& record)
  {
    static_assert(std::is_trivially_copyable<T>::value, "records are read as bytes");
    m_bytes.read(&record, sizeof(T));
  }
  template <class T>
  T get()
  {
    T record{};
    get(record);
    return record;
  }
  template <class T>
  void get(std::vector<T>& items)
  {
    items.resize(std::size_t(get<std::uint64_t>()));
    m_bytes.read(items.data(), items.size() * sizeof(T));
  }

  // Items that are at a place of the file, behind what is in `items`.
  template <class T>
  void append_at(std::uint64_t offset, std::uint64_t n, std::vector<T>& items)
  {
    const std::size_t before = items.size();
    items.resize(before + std::size_t(n));
    m_bytes.seek(offset);
    m_bytes.read(items.data() + before, std::size_t(n) * sizeof(T));
  }

private:
  Bytes_reader m_bytes;
  std::uint64_t m_run = 0;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_RECORDS_H
