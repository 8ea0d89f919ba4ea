// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Arrays in place of a triangulation, in every dimension.

#include "check_insertion.h"
#include "insertion_ways.h"
#include "mistake_in_arrays.h"

#include <CGAL/delaunay_3_arrays.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace fuzz {
namespace {

using Array_points = std::vector<tests::arrays::Point>;

template <class Index, class Tag>
struct Along_faces
{
  template <class NamedParameters>
  static CGAL::Delaunay_3_arrays<Index> make(const Array_points& points, const Faces& faces,
                                             const NamedParameters& np)
  {
    return CGAL::delaunay_3_arrays<Index, Tag>(points, faces, np);
  }
};

template <class Index, class Tag>
struct Of_points
{
  template <class NamedParameters>
  static CGAL::Delaunay_3_arrays<Index> make(const Array_points& points, const Faces&,
                                             const NamedParameters& np)
  {
    return CGAL::delaunay_3_arrays<Index, Tag>(points, np);
  }
};

// The old points and the later ones have no part in it.
template <class Form>
std::string check_arrays(const Insertion_case& c, Tally& tally)
{
  const auto points = points_of<tests::arrays::Triangulation>(c.points);
  Hostile_visitor visitor(c);
  decltype(Form::make(points, c.faces, CGAL::parameters::random_seed(c.seed))) arrays;
  {
    const Rounding rounding(*c.rounding);
    visitor.rounding = &rounding;
    try {
      arrays = Form::make(points, c.faces,
                          CGAL::parameters::random_seed(c.seed).visitor(std::ref(visitor)));
    } catch (const Stop&) {
    }
    if (!rounding.is_kept())
      return "the caller's rounding mode was not restored";
    visitor.rounding = nullptr;
  }
  if (!visitor.keeps_rounding)
    return "the visitor was called in another rounding mode";
  if (visitor.has_stopped) {
    tally.count("stopped");
    return arrays.number_of_cells() == 0 && arrays.dimension() == -1 ? "" : "after a stop: cells";
  }
  tally.count("arrays: dimension " + std::to_string(arrays.dimension()));
  if (c.seed % 2 != 0)
    arrays.separate();
  return tests::arrays::mistake_in_arrays(arrays, points);
}

} // namespace

std::vector<Insertion_way> ways_into_arrays()
{
  using Alone = CGAL::Sequential_tag;
  return {
      {"arrays along faces", check_arrays<Along_faces<std::int32_t, Alone>>},
      {"arrays of points", check_arrays<Of_points<std::int32_t, Alone>>},
#ifdef CGAL_LINKED_WITH_TBB
      {"arrays along faces, Parallel_tag",
       check_arrays<Along_faces<std::int32_t, CGAL::Parallel_tag>>},
      {"arrays of points, Parallel_tag", check_arrays<Of_points<std::int32_t, CGAL::Parallel_tag>>},
#endif
  };
}

} // namespace fuzz
