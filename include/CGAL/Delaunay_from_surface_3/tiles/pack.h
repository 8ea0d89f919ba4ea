// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_PACK_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_PACK_H

// Packs items as bytes, as the machine represents them: for messages to processes on machines of
// one kind, and for the records in a folder of tiles (src/tiles/Records.h).
//
// An item is trivially copyable, or a vector of such items, or a map; or it has a function parts(),
// which ties members that are such items. Packed items go to something that has write(bytes, n).
// They are taken out, in the order in which they were packed, of something that has read(bytes, n)
// and checked(n, size), which returns n, or throws if there cannot be n items of this size.

#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

template <class To, class T>
void pack(To& to, const std::vector<T>& items);
template <class To, class Key, class Value>
void pack(To& to, const std::map<Key, Value>& items);

template <class To, class T>
void pack(To& to, const T& item)
{
  if constexpr (std::is_trivially_copyable<T>::value)
    to.write(&item, sizeof(T));
  else // they are only read
    std::apply([&](const auto&... parts) { (pack(to, parts), ...); }, const_cast<T&>(item).parts());
}

template <class To, class T>
void pack(To& to, const std::vector<T>& items)
{
  static_assert(std::is_trivially_copyable<T>::value, "items are packed as bytes");
  pack(to, std::uint64_t(items.size()));
  to.write(items.data(), items.size() * sizeof(T));
}

template <class To, class Key, class Value>
void pack(To& to, const std::map<Key, Value>& items)
{
  pack(to, std::uint64_t(items.size()));
  for (const auto& [key, value] : items) {
    pack(to, key);
    pack(to, value);
  }
}

template <class From, class T>
void unpack(From& from, std::vector<T>& items);
template <class From, class Key, class Value>
void unpack(From& from, std::map<Key, Value>& items);

template <class From, class T>
void unpack(From& from, T& item)
{
  if constexpr (std::is_trivially_copyable<T>::value)
    from.read(&item, sizeof(T));
  else
    std::apply([&](auto&... parts) { (unpack(from, parts), ...); }, item.parts());
}

// Appends the items.
template <class From, class T>
void unpack(From& from, std::vector<T>& items)
{
  std::uint64_t n = 0;
  unpack(from, n);
  const std::size_t before = items.size();
  items.resize(before + std::size_t(from.checked(n, sizeof(T))));
  from.read(items.data() + before, std::size_t(n) * sizeof(T));
}

template <class From, class Key, class Value>
void unpack(From& from, std::map<Key, Value>& items)
{
  std::uint64_t n = 0;
  unpack(from, n);
  for (n = from.checked(n, 1); n > 0; --n) {
    Key key{};
    unpack(from, key);
    unpack(from, items[key]);
  }
}

// Packed items in memory.
struct Packed_bytes
{
  std::vector<char> bytes;
  std::size_t taken_out = 0;

  void write(const void* from, std::size_t n)
  {
    const char* const begin = static_cast<const char*>(from);
    bytes.insert(bytes.end(), begin, begin + n);
  }

  bool is_at_end() const { return taken_out == bytes.size(); }
  std::uint64_t checked(std::uint64_t n, std::size_t) const { return n; } // it is our own
  void read(void* to, std::size_t n)
  {
    std::copy_n(bytes.data() + taken_out, n, static_cast<char*>(to));
    taken_out += n;
  }
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_PACK_H
