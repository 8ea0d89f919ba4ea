// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random surfaces by recipe. A recipe is a handful of numbers, so a failing one shrinks by making
// them smaller.

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TRIANGLE_LISTS_SURFACE_RECIPE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TRIANGLE_LISTS_SURFACE_RECIPE_H

#include <Delaunay_from_surface_3_triangle_lists/Triangle_list.h>

#include <array>
#include <ostream>
#include <sstream>
#include <random>
#include <string>

namespace triangle_lists {

struct Surface_recipe
{
  enum Field {
    SHAPE,
    SIZE,
    HANDLES,
    CROSS_CAPS,
    INSERTED,
    FLIPS,
    PUNCTURES,
    COPIES,
    ISOLATED,
    SEED,
    FIELDS
  };
  std::array<int, FIELDS> field{};
};

inline std::ostream& operator<<(std::ostream& out, const Surface_recipe& recipe)
{
  static const char* const name[] = {"shape", "size",      "handles", "cross_caps", "inserted",
                                     "flips", "punctures", "copies",  "isolated",   "seed"};
  for (int i = 0; i < Surface_recipe::FIELDS; ++i)
    out << (i ? ", " : "{") << name[i] << " " << recipe.field[i];
  return out << "}";
}

inline Triangle_list base_shape(const Surface_recipe& recipe, std::mt19937& random)
{
  const int size = recipe.field[Surface_recipe::SIZE];
  switch (recipe.field[Surface_recipe::SHAPE]) {
  case 0:
    return tetrahedron();
  case 1:
    return nested_triangles(2 + size);
  case 2:
    return double_wheel(3 + size);
  case 3:
    return polygon_with_chords(3 + size, random);
  case 4:
    return fan(1 + size);
  case 5:
    return grid_torus(3 + size / 4, 3);
  case 6:
    return projective_plane();
  case 7:
    return grid_band(2 + size / 4, 3 + size / 4, true);
  default:
    return grid_band(2 + size / 4, 3 + size / 4, false);
  }
}

inline Triangle_list one_component(const Surface_recipe& recipe, std::mt19937& random)
{
  Triangle_list s = base_shape(recipe, random);
  for (int i = 0; i < recipe.field[Surface_recipe::HANDLES]; ++i)
    s = connected_sum(s, grid_torus(3, 3 + i % 2), random);
  for (int i = 0; i < recipe.field[Surface_recipe::CROSS_CAPS]; ++i)
    s = connected_sum(s, projective_plane(), random);
  insert_vertices(s, recipe.field[Surface_recipe::INSERTED], random);
  flip_edges(s, recipe.field[Surface_recipe::FLIPS], random);
  for (int i = 0; i < recipe.field[Surface_recipe::PUNCTURES]; ++i)
    puncture(s, random);
  return s;
}

inline Triangle_list cook(const Surface_recipe& recipe)
{
  std::mt19937 random(unsigned(recipe.field[Surface_recipe::SEED]));
  Triangle_list s = one_component(recipe, random);
  for (int i = 0; i < recipe.field[Surface_recipe::COPIES]; ++i) {
    Surface_recipe other = recipe;
    const bool is_orientable = recipe.field[Surface_recipe::CROSS_CAPS] == 0 &&
                               recipe.field[Surface_recipe::SHAPE] / 2 != 3;
    int& shape = other.field[Surface_recipe::SHAPE];
    shape = (shape + i + 1) % 9;
    if (is_orientable && (shape == 6 || shape == 7)) // these two are not
      shape = 8;
    other.field[Surface_recipe::HANDLES] /= i + 2;
    s = disjoint_union(s, one_component(other, random));
  }
  s.n += recipe.field[Surface_recipe::ISOLATED];
  shuffle_names(s, random);
  return s;
}

// Draws a recipe; `is_orientable` leaves out everything with a cross-cap.
inline Surface_recipe random_recipe(int seed, bool is_orientable)
{
  std::mt19937 random(unsigned(seed) * 2654435761u + 1u);
  const auto up_to = [&](int most) { return std::uniform_int_distribution<int>(0, most)(random); };
  Surface_recipe recipe;
  recipe.field = {up_to(8), up_to(20), 0, 0, up_to(60), 0, 0, 0, 0, seed};
  if (is_orientable && (recipe.field[0] == 6 || recipe.field[0] == 7))
    recipe.field[0] = 8;
  recipe.field[Surface_recipe::HANDLES] = up_to(2) == 0 ? up_to(10) : up_to(1);
  recipe.field[Surface_recipe::CROSS_CAPS] = is_orientable || up_to(1) == 0 ? 0 : up_to(4);
  recipe.field[Surface_recipe::FLIPS] = up_to(1) * up_to(300);
  recipe.field[Surface_recipe::PUNCTURES] = up_to(1) * up_to(5);
  recipe.field[Surface_recipe::COPIES] = up_to(2) == 0 ? up_to(3) : 0;
  recipe.field[Surface_recipe::ISOLATED] = up_to(4) == 0 ? up_to(2) : 0;
  return recipe;
}

// A property returns what is wrong, or nothing. The failing recipe is made smaller while it still
// fails.
template <class Property>
std::string check_and_shrink(Surface_recipe recipe, const Property& property)
{
  std::string complaint = property(recipe);
  if (complaint.empty())
    return complaint;
  for (bool has_shrunk = true; has_shrunk;) {
    has_shrunk = false;
    for (int i = 0; i < Surface_recipe::SEED && !has_shrunk; ++i)
      for (int smaller : {0, recipe.field[i] / 2, recipe.field[i] - 1}) {
        Surface_recipe candidate = recipe;
        candidate.field[i] = smaller;
        if (smaller < 0 || smaller >= recipe.field[i])
          continue;
        const std::string still = property(candidate);
        if (still.empty())
          continue;
        recipe = candidate;
        complaint = still;
        has_shrunk = true;
        break;
      }
  }
  std::ostringstream out;
  out << complaint << " on " << recipe;
  return out.str();
}

} // namespace triangle_lists

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TRIANGLE_LISTS_SURFACE_RECIPE_H
