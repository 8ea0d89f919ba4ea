// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_HOSTILE_POINTS_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_HOSTILE_POINTS_H

// The categories of points that the fuzzers draw from.

#include "hostile_numbers.h"
#include "hostile_shapes.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace fuzz {

struct Category
{
  const char* name;
  Points (*make)(Random& random, std::size_t n);
};

Points mixed(Random& random, std::size_t n);

inline const Category categories[] = {
    {"cube", cube},
    {"sphere", sphere},
    {"lattice", lattice},
    {"denormals", denormals},
    {"tiny", tiny},
    {"huge", huge},
    {"near the largest double", near_the_largest_double},
    {"factors of all sizes", factors_of_all_sizes},
    {"points of all sizes", points_of_all_sizes},
    {"two sizes far apart", two_sizes_far_apart},
    {"sizes within a filters reach", sizes_within_a_filters_reach},
    {"flat along axes", flat_along_axes},
    {"flat and turned", flat_and_turned},
    {"some far away", some_far_away},
    {"tenths", tenths},
    {"tenths far away", tenths_far_away},
    {"long integers", long_integers},
    {"other steps on each axis", other_steps_on_each_axis},
    {"nudged by ulps", nudged_by_ulps},
    {"cospherical 85 bits", cospherical_85_bits},
    {"integer sphere", integer_sphere},
    {"sphere with noise", sphere_with_noise},
    {"flat", flat},
    {"tilted plane", tilted_plane},
    {"planes of all sizes", planes_of_all_sizes},
    {"plane and one point", plane_and_one_point},
    {"plane and denormal heights", plane_and_denormal_heights},
    {"circles", circles},
    {"collinear", collinear},
    {"nearly collinear", nearly_collinear},
    {"line and few points", line_and_few_points},
    {"duplicates", duplicates},
    {"all equal", all_equal},
    {"all equal but one", all_equal_but_one},
    {"zeros of both signs", zeros_of_both_signs},
    {"one to five", one_to_five},
    {"mirrored parts", mirrored_parts},
    {"cluster far away", cluster_far_away},
    {"clusters", clusters},
    {"hub and ring", hub_and_ring},
    {"sphere and its centre", sphere_and_its_centre},
    {"moment curve", moment_curve},
    {"two skew lines", two_skew_lines},
    {"parts of two categories", mixed},
};

constexpr std::size_t number_of_categories = std::size(categories);

// All but the last.
inline Points mixed(Random& r, std::size_t n)
{
  Points points = categories[r.below(number_of_categories - 1)].make(r, (n + 1) / 2);
  const Points more = categories[r.below(number_of_categories - 1)].make(r, (n + 1) / 2);
  points.insert(points.end(), more.begin(), more.end());
  return points;
}

// Of a category, in any order, and with the axes in any order.
inline Points hostile_points(const Category& category, Random& r, std::size_t n)
{
  Points points = category.make(r, n);
  const std::size_t turn = r.below(3);
  for (Coordinates& p : points)
    std::rotate(p.begin(), p.begin() + turn, p.end());
  r.shuffle(points);
  return points;
}

} // namespace fuzz

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_HOSTILE_POINTS_H
