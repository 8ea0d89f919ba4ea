// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_SRC_TILES_RECORDS_H
#define DELAUNAY_FROM_SURFACE_3_SRC_TILES_RECORDS_H

// Files of records, which appear only when they are complete: they are written beside their place
// and renamed, so a remainder of a killed process or a crashed machine is never taken for a whole
// file.
//
// Each file begins with a text that gives its kind and version, and the number of the run. Numbers
// are stored as the machine represents them.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_options.h>
#include <CGAL/Delaunay_from_surface_3/tiles/pack.h>

#include <algorithm>
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
#include <utility>
#include <vector>

#if !defined(_WIN32) && __has_include(<unistd.h>)
#include <fcntl.h>
#include <unistd.h>
#endif

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The end of the name of an incomplete file.
constexpr const char* unfinished = ".unfinished";

// Returns the future name of an incomplete file, which is its name without a number and
// `unfinished` at the end; the result is empty for other files.
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
    if (std::filesystem::is_directory(m_place, ignored)) // else renaming would fail later
      fail_to_write(m_place, EISDIR);
    const auto there = std::filesystem::status(m_place, ignored);
    if (std::filesystem::exists(there) && !std::filesystem::is_regular_file(there))
      throw Tile_files_error(m_place.string() + ": cannot be written: it is no regular file");
    if (std::filesystem::exists(there)) // a link stays, and its target is replaced
      m_place = std::filesystem::canonical(m_place);
    errno = 0;
    if (std::filesystem::exists(there)) {
      std::FILE* const file = std::fopen(m_place.string().c_str(), "ab"); // is it write-protected?
      if (file == nullptr)
        fail_to_write(m_place, errno);
      std::fclose(file);
    }
    std::random_device random;
    m_unfinished = m_place.string() + "-" + std::to_string(random()) + unfinished;
    errno = 0;
    m_file.reset(std::fopen(m_unfinished.string().c_str(), "wbx")); // no file of others
    if (!m_file)
      fail_to_write(m_place, errno);
    if (std::filesystem::exists(there))
      std::filesystem::permissions(m_unfinished, there.permissions(), ignored);
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

  // Returns the name that the file has until it is complete.
  const std::filesystem::path& unfinished_place() const { return m_unfinished; }

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
    keep_name();
  }

private:
  // Syncs the file before it is renamed: else the name might survive a crash, but not the contents.
  bool is_on_disk() const
  {
#if !defined(_WIN32) && __has_include(<unistd.h>)
    return ::fsync(::fileno(m_file.get())) == 0 || errno == EINVAL; // it is on no disk
#else
    return true;
#endif
  }

  // Syncs the folder, without which the name is not on the disk.
  void keep_name() const
  {
#if !defined(_WIN32) && __has_include(<unistd.h>)
    const std::filesystem::path folder = std::filesystem::absolute(m_place).parent_path();
    const int file = ::open(folder.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0)
      return; // the folder may be writable, but not readable
    const bool is_kept = ::fsync(file) == 0 || errno == EINVAL || errno == EROFS;
    const int error = errno;
    ::close(file);
    if (!is_kept)
      fail_to_write(m_place, error);
#endif
  }

  struct Close
  {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  std::filesystem::path m_place;
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

  // Returns the size of the file, or 0 if it cannot be found out.
  std::uint64_t size() const
  {
    std::error_code ignored;
    const std::uintmax_t size = std::filesystem::file_size(m_place, ignored);
    return size == std::uintmax_t(-1) ? 0 : size;
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

// The beginning of each file of a run.
struct Record_head
{
  char what[32] = {}; // for example "dfs3 tiles 5 tiling"
  std::uint64_t run;

  Record_head(const char* kind, std::uint64_t run_number)
    : run(run_number)
  {
    std::snprintf(what, sizeof(what), "dfs3 tiles 5 %s", kind);
  }
};

// A hash of bytes. Each word enters it by an invertible function, so no change of one word is
// missed.
class Checksum
{
public:
  void add(const void* bytes, std::size_t n)
  {
    const char* from = static_cast<const char*>(bytes);
    m_size += n;
    while (n > 0) {
      const std::size_t some = (std::min)(n, sizeof(m_word) - m_filled);
      std::memcpy(reinterpret_cast<char*>(&m_word) + m_filled, from, some);
      m_filled += some;
      from += some;
      n -= some;
      if (m_filled == sizeof(m_word))
        take();
    }
  }

  // Returns the hash of all bytes so far, and starts a new one.
  std::uint64_t finish()
  {
    if (m_filled > 0)
      take();
    m_word = m_size;
    take();
    m_size = 0;
    return std::exchange(m_hash, 0);
  }

private:
  void take()
  {
    m_hash = (m_hash ^ m_word) * 0x9e3779b97f4a7c15;
    m_hash ^= m_hash >> 32;
    m_word = 0;
    m_filled = 0;
  }

  std::uint64_t m_hash = 0, m_word = 0, m_size = 0;
  std::size_t m_filled = 0;
};

// Writes records, each a packed item (pack.h). Its checksum follows, so it can be read alone.
class Record_writer
{
public:
  Record_writer(const std::filesystem::path& place, const char* kind, std::uint64_t run)
    : m_bytes(place)
  {
    put(Record_head(kind, run));
  }

  template <class T>
  void put(const T& item)
  {
    pack(*this, item);
    end();
  }

  // Writes a vector of n items, which give(put) passes to put() one after the other.
  template <class Give>
  void put_each(std::uint64_t n, const Give& give)
  {
    pack(*this, n);
    give([&](const auto& item) { pack(*this, item); });
    end();
  }

  // Writes items that are sorted by part: part t has those from ends[t] to before ends[t + 1]. Each
  // part can be read alone.
  template <class T>
  void put_parts(const std::vector<std::uint64_t>& ends, const std::vector<T>& items)
  {
    std::uint64_t place = size_of_head + (ends.size() - 1) * size_of_record<std::uint64_t>;
    for (std::size_t t = 0; t + 1 < ends.size(); ++t) {
      put(place);
      place += size_of_record<std::uint64_t> + (ends[t + 1] - ends[t]) * sizeof(T);
    }
    for (std::size_t t = 0; t + 1 < ends.size(); ++t)
      put_each(ends[t + 1] - ends[t], [&](const auto&) {
        write(items.data() + ends[t], std::size_t(ends[t + 1] - ends[t]) * sizeof(T));
      });
  }

  // For pack().
  void write(const void* bytes, std::size_t n)
  {
    m_checksum.add(bytes, n);
    m_bytes.write(bytes, n);
  }

  void finish() { m_bytes.finish(); }

  // Sizes in the file.
  template <class T>
  static constexpr std::uint64_t size_of_record = sizeof(T) + sizeof(std::uint64_t);
  static constexpr std::uint64_t size_of_head = size_of_record<Record_head>;

private:
  void end()
  {
    const std::uint64_t sum = m_checksum.finish();
    m_bytes.write(&sum, sizeof(sum));
  }

  Bytes_writer m_bytes;
  Checksum m_checksum;
};

class Record_reader
{
public:
  // If `run` is 0, any run will do.
  Record_reader(const std::filesystem::path& place, const char* kind, std::uint64_t run)
    : m_bytes(place)
    , m_left(m_bytes.size())
  {
    Record_head head("", 0);
    const Record_head expected(kind, run);
    read(&head, sizeof(head));
    if (std::memcmp(head.what, expected.what, sizeof(head.what)) != 0)
      throw Tile_files_error(place.string() + ": not a file of this version of the program");
    check();
    if (run != 0 && head.run != run)
      throw Tile_files_error(place.string() + ": belongs to another run");
    m_run = head.run;
  }

  std::uint64_t run() const { return m_run; }

  // Takes out a record; of a vector the items are appended.
  template <class T>
  void get(T& item)
  {
    unpack(*this, item);
    check();
  }

  // Appends the vector at a place of the file to `items`.
  template <class T>
  void append_at(std::uint64_t offset, std::vector<T>& items)
  {
    seek(offset);
    get(items);
  }

  // Appends the items of a part to `items`.
  template <class T>
  void append_part(std::uint64_t part, std::vector<T>& items)
  {
    seek(Record_writer::size_of_head + part * Record_writer::size_of_record<std::uint64_t>);
    std::uint64_t place = 0;
    get(place);
    append_at(place, items);
  }

  // For unpack(), which allocates no memory for more items than the file can have.
  void read(void* bytes, std::size_t n)
  {
    if (n > m_left)
      throw Tile_files_error(m_bytes.place().string() + ": ends early");
    m_bytes.read(bytes, n);
    m_left -= n;
    m_checksum.add(bytes, n);
  }
  std::uint64_t checked(std::uint64_t n, std::size_t size) const
  {
    if (n > m_left / size)
      fail();
    return n;
  }

private:
  void seek(std::uint64_t offset)
  {
    const std::uint64_t size = m_bytes.size();
    m_left = size - (std::min)(offset, size);
    m_bytes.seek(offset);
  }

  void check()
  {
    const std::uint64_t expected = m_checksum.finish();
    std::uint64_t sum = 0;
    read(&sum, sizeof(sum));
    m_checksum.finish();
    if (sum != expected)
      fail();
  }

  [[noreturn]] void fail() const
  {
    throw Tile_files_error(m_bytes.place().string() +
                           ": is damaged, as its checksum tells: remove the folder of the tiles, "
                           "and begin again");
  }

  Bytes_reader m_bytes;
  std::uint64_t m_run = 0, m_left;
  Checksum m_checksum;
};

inline bool machine_is_little_endian()
{
  const std::uint16_t one = 1;
  char first;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

[[noreturn]] inline void refuse_file(const std::filesystem::path& file, const std::string& why)
{
  throw Tile_files_error(file.string() + ": " + why);
}

inline std::uint64_t size_of_file(const std::filesystem::path& file)
{
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error)
    refuse_file(file, "cannot be read: " + error.message());
  return size;
}

// The head of a .npy: the text of a Python dictionary, and the place of the first number.
struct Npy_head
{
  std::string text;
  std::uint64_t end;
};

inline Npy_head read_head_of_npy(Bytes_reader& from)
{
  const std::filesystem::path& file = from.place();
  unsigned char start[12] = {};
  from.read(start, 10);
  if (std::memcmp(start, "\x93NUMPY", 6) != 0 || start[6] < 1 || start[6] > 3)
    refuse_file(file, "no file of NumPy's");
  std::size_t length = start[8] + 256u * start[9], first = 10;
  if (start[6] > 1) {
    from.read(start + 10, 2);
    length += (std::size_t(start[10]) << 16) + (std::size_t(start[11]) << 24);
    first = 12;
  }
  if (length > (1u << 20))
    refuse_file(file, "its head has no end");
  std::string text(length, ' ');
  from.read(text.data(), length);
  return {std::move(text), first + length};
}

// Returns the value of a key in that dictionary.
inline std::string value_of_key(const std::string& head, const std::string& key,
                                const std::string& end)
{
  const std::size_t at = head.find("'" + key + "'");
  const std::size_t colon = at == std::string::npos ? at : head.find(':', at);
  if (colon == std::string::npos)
    return "";
  const std::size_t last = head.find_first_of(end, head.find_first_not_of(" ('", colon + 1));
  std::string value = head.substr(colon + 1, last - colon - 1);
  value.erase(std::remove_if(value.begin(), value.end(),
                             [](char c) { return c == ' ' || c == '\'' || c == '('; }),
              value.end());
  return value;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // DELAUNAY_FROM_SURFACE_3_SRC_TILES_RECORDS_H
