// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_PACKED_BYTES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_PACKED_BYTES_H

// What processes of one machine or of like ones send each other: numbers and arrays of these, one
// after the other, as the machine has them.

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_certificate.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiling.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
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

// The number of the items, and then these.
template <class T>
void pack(Packed_bytes& to, const std::vector<T>& items)
{
  static_assert(std::is_trivially_copyable<T>::value, "items are sent as bytes");
  pack(to, std::uint64_t(items.size()));
  const char* const bytes = reinterpret_cast<const char*>(items.data());
  to.insert(to.end(), bytes, bytes + items.size() * sizeof(T));
}

// Takes out what was packed, in that order. Keeps a reference.
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

// Of cells nothing but the partners with which they are to be compared.
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
    pack(to, c.cells.count(partner) != 0);
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
    if (from.get<bool>())
      c.cells[partner]; // none
  }
  return c;
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_PACKED_BYTES_H
