// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_FUZZ_SUBJECT_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_FUZZ_SUBJECT_H

#include "fuzz_tally.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace fuzz {

using Seed = std::uint64_t;
using Indices = std::vector<std::size_t>;

// What is to be fuzzed. A case is made from its seed, the same at each call, and has parts (points,
// mostly) that can be left out.
class Subject
{
public:
  virtual ~Subject() = default;
  virtual std::size_t number_of_parts(Seed seed) const = 0;
  // Runs the case with these parts. Returns what is wrong; nothing if all is well. May throw.
  virtual std::string check(Seed seed, const Indices& parts, Tally& tally) const = 0;
  virtual std::string description(Seed seed, const Indices& parts) const = 0;
};

inline Indices all_parts(std::size_t n)
{
  Indices parts(n);
  for (std::size_t i = 0; i < n; ++i)
    parts[i] = i;
  return parts;
}

} // namespace fuzz

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_FUZZ_SUBJECT_H
