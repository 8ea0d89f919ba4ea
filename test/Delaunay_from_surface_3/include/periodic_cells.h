// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_PERIODIC_CELLS_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_PERIODIC_CELLS_H

// What is wrong with a periodic triangulation as arrays, next to that of many copies by CGAL with exact
// numbers, or to CGAL's periodic ones.

#include <CGAL/Delaunay_from_surface_3/Periodic_3_arrays.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace tests {
namespace periodic {

using Arrays = CGAL::Periodic_3_arrays<std::int32_t>;
using Coordinates = std::array<double, 3>;
using Points = std::vector<Coordinates>;
using Weights = std::vector<double>; // empty if there are none
using Box = std::array<double, 3>;
using Exact = CGAL::Epeck;

// A point, and by how many periods it is moved.
using Corner = std::array<int, 4>;
using Simplex = std::vector<Corner>;

// Of all copies the one whose first corner is not moved.
inline Simplex canonical(Simplex s)
{
  std::sort(s.begin(), s.end());
  const Corner first = s[0];
  for (Corner& c : s)
    for (std::size_t a = 1; a < 4; ++a)
      c[a] -= first[a];
  return s;
}

struct Outcome
{
  std::set<Simplex> cells;
  std::set<int> visible; // of equal points the first
};

// Points as they are in the box, exactly. Of equal ones, also of copies, the first is kept.
class Wrapped_points
{
public:
  using Number = Exact::FT;
  struct Wrapped
  {
    std::array<Number, 3> at;
    double weight;
    Corner corner; // moved to there
  };

  Wrapped_points(const Points& points, const Weights& weights, const Box& box)
  {
    std::map<std::pair<std::array<Number, 3>, double>, int> first;
    for (std::size_t i = 0; i < points.size(); ++i) {
      Wrapped w = {{}, weights.empty() ? 0 : weights[i] + 0., {int(i), 0, 0, 0}};
      for (std::size_t a = 0; a < 3; ++a) {
        const double x = points[i][a];
        w.at[a] = x;
        if (!std::isfinite(box[a]))
          continue;
        const double inside = std::fmod(x, box[a]);
        w.at[a] = inside < 0 ? Number(inside) + Number(box[a]) : Number(inside);
        w.corner[a + 1] = int(std::round((inside - x) / box[a])) + (inside < 0);
      }
      const auto entry = first.insert({{w.at, w.weight}, int(i)});
      m_first.push_back(entry.first->second);
      if (entry.second)
        m_points.push_back(w);
    }
  }
  const std::vector<Wrapped>& points() const { return m_points; }
  int first_of_equal(std::size_t i) const { return m_first[i]; }

private:
  std::vector<Wrapped> m_points;
  std::vector<int> m_first;
};

struct Copy_info
{
  Corner corner;
  bool is_at_home;
};

template <class Triangulation>
Outcome outcome_at_home(const Triangulation& tr)
{
  Outcome outcome;
  if (tr.dimension() < 3)
    return outcome;
  for (auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
    if (v->info().is_at_home)
      outcome.visible.insert(v->info().corner[0]);
  for (auto c = tr.finite_cells_begin(); c != tr.finite_cells_end(); ++c) {
    Simplex corners;
    bool has_home = false;
    for (int k = 0; k < 4; ++k) {
      corners.push_back(c->vertex(k)->info().corner);
      has_home = has_home || c->vertex(k)->info().is_at_home;
    }
    if (has_home)
      outcome.cells.insert(canonical(corners));
  }
  return outcome;
}

// By CGAL, of all copies that may have a say.
inline Outcome by_many_copies(const Points& points, const Weights& weights, const Box& box)
{
  using Info = Copy_info;
  using Vb = CGAL::Triangulation_vertex_base_with_info_3<Info, Exact>;
  using Delaunay = CGAL::Delaunay_triangulation_3<
      Exact,
      CGAL::Triangulation_data_structure_3<Vb, CGAL::Delaunay_triangulation_cell_base_3<Exact>>>;
  using Rvb =
      CGAL::Triangulation_vertex_base_with_info_3<Info, Exact,
                                                  CGAL::Regular_triangulation_vertex_base_3<Exact>>;
  using Regular = CGAL::Regular_triangulation_3<
      Exact,
      CGAL::Triangulation_data_structure_3<Rvb, CGAL::Regular_triangulation_cell_base_3<Exact>>>;
  double diagonal = 0;
  for (const double L : box)
    diagonal = std::isfinite(L) ? std::hypot(diagonal, L) : diagonal;
  Corner most = {0, 0, 0, 0};
  for (std::size_t a = 0; a < 3; ++a)
    if (std::isfinite(box[a]))
      most[a + 1] = int(std::ceil(diagonal / box[a] + 1e-9));
  std::vector<std::pair<Exact::Point_3, Info>> copies;
  std::vector<std::pair<Exact::Weighted_point_3, Info>> weighted;
  const Wrapped_points wrapped(points, weights, box);
  for (const auto& w : wrapped.points())
    for (int x = -most[1]; x <= most[1]; ++x)
      for (int y = -most[2]; y <= most[2]; ++y)
        for (int z = -most[3]; z <= most[3]; ++z) {
          const Corner moved = {w.corner[0], w.corner[1] + x, w.corner[2] + y, w.corner[3] + z};
          const int by[3] = {x, y, z};
          std::array<Exact::FT, 3> at = w.at;
          for (std::size_t a = 0; a < 3; ++a)
            if (by[a] != 0)
              at[a] += Exact::FT(by[a]) * Exact::FT(box[a]);
          const Info info = {moved, x == 0 && y == 0 && z == 0};
          const Exact::Point_3 p(at[0], at[1], at[2]);
          if (weights.empty())
            copies.emplace_back(p, info);
          else
            weighted.emplace_back(Exact::Weighted_point_3(p, Exact::FT(w.weight)), info);
        }
  if (weights.empty())
    return outcome_at_home(Delaunay(copies.begin(), copies.end()));
  Regular regular;
  regular.insert(weighted.begin(), weighted.end());
  return outcome_at_home(regular);
}

// That of a Periodic_3_..._triangulation_3; the points must lie in its domain.
template <class Triangulation>
Outcome outcome_of_periodic(const Triangulation& tr, const Points& points)
{
  std::map<Coordinates, int> first;
  for (std::size_t i = 0; i < points.size(); ++i)
    first.insert({points[i], int(i)});
  Outcome outcome;
  for (auto c = tr.cells_begin(); c != tr.cells_end(); ++c) {
    Simplex corners;
    for (int k = 0; k < 4; ++k) {
      const auto p = tr.periodic_point(c, k);
      const int i = first.at({p.first.x(), p.first.y(), p.first.z()});
      corners.push_back({i, p.second.x(), p.second.y(), p.second.z()});
      outcome.visible.insert(i);
    }
    outcome.cells.insert(canonical(corners));
  }
  return outcome;
}

inline Simplex simplex_of(const Arrays& arrays, std::size_t c)
{
  Simplex corners;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& o = arrays.offsets(c)[k];
    corners.push_back({arrays.vertices(c)[k], o[0], o[1], o[2]});
  }
  return corners;
}

inline Simplex without(Simplex s, std::size_t k)
{
  s.erase(s.begin() + std::ptrdiff_t(k));
  return canonical(s);
}

inline bool are_neighbors_right(const Arrays& arrays)
{
  for (std::size_t c = 0; c < arrays.number_of_simplices(); ++c)
    for (std::size_t k = 0; k < 4; ++k) {
      const auto d = arrays.neighbors(c)[k];
      bool is_right = false;
      if (d == Arrays::none) { // beyond a facet of the hull there is no other
        is_right = true;
      } else {
        const Simplex facet = without(simplex_of(arrays, c), k);
        for (std::size_t j = 0; j < 4; ++j)
          is_right = is_right || (arrays.neighbors(std::size_t(d))[j] == std::int32_t(c) &&
                                  (std::size_t(d) != c || j != k) &&
                                  without(simplex_of(arrays, std::size_t(d)), j) == facet);
      }
      if (!is_right)
        return false;
    }
  return true;
}

struct Numbers_of_simplices
{
  std::set<int> vertices;
  std::set<Simplex> edges, facets;
  std::map<Simplex, int> cells_of_facet;
  std::size_t hull_facets = 0, cells = 0;
  bool is_simplicial = true;

  explicit Numbers_of_simplices(const std::set<Simplex>& of)
    : cells(of.size())
  {
    for (const Simplex& s : of)
      for (std::size_t k = 0; k < 4; ++k) {
        vertices.insert(s[k][0]);
        facets.insert(without(s, k));
        ++cells_of_facet[without(s, k)];
        for (std::size_t j = 0; j < k; ++j)
          edges.insert(canonical({s[j], s[k]}));
      }
    for (const auto& facet : cells_of_facet)
      hull_facets += facet.second == 1;
    std::set<std::pair<int, int>> ends;
    for (const Simplex& e : edges)
      is_simplicial = is_simplicial && e[0][0] != e[1][0] && ends.insert({e[0][0], e[1][0]}).second;
  }
  long euler() const
  {
    return long(vertices.size()) - long(edges.size()) + long(facets.size()) - long(cells);
  }
};

// The sum of the volumes of all cells, as a share of that of the box; NaN if one is clearly negative.
inline double share_of_volume(const Arrays& arrays, const Points& points, const Box& box)
{
  double sum = 0;
  for (std::size_t c = 0; c < arrays.number_of_simplices(); ++c) {
    const Simplex s = simplex_of(arrays, c);
    double v[3][3];
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t a = 0; a < 3; ++a) {
        const double to = points[std::size_t(s[k + 1][0])][a],
                     from = points[std::size_t(s[0][0])][a];
        v[k][a] = (to / box[a] - from / box[a]) + (s[k + 1][a + 1] - s[0][a + 1]);
      }
    const double volume = v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) -
                          v[0][1] * (v[1][0] * v[2][2] - v[1][2] * v[2][0]) +
                          v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]);
    if (volume < -1e-9)
      return std::nan("");
    sum += volume / 6;
  }
  return sum;
}

inline std::size_t wrong_orientations(const Arrays& arrays, const Points& points, const Box& box)
{
  std::size_t wrong = 0;
  for (std::size_t c = 0; c < arrays.number_of_simplices(); ++c) {
    std::vector<Exact::Point_3> p;
    for (const Corner& corner : simplex_of(arrays, c)) {
      std::array<Exact::FT, 3> at;
      for (std::size_t a = 0; a < 3; ++a) {
        at[a] = points[std::size_t(corner[0])][a];
        if (corner[a + 1] != 0)
          at[a] += Exact::FT(corner[a + 1]) * Exact::FT(box[a]);
      }
      p.emplace_back(at[0], at[1], at[2]);
    }
    wrong += CGAL::orientation(p[0], p[1], p[2], p[3]) != CGAL::POSITIVE;
  }
  return wrong;
}

// Nothing if the arrays have the cells of the outcome, and all they say fits together.
inline std::string mistake_in(const Arrays& arrays, const Outcome& outcome, const Points& points,
                              const Weights& weights, const Box& box)
{
  const std::size_t n = points.size();
  std::set<Simplex> cells;
  for (std::size_t c = 0; c < arrays.number_of_simplices(); ++c) {
    Simplex corners = simplex_of(arrays, c);
    cells.insert(canonical(corners));
    std::sort(corners.begin(), corners.end());
    if (corners[0][1] != 0 || corners[0][2] != 0 || corners[0][3] != 0)
      return "a cell whose first corner is moved";
  }
  if (cells.size() != arrays.number_of_simplices())
    return "two copies of a cell";
  if (cells != outcome.cells) {
    std::size_t common = 0;
    for (const Simplex& s : cells)
      common += outcome.cells.count(s);
    return "other cells: " + std::to_string(cells.size()) + " instead of " +
           std::to_string(outcome.cells.size()) + ", " + std::to_string(common) + " are right";
  }
  if (arrays.number_of_cells() != cells.size() || arrays.number_of_points() != n ||
      arrays.number_of_vertices() != outcome.visible.size())
    return "wrong numbers";
  const Wrapped_points wrapped(points, weights, box);
  for (std::size_t i = 0; i < n; ++i) {
    const int first = wrapped.first_of_equal(i);
    if (arrays.vertex_of_point(i) != (outcome.visible.count(first) == 0 ? -1 : first))
      return "a wrong vertex of point " + std::to_string(i);
  }
  if (!are_neighbors_right(arrays))
    return "wrong neighbours";
  const Numbers_of_simplices numbers(cells);
  std::size_t none = 0;
  for (std::size_t c = 0; c < arrays.number_of_simplices(); ++c)
    for (std::size_t k = 0; k < 4; ++k)
      none += arrays.neighbors(c)[k] == Arrays::none;
  if (none != numbers.hull_facets)
    return "neighbours are missing";
  if (numbers.is_simplicial != arrays.is_simplicial_complex())
    return "it is wrong about the simplicial complex";
  if (std::all_of(box.begin(), box.end(), [](double L) { return std::isfinite(L); })) {
    if (numbers.hull_facets != 0 || numbers.euler() != 0)
      return "not a torus";
    if (!(std::abs(share_of_volume(arrays, points, box) - 1) < 1e-6))
      return "the volumes do not fill the box";
  }
  if (n <= 300 && wrong_orientations(arrays, points, box) != 0)
    return "wrong orientations";
  return "";
}

} // namespace periodic
} // namespace tests

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_PERIODIC_CELLS_H
