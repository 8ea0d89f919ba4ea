// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_RANKS_OF_MPI_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_RANKS_OF_MPI_H

// The MPI processes that share tiles. This is the only header that includes MPI's. If mpi.h is not
// found, the rest of it is empty.

#if __has_include(<mpi.h>)

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_options.h>
#include <CGAL/Delaunay_from_surface_3/tiles/pack.h>

#include <mpi.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// The exception of one process, which all others throw as well: with the same type, if the driver
// or its callers distinguish this type, and with the rank before the message, unless all have
// thrown the same.
struct Rank_failure
{
  enum Kind : std::uint32_t { NONE, INPUT, FILES, TOO_LARGE, STOPPED, OTHER };

  Kind kind = NONE;
  std::uint32_t tiles = 0; // the number that would do, if one was too large
  std::vector<char> text;

  auto parts() { return std::tie(kind, tiles, text); }

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

  // Returns the items of all ranks, by rank.
  template <class T>
  std::vector<T> all_gather(const std::vector<T>& mine)
  {
    Packed_bytes packed;
    together([&] {
      for (const T& item : mine)
        pack(packed, item);
    });
    return unpack_all<T>(all_gather(packed));
  }

  // Sends each rank its items, and returns those that this one was sent, by rank.
  template <class T>
  std::vector<T> exchange(std::vector<std::vector<T>> to)
  {
    std::vector<Packed_bytes> packed;
    together([&] {
      packed.resize(to.size());
      for (std::size_t r = 0; r < to.size(); ++r) {
        for (const T& item : to[r])
          pack(packed[r], item);
        std::vector<T>().swap(to[r]);
      }
    });
    return unpack_all<T>(exchange(std::move(packed)));
  }

private:
  // Returns the bytes of each rank, by rank.
  std::vector<Packed_bytes> all_gather(const Packed_bytes& packed)
  {
    const auto mine = std::uint64_t(packed.bytes.size());
    std::vector<std::uint64_t> sizes;
    together([&] { sizes.resize(std::size_t(m_size)); });
    wait_for([&] {
      MPI_Allgather(&mine, 1, MPI_UINT64_T, sizes.data(), 1, MPI_UINT64_T, m_communicator);
    });
    std::vector<int> counts, places; // in units, so that an int can count enough
    std::vector<char> all, padded;
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
      padded = packed.bytes;
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
        result[r].bytes.assign(begin, begin + sizes[r]);
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
      for (const Packed_bytes& packed : to)
        sizes.push_back(packed.bytes.size());
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
          from[r].bytes.resize(std::size_t(sizes_there[r]));
        messages +=
            to[r].bytes.size() / m_bytes_at_once + from[r].bytes.size() / m_bytes_at_once + 2;
      }
      requests.reserve(messages);
    });
    from[std::size_t(m_rank)] = std::move(to[std::size_t(m_rank)]);
    for (int distance = 1; distance < m_size; ++distance) {
      const int sender = (m_rank + m_size - distance) % m_size;
      in_chunks(from[std::size_t(sender)].bytes, [&](char* bytes, int n) {
        requests.emplace_back();
        MPI_Irecv(bytes, n, MPI_BYTE, sender, 0, m_communicator, &requests.back());
      });
    }
    for (int distance = 1; distance < m_size; ++distance) {
      const int receiver = (m_rank + distance) % m_size;
      m_bytes_sent += to[std::size_t(receiver)].bytes.size();
      in_chunks(to[std::size_t(receiver)].bytes, [&](char* bytes, int n) {
        requests.emplace_back();
        MPI_Isend(bytes, n, MPI_BYTE, receiver, 0, m_communicator, &requests.back());
      });
    }
    wait_for([&] { MPI_Waitall(int(requests.size()), requests.data(), MPI_STATUSES_IGNORE); });
    return from;
  }

  template <class T>
  std::vector<T> unpack_all(std::vector<Packed_bytes> packed) const
  {
    std::vector<T> items;
    together([&] {
      for (Packed_bytes& from : packed) {
        while (!from.is_at_end())
          unpack(from, items.emplace_back());
        from = {};
      }
    });
    return items;
  }

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
      Packed_bytes packed;
      if (rank == m_rank)
        pack(packed, mine);
      auto size = std::uint64_t(packed.bytes.size());
      MPI_Bcast(&size, 1, MPI_UINT64_T, rank, m_communicator);
      packed.bytes.resize(std::size_t(size));
      MPI_Bcast(packed.bytes.data(), int(size), MPI_BYTE, rank, m_communicator);
      Rank_failure failure;
      unpack(packed, failure);
      return failure;
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
  void in_chunks(std::vector<char>& bytes, const F& f) const
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
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // __has_include(<mpi.h>)

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_RANKS_OF_MPI_H
