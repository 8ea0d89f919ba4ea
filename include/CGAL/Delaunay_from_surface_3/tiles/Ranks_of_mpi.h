// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_RANKS_OF_MPI_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_RANKS_OF_MPI_H

// The MPI processes that share tiles, and the packing of what they send each other: numbers and
// arrays of numbers, one after the other, as the machine represents them; so all machines are of
// one kind.

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_certificate.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_options.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiling.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

using Packed_bytes = std::vector<char>;

template <class T>
void pack(Packed_bytes& to, const T& item)
{
  static_assert(std::is_trivially_copyable<T>::value, "items are sent as bytes");
  const char* const bytes = reinterpret_cast<const char*>(&item);
  to.insert(to.end(), bytes, bytes + sizeof(T));
}

// Packs the number of the items, and then the items.
template <class T>
void pack(Packed_bytes& to, const std::vector<T>& items)
{
  static_assert(std::is_trivially_copyable<T>::value, "items are sent as bytes");
  pack(to, std::uint64_t(items.size()));
  const char* const bytes = reinterpret_cast<const char*>(items.data());
  to.insert(to.end(), bytes, bytes + items.size() * sizeof(T));
}

// Takes items out in the order in which they were packed. Keeps a reference.
class Unpack
{
public:
  explicit Unpack(const Packed_bytes& from)
    : m_from(from)
  {
  }

  bool is_at_end() const { return m_at == m_from.size(); }

  template <class T>
  void get(T& item)
  {
    copy(&item, sizeof(T));
  }
  template <class T>
  void get(std::vector<T>& items)
  {
    items.resize(std::size_t(get<std::uint64_t>()));
    copy(items.data(), items.size() * sizeof(T));
  }
  template <class T>
  T get()
  {
    T item{};
    get(item);
    return item;
  }

private:
  void copy(void* to, std::size_t n)
  {
    if (n > 0)
      std::memcpy(to, m_from.data() + m_at, n);
    m_at += n;
  }

  const Packed_bytes& m_from;
  std::size_t m_at = 0;
};

inline void pack(Packed_bytes& to, const Tile_message& message)
{
  pack(to, message.from);
  pack(to, message.to);
  pack(to, message.points);
}
inline Tile_message unpack_message(Unpack& from)
{
  Tile_message message{from.get<std::uint32_t>(), from.get<std::uint32_t>(), {}};
  from.get(message.points);
  return message;
}

inline void pack(Packed_bytes& to, const Range_summary& summary)
{
  pack(to, summary.largest);
  pack(to, summary.least);
  pack(to, summary.basis);
  pack(to, summary.sample);
}
inline Range_summary unpack_summary(Unpack& from)
{
  Range_summary summary;
  from.get(summary.largest);
  from.get(summary.least);
  from.get(summary.basis);
  from.get(summary.sample);
  return summary;
}

inline void pack(Packed_bytes& to, const Tile_certificate& c)
{
  pack(to, c.tile);
  for (const std::uint64_t n :
       {c.hull_vertices, c.hull_facets, c.own_points, c.points_kept, c.owned_cells, c.hash})
    pack(to, n);
  pack(to, std::uint64_t(c.common.size()));
  for (const auto& [partner, sum] : c.common) {
    pack(to, partner);
    pack(to, sum);
  }
}
inline Tile_certificate unpack_certificate(Unpack& from)
{
  Tile_certificate c;
  from.get(c.tile);
  for (std::uint64_t* n :
       {&c.hull_vertices, &c.hull_facets, &c.own_points, &c.points_kept, &c.owned_cells, &c.hash})
    from.get(*n);
  for (auto partners = from.get<std::uint64_t>(); partners > 0; --partners) {
    const auto partner = from.get<std::uint32_t>();
    from.get(c.common[partner]);
  }
  return c;
}

// The exception of one process, which all others throw as well: with the same type, if the driver
// or its callers distinguish this type, and with the rank before the message, unless all have
// thrown the same.
struct Rank_failure
{
  enum Kind : std::uint32_t { NONE, INPUT, FILES, TOO_LARGE, STOPPED, OTHER };

  Kind kind = NONE;
  std::uint32_t tiles = 0; // the number that would do, if one was too large
  std::vector<char> text;

  // Calls f(), and returns what it throws.
  template <class F>
  static Rank_failure of(const F& f) noexcept
  {
    try {
      f();
      return {};
    } catch (const Surface_input_error& error) {
      return of(INPUT, error);
    } catch (const Tile_files_error& error) {
      return of(FILES, error);
    } catch (const Tile_too_large& error) {
      Rank_failure failure = of(TOO_LARGE, error);
      failure.tiles = error.number_of_tiles();
      return failure;
    } catch (const Tiles_stopped& error) {
      return of(STOPPED, error);
    } catch (const std::bad_alloc&) {
      return of(OTHER, std::runtime_error("there is not enough memory"));
    } catch (const std::exception& error) {
      return of(OTHER, error);
    } catch (...) {
      return of(OTHER, std::runtime_error("something was thrown that is no exception"));
    }
  }

  bool is_same_as(const Rank_failure& other) const
  {
    return kind == other.kind && tiles == other.tiles && text == other.text;
  }

  // A negative rank stands for all ranks.
  [[noreturn]] void rethrow(int rank) const
  {
    const std::string what = (rank < 0 ? "" : "rank " + std::to_string(rank) + ": ") +
                             std::string(text.begin(), text.end());
    switch (kind) {
    case INPUT:
      throw Surface_input_error(what);
    case FILES:
      throw Tile_files_error(what);
    case TOO_LARGE:
      throw Tile_too_large(what, tiles);
    case STOPPED:
      throw Tiles_stopped();
    default:
      throw std::runtime_error(what);
    }
  }

private:
  static Rank_failure of(Kind kind, const std::exception& error)
  {
    const std::string what = error.what();
    return {kind, 0, std::vector<char>(what.begin(), what.end())};
  }
};

inline void pack(Packed_bytes& to, const Rank_failure& failure)
{
  pack(to, failure.kind);
  pack(to, failure.tiles);
  pack(to, failure.text);
}
inline Rank_failure unpack_failure(Unpack& from)
{
  Rank_failure failure;
  from.get(failure.kind);
  from.get(failure.tiles);
  from.get(failure.text);
  return failure;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

// This is the only header that includes MPI's. If mpi.h is not found, the rest of it is empty.

#if __has_include(<mpi.h>)

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <mpi.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <new>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The processes of a communicator, and what they do together: each calls the same functions in the
// same order, from one thread. An exception of one process alone is thrown inside together(), and
// thus by all, so that the others do not wait for it for ever.
class Ranks_of_mpi
{
public:
  // Duplicates the communicator, so that messages of others are not taken for its own. At most so
  // many bytes are sent at once, because MPI counts with an int.
  explicit Ranks_of_mpi(MPI_Comm communicator, std::size_t bytes_at_once = std::size_t(1) << 29)
    : m_bytes_at_once(bytes_at_once)
  {
    MPI_Comm_dup(communicator, &m_communicator);
    MPI_Comm_set_errhandler(m_communicator, MPI_ERRORS_ARE_FATAL);
    MPI_Comm_rank(m_communicator, &m_rank);
    MPI_Comm_size(m_communicator, &m_size);
  }
  Ranks_of_mpi(const Ranks_of_mpi&) = delete;
  Ranks_of_mpi& operator=(const Ranks_of_mpi&) = delete;
  ~Ranks_of_mpi()
  {
    int is_over = 0;
    MPI_Finalized(&is_over);
    if (is_over == 0)
      MPI_Comm_free(&m_communicator);
  }

  int rank() const { return m_rank; }
  int size() const { return m_size; }
  std::uint64_t bytes_sent() const { return m_bytes_sent; } // data from this rank to others
  double seconds() const { return m_seconds; } // for sending and for waiting for others

  // Returns an empty buffer for each rank.
  std::vector<Packed_bytes> empty_by_rank() const
  {
    return std::vector<Packed_bytes>(static_cast<std::size_t>(m_size));
  }

  // Calls f(), in which each rank works by itself. If it throws on some ranks, all ranks throw what
  // it threw on the first of these. Memory is allocated only inside such calls.
  template <class F>
  void together(const F& f) const
  {
    const Rank_failure mine = Rank_failure::of(f);
    const Stopwatch watch(m_seconds);
    const int first = least(mine.kind == Rank_failure::NONE ? m_size : m_rank);
    if (first == m_size)
      return;
    const Rank_failure theirs = of_rank(first, mine);
    const bool is_of_all = least(theirs.is_same_as(mine) ? 1 : 0) == 1;
    theirs.rethrow(is_of_all ? -1 : first);
  }

  std::uint64_t sum(std::uint64_t number) const
  {
    const Stopwatch watch(m_seconds);
    MPI_Allreduce(MPI_IN_PLACE, &number, 1, MPI_UINT64_T, MPI_SUM, m_communicator);
    return number;
  }

  // Returns the number that the first rank has.
  std::uint64_t of_first(std::uint64_t number) const
  {
    const Stopwatch watch(m_seconds);
    MPI_Bcast(&number, 1, MPI_UINT64_T, 0, m_communicator);
    return number;
  }

  // Returns the bytes of each rank, by rank.
  std::vector<Packed_bytes> all_gather(const Packed_bytes& bytes)
  {
    const auto mine = std::uint64_t(bytes.size());
    std::vector<std::uint64_t> sizes;
    together([&] { sizes.resize(std::size_t(m_size)); });
    wait_for([&] {
      MPI_Allgather(&mine, 1, MPI_UINT64_T, sizes.data(), 1, MPI_UINT64_T, m_communicator);
    });
    std::vector<int> counts, places; // in units, so that an int can count enough
    Packed_bytes all, padded;
    std::vector<Packed_bytes> result;
    together([&] {
      result.resize(sizes.size());
      std::uint64_t end = 0;
      for (const std::uint64_t size : sizes) {
        counts.push_back(int((size + unit - 1) / unit));
        places.push_back(int(end));
        end += std::uint64_t(counts.back());
      }
      if (end > std::uint64_t((std::numeric_limits<int>::max)()))
        throw std::runtime_error("too much for MPI to gather");
      all.resize(std::size_t(end) * unit);
      padded = bytes;
      padded.resize(std::size_t(counts[std::size_t(m_rank)]) * unit);
    });
    MPI_Datatype type = MPI_DATATYPE_NULL;
    MPI_Type_contiguous(int(unit), MPI_BYTE, &type);
    MPI_Type_commit(&type);
    wait_for([&] {
      MPI_Allgatherv(padded.data(), counts[std::size_t(m_rank)], type, all.data(), counts.data(),
                     places.data(), type, m_communicator);
    });
    MPI_Type_free(&type);
    m_bytes_sent += m_size > 1 ? mine : 0;
    together([&] {
      for (std::size_t r = 0; r < sizes.size(); ++r) {
        const char* const begin = all.data() + std::size_t(places[r]) * unit;
        result[r].assign(begin, begin + sizes[r]);
      }
    });
    return result;
  }

  // Sends each rank its bytes, and returns those that each rank sent to this one, by rank. Memory
  // is allocated before anything is sent.
  std::vector<Packed_bytes> exchange(std::vector<Packed_bytes> to)
  {
    std::vector<std::uint64_t> sizes, sizes_there;
    std::vector<Packed_bytes> from;
    together([&] {
      for (const Packed_bytes& bytes : to)
        sizes.push_back(bytes.size());
      sizes_there.resize(to.size());
      from.resize(to.size());
    });
    wait_for([&] {
      MPI_Alltoall(sizes.data(), 1, MPI_UINT64_T, sizes_there.data(), 1, MPI_UINT64_T,
                   m_communicator);
    });
    std::vector<MPI_Request> requests;
    together([&] {
      std::size_t messages = 0;
      for (std::size_t r = 0; r < to.size(); ++r) {
        if (int(r) != m_rank)
          from[r].resize(std::size_t(sizes_there[r]));
        messages += to[r].size() / m_bytes_at_once + from[r].size() / m_bytes_at_once + 2;
      }
      requests.reserve(messages);
    });
    from[std::size_t(m_rank)] = std::move(to[std::size_t(m_rank)]);
    for (int distance = 1; distance < m_size; ++distance) {
      const int sender = (m_rank + m_size - distance) % m_size;
      in_chunks(from[std::size_t(sender)], [&](char* bytes, int n) {
        requests.emplace_back();
        MPI_Irecv(bytes, n, MPI_BYTE, sender, 0, m_communicator, &requests.back());
      });
    }
    for (int distance = 1; distance < m_size; ++distance) {
      const int receiver = (m_rank + distance) % m_size;
      m_bytes_sent += to[std::size_t(receiver)].size();
      in_chunks(to[std::size_t(receiver)], [&](char* bytes, int n) {
        requests.emplace_back();
        MPI_Isend(bytes, n, MPI_BYTE, receiver, 0, m_communicator, &requests.back());
      });
    }
    wait_for([&] { MPI_Waitall(int(requests.size()), requests.data(), MPI_STATUSES_IGNORE); });
    return from;
  }

private:
  static constexpr std::size_t unit = 64; // bytes

  struct Stopwatch
  {
    double& seconds;
    const double begin = MPI_Wtime();

    explicit Stopwatch(double& s)
      : seconds(s)
    {
    }
    ~Stopwatch() { seconds += MPI_Wtime() - begin; }
  };

  int least(int number) const
  {
    MPI_Allreduce(MPI_IN_PLACE, &number, 1, MPI_INT, MPI_MIN, m_communicator);
    return number;
  }

  // Returns the failure of a rank. If memory is lacking even for this, all processes are aborted,
  // because the others wait.
  Rank_failure of_rank(int rank, const Rank_failure& mine) const
  {
    try {
      Packed_bytes bytes;
      if (rank == m_rank)
        pack(bytes, mine);
      auto size = std::uint64_t(bytes.size());
      MPI_Bcast(&size, 1, MPI_UINT64_T, rank, m_communicator);
      bytes.resize(std::size_t(size));
      MPI_Bcast(bytes.data(), int(size), MPI_BYTE, rank, m_communicator);
      Unpack from(bytes);
      return unpack_failure(from);
    } catch (const std::bad_alloc&) {
      MPI_Abort(m_communicator, EXIT_FAILURE);
      throw;
    }
  }

  template <class F>
  void wait_for(const F& f) const
  {
    const Stopwatch watch(m_seconds);
    f();
  }

  template <class F>
  void in_chunks(Packed_bytes& bytes, const F& f) const
  {
    for (std::size_t at = 0; at < bytes.size(); at += m_bytes_at_once)
      f(bytes.data() + at, int((std::min)(m_bytes_at_once, bytes.size() - at)));
  }

  const std::size_t m_bytes_at_once;
  MPI_Comm m_communicator = MPI_COMM_NULL;
  int m_rank = 0, m_size = 1;
  std::uint64_t m_bytes_sent = 0;
  mutable double m_seconds = 0;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // __has_include(<mpi.h>)

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_RANKS_OF_MPI_H
