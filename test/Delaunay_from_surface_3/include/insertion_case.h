// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_INSERTION_CASE_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_INSERTION_CASE_H

// One call of the package with all that may surround it, made from a seed.

#include "fuzz_subject.h"
#include "hostile_points.h"
#include "rounding_modes.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace fuzz {

using Faces = std::vector<Indices>;

constexpr std::size_t never = std::size_t(-1);

struct Insertion_case
{
  const Category* category = &categories[0];
  Points points;       // inserted by the package
  Points old_points;   // in the triangulation before
  Points later_points; // inserted after, and what is near to them removed
  Faces faces;         // of indices of points; one of two is an edge
  const char* faces_name = "";
  const Rounding_mode* rounding = &rounding_modes[0]; // of the caller
  std::size_t stops_at = never;                       // the visitor stops before this insertion
  bool stops_by_exception = false;
  unsigned int seed = 0; // of the insertion
  std::uint64_t way = 0; // which traits and triangulation
};

// --- surfaces, right and wrong -------------------------------------------------------------------

inline Faces random_triangles(Random& r, std::size_t n)
{
  Faces faces(r.below(2 * n) + 1);
  for (Indices& face : faces) // corners may be the same
    face = {r.below(n), r.below(n), r.below(n)};
  return faces;
}

inline Faces random_polygons(Random& r, std::size_t n)
{
  Faces faces(r.below(n) + 1);
  for (Indices& face : faces)
    for (std::size_t k = r.below(7); k > 0; --k)
      face.push_back(r.below(n));
  return faces;
}

inline Faces random_tree(Random& r, std::size_t n)
{
  Faces faces;
  for (std::size_t i = 1; i < n; ++i)
    faces.push_back({r.below(i), i});
  return faces;
}

inline Faces star(Random& r, std::size_t n)
{
  const std::size_t hub = r.one_in(2) ? 0 : r.below(n);
  Faces faces;
  for (std::size_t i = 0; i + 1 < n; ++i)
    faces.push_back({hub, i, i + 1});
  return faces;
}

inline Faces strip(Random&, std::size_t n)
{
  Faces faces;
  for (std::size_t i = 0; i + 2 < n; ++i)
    faces.push_back({i, i + 1 + i % 2, i + 2 - i % 2});
  return faces;
}

inline Faces grid(Random& r, std::size_t n)
{
  const std::size_t width = 1 + r.below(15);
  Faces faces;
  for (std::size_t i = 0; i + width + 1 < n; ++i)
    if ((i + 1) % width != 0) {
      faces.push_back({i, i + 1, i + width});
      faces.push_back({i + 1, i + width + 1, i + width});
    }
  return faces;
}

inline Faces no_faces(Random&, std::size_t)
{
  return {};
}

struct Surface_kind
{
  const char* name;
  Faces (*make)(Random& random, std::size_t n);
};

inline const Surface_kind surface_kinds[] = {{"random triangles", random_triangles},
                                             {"random polygons", random_polygons},
                                             {"random tree", random_tree},
                                             {"star", star},
                                             {"strip", strip},
                                             {"grid", grid},
                                             {"no faces", no_faces}};

// --- the case ------------------------------------------------------------------------------------

inline std::size_t random_size(Random& r)
{
  return 1 + (r.one_in(2) ? r.below(16) : r.one_in(2) ? r.below(60) : r.below(200));
}

// All of it; its parts are the points, the old ones, and the later ones.
inline Insertion_case whole_case(Seed seed)
{
  Random r(seed);
  Insertion_case c;
  c.category = &categories[r.below(number_of_categories)];
  c.points = hostile_points(*c.category, r, random_size(r));
  if (r.one_in(8))
    c.old_points = hostile_points(r.one_in(2) ? *c.category : categories[0], r, 1 + r.below(30));
  if (r.one_in(4))
    c.later_points = hostile_points(r.one_in(2) ? *c.category : categories[0], r, 1 + r.below(10));
  const Surface_kind& kind = surface_kinds[r.below(std::size(surface_kinds))];
  c.faces = kind.make(r, c.points.size());
  c.faces_name = kind.name;
  c.rounding = &rounding_modes[r.one_in(2) ? 0 : r.below(std::size(rounding_modes))];
  c.stops_at = r.one_in(8) ? r.below(c.points.size()) : never;
  c.stops_by_exception = r.one_in(2);
  c.seed = unsigned(r.below(100));
  c.way = r.bits();
  return c;
}

inline std::size_t number_of_parts(const Insertion_case& c)
{
  return c.points.size() + c.old_points.size() + c.later_points.size();
}

// `first` is the index of the first of the points among the parts. Returns the new index of each.
inline Indices keep(Points& points, std::size_t first, const std::vector<bool>& is_kept)
{
  Indices renumbered(points.size(), never);
  std::size_t n = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (is_kept[first + i]) {
      points[n] = points[i];
      renumbered[i] = n++;
    }
  points.resize(n);
  return renumbered;
}

// Faces of points that are left out go too.
inline Insertion_case make_case(Seed seed, const Indices& parts)
{
  Insertion_case c = whole_case(seed);
  std::vector<bool> is_kept(number_of_parts(c), false);
  for (const std::size_t i : parts)
    is_kept.at(i) = true;
  const std::size_t n = c.points.size(), n_old = c.old_points.size();
  keep(c.later_points, n + n_old, is_kept);
  keep(c.old_points, n, is_kept);
  const Indices renumbered = keep(c.points, 0, is_kept);
  Faces faces;
  for (Indices face : c.faces) {
    bool is_whole = true;
    for (std::size_t& i : face) {
      i = renumbered[i];
      is_whole = is_whole && i != never;
    }
    if (is_whole)
      faces.push_back(face);
  }
  c.faces = faces;
  return c;
}

// --- in words ------------------------------------------------------------------------------------

// As C++ code, without rounding.
inline std::string to_string(const Points& points)
{
  std::string text;
  char line[120];
  for (const Coordinates& p : points) {
    std::snprintf(line, sizeof(line), "\n  {%a, %a, %a},", p[0], p[1], p[2]);
    text += line;
  }
  return text;
}

inline std::string to_string(const Insertion_case& c)
{
  std::string text = std::string("category: ") + c.category->name + "; surface: " + c.faces_name +
                     "; rounding: " + c.rounding->name +
                     "; seed of the insertion: " + std::to_string(c.seed);
  if (c.stops_at != never)
    text += std::string("; stopped by ") + (c.stops_by_exception ? "exception" : "the visitor") +
            " before insertion " + std::to_string(c.stops_at);
  text += "\npoints:" + to_string(c.points);
  if (!c.old_points.empty())
    text += "\nold points:" + to_string(c.old_points);
  if (!c.later_points.empty())
    text += "\nlater points:" + to_string(c.later_points);
  text += "\nfaces:";
  for (const Indices& face : c.faces) {
    text += " {";
    for (const std::size_t i : face)
      text += " " + std::to_string(i);
    text += " }";
  }
  return text;
}

} // namespace fuzz

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_INSERTION_CASE_H
