// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_RANK_FAILURE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_RANK_FAILURE_H

#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Packed_bytes.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_files_error.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_too_large.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_options.h>

#include <cstdint>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// What one process has thrown, so that all others can throw the same: of the same type, if it is
// one that the driver or its callers tell apart, and with the rank before the message, unless all
// have thrown the same.
struct Rank_failure
{
  enum Kind : std::uint32_t { NONE, INPUT, FILES, TOO_LARGE, STOPPED, OTHER };

  Kind kind = NONE;
  std::uint32_t tiles = 0; // that would do, if one was too large
  std::vector<char> text;

  // Calls f().
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

  // rank < 0: it is that of all.
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

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_RANK_FAILURE_H
