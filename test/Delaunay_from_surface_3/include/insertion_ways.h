// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_INSERTION_WAYS_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_INSERTION_WAYS_H

// Traits, triangulations and arrays that a case may be run with, in units of their own: they take
// minutes to compile.

#include "fuzz_tally.h"
#include "insertion_case.h"

#include <string>
#include <vector>

namespace fuzz {

struct Insertion_way
{
  const char* name;
  std::string (*check)(const Insertion_case& c, Tally& tally);
};

std::vector<Insertion_way> ways_by_traits();
std::vector<Insertion_way> ways_by_triangulation();
std::vector<Insertion_way> ways_into_arrays();

} // namespace fuzz

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_INSERTION_WAYS_H
