// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_FUZZ_TALLY_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_FUZZ_TALLY_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace fuzz {

// Counts by name. It has no pointers: a child process counts in memory that its parent sees too.
class Tally
{
public:
  void count(const std::string& name, std::uint64_t by = 1)
  {
    std::size_t i = 0;
    while (i < m_size && name != m_entries[i].name)
      ++i;
    if (i == m_size)
      add(name);
    m_entries[i].count += by;
  }

  void print() const
  {
    std::vector<const Entry*> sorted;
    for (std::size_t i = 0; i < m_size; ++i)
      sorted.push_back(&m_entries[i]);
    std::sort(sorted.begin(), sorted.end(),
              [](const Entry* a, const Entry* b) { return std::strcmp(a->name, b->name) < 0; });
    for (const Entry* entry : sorted)
      std::printf("%12llu  %s\n", static_cast<unsigned long long>(entry->count), entry->name);
  }

private:
  struct Entry
  {
    char name[80];
    std::uint64_t count;
  };

  void add(const std::string& name)
  {
    if (m_size == max_size || name.size() >= sizeof(Entry::name))
      throw std::length_error("Tally: " + name);
    std::strcpy(m_entries[m_size].name, name.c_str());
    m_entries[m_size++].count = 0;
  }

  static constexpr std::size_t max_size = 400;
  std::size_t m_size = 0;
  Entry m_entries[max_size];
};

} // namespace fuzz

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_FUZZ_TALLY_H
