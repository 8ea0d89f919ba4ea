// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_WRITE_VIEW_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_WRITE_VIEW_H

// Writes the page of --view for a browser, with all that it needs. The folder view/ has its parts;
// view.js draws with three.js the data that is written here.

#include "Options.h"
#include "Report.h"
#include "Surface.h"
#include "write_output.h"

#include <Delaunay_from_surface_3_files/Output_file.h>

#include <CGAL/Delaunay_from_surface_3/Insertion_order.h>
#include <CGAL/Delaunay_from_surface_3/Surface_input_error.h>
#include <CGAL/bounded_degree_spanning_subgraph.h>
#include <CGAL/surface_of.h>

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// The files of view/, of which CMake has made strings.
extern const char* const view_html;
extern const char* const view_css;
extern const char* const cut_js;
extern const char* const voronoi_js;
extern const char* const view_js;

// Strings of browsers have at most half a gigabyte.
constexpr std::size_t most_tetrahedra_of_view = 20000000;

// The data that the page shows, in numbers of different points.
struct View
{
  std::vector<float> points;
  std::vector<std::uint32_t> tetrahedra, triangles, hull,
      subgraph;                             // the hull if there is no surface
  std::vector<std::uint8_t> inside, rounds; // for each tetrahedron; for each point
  std::string doubt;                        // about those inside, which is not in the page
};

// Moves the middle of the points' box to 0 and scales its longest side to [-1, 1]: floats suffice.
inline std::vector<float> centered(const std::vector<std::array<double, 3>>& points)
{
  std::array<double, 3> middle;
  double size = 0;
  for (std::size_t j = 0; j < 3; ++j) {
    const auto [low, high] = std::minmax_element(
        points.begin(), points.end(), [j](const auto& p, const auto& q) { return p[j] < q[j]; });
    middle[j] = (*low)[j] / 2 + (*high)[j] / 2; // halves do not overflow
    size = (std::max)(size, (*high)[j] / 2 - (*low)[j] / 2);
  }
  std::vector<float> result;
  result.reserve(3 * points.size());
  for (const auto& p : points)
    for (std::size_t j = 0; j < 3; ++j)
      result.push_back(float((p[j] - middle[j]) / size));
  return result;
}

// Returns the order in which the traits insert the surface.
template <class Traits>
DFS::Insertion_order order_of(const Surface& surface, const Traits& traits, unsigned int seed)
{
  const std::decay_t<decltype(surface.mesh)> no_edges; // no plan looks at any edge
  return traits.insertion_plan_object(seed)(surface.points, Kernel(), no_edges,
                                            get(boost::vertex_index, no_edges));
}

// Returns the edges of the subgraph of bounded degree, as indices of input points, or nothing if
// there is no such graph.
inline std::vector<std::size_t> subgraph_of(const Surface& surface)
{
  std::vector<std::size_t> ends;
  if (!surface.is_manifold || !is_triangle_mesh(surface.mesh))
    return ends;
  try {
    CGAL::bounded_degree_spanning_subgraph(
        CGAL::surface_of(surface.mesh),
        boost::make_function_output_iterator([&](Mesh::Edge_index e) {
          ends.push_back(std::size_t(source(e, surface.mesh)));
          ends.push_back(std::size_t(target(e, surface.mesh)));
        }));
  } catch (const CGAL::Surface_input_error&) { // the surface is pinched, say
  }
  return ends;
}

// Returns the corners of triangles, into which polygons are cut as for those inside.
inline std::vector<std::size_t> triangles_of(const Surface& surface)
{
  std::vector<std::size_t> corners;
  DFS::internal::for_each_triangle(surface.faces, surface.points.size(),
                                   [&](std::size_t i, std::size_t j, std::size_t k, std::size_t) {
                                     corners.insert(corners.end(), {i, j, k});
                                   });
  return corners;
}

// Makes the data. The rounds are those of `order`, which may be empty.
inline View make_view(const Surface& surface, const Triangulation& tr, const Vertices& vertices,
                      const DFS::Insertion_order& order, bool has_threads)
{
  const auto arrays = arrays_of_triangulation<std::int32_t>(tr, vertices, false);
  const files::Simplices_3 simplices = files::simplices_of(surface.points, arrays);
  std::vector<std::uint32_t> numbers(surface.points.size());
  for (std::size_t k = 0; k < simplices.input_indices.size(); ++k)
    numbers[std::size_t(simplices.input_indices[k])] = std::uint32_t(k);
  const auto numbered = [&](const std::vector<std::size_t>& indices) {
    std::vector<std::uint32_t> result;
    for (const std::size_t i : indices)
      result.push_back(numbers[std::size_t(arrays.vertex_of_point(i))]);
    return result;
  };

  View view;
  view.points = centered(simplices.points);
  view.tetrahedra.assign(simplices.simplices.begin(), simplices.simplices.end());
  view.triangles = numbered(triangles_of(surface));
  for (std::size_t c = arrays.number_of_simplices();
       view.triangles.empty() && c < arrays.number_of_cells(); ++c)
    for (std::size_t k = 0; k < 3; ++k)
      view.hull.push_back(numbers[std::size_t(arrays.vertices(c)[k])]);
  view.subgraph = numbered(subgraph_of(surface));
  try {
    const CGAL::Inside_3 inside = inside_of(surface, arrays, has_threads);
    for (std::size_t c = 0; c < arrays.number_of_simplices(); ++c)
      view.inside.push_back(std::uint8_t(inside[c]));
    view.doubt = DFS::internal::warning_of(inside);
  } catch (const std::runtime_error&) { // it has no inside
  }
  if (order.round_ends.size() > 1 && order.round_ends.size() < 256) {
    const std::vector<std::uint32_t> points = numbered(order.order);
    view.rounds.assign(simplices.points.size(), std::uint8_t(order.round_ends.size() - 1));
    for (std::size_t r = order.round_ends.size() - 1; r-- > 0;) // of equal points the first counts
      for (std::size_t k = r == 0 ? 0 : order.round_ends[r - 1]; k < order.round_ends[r]; ++k)
        view.rounds[points[k]] = std::uint8_t(r);
  }
  return view;
}

// --- The page ---

// Appends the bytes of a number, the lowest first on every machine.
template <class Number>
void append_bytes(Number number, std::vector<unsigned char>& bytes)
{
  std::uint32_t bits = 0;
  static_assert(sizeof(Number) <= sizeof(bits), "");
  if constexpr (std::is_integral<Number>::value)
    bits = number;
  else
    std::memcpy(&bits, &number, sizeof(bits));
  for (std::size_t k = 0; k < sizeof(Number); ++k)
    bytes.push_back((unsigned char)(bits >> 8 * k & 255));
}

// Writes an array into an element of its own, unless it is empty.
template <class Number>
void write_array(std::ostream& out, const char* id, const std::vector<Number>& numbers)
{
  using namespace boost::archive::iterators;
  using Base64 = base64_from_binary<transform_width<const unsigned char*, 6, 8>>;
  if (numbers.empty())
    return;
  std::vector<unsigned char> bytes;
  bytes.reserve(sizeof(Number) * numbers.size() + 2);
  for (const Number number : numbers)
    append_bytes(number, bytes);
  while (bytes.size() % 3 != 0) // three bytes are four letters
    bytes.push_back(0);
  out << "<script type=\"application/octet-stream\" id=\"" << id << "\" data-count=\""
      << numbers.size() << "\">";
  std::copy(Base64(bytes.data()), Base64(bytes.data() + bytes.size()),
            std::ostreambuf_iterator<char>(out));
  out << "</script>\n";
}

// Returns text for a place between <script> and </script>, such that it does not end the script.
inline std::string for_script(std::string text)
{
  for (std::size_t k = 0; (k = text.find('<', k)) != std::string::npos; ++k)
    text.replace(k, 1, "\\u003c");
  return text;
}

inline void write_data(std::ostream& out, const std::string& name, const View& view)
{
  out << "<script type=\"application/json\" id=\"info\">{\"name\": "
      << for_script(json_string(name)) << "}</script>\n";
  write_array(out, "points", view.points);
  write_array(out, "tetrahedra", view.tetrahedra);
  write_array(out, "inside", view.inside);
  write_array(out, "triangles", view.triangles);
  write_array(out, "hull", view.hull);
  write_array(out, "rounds", view.rounds);
  write_array(out, "subgraph", view.subgraph);
}

// Writes view.html, in which a line that is a comment with a name stands for the part of this name.
inline void write_page(std::ostream& out, const std::string& name, const std::string& three_js,
                       const View& view)
{
  std::istringstream page(view_html);
  for (std::string line; std::getline(page, line);)
    if (line == "<!--view.css-->")
      out << view_css;
    else if (line == "<!--data-->")
      write_data(out, name, view);
    else if (line == "<!--three.js-->")
      out << std::ifstream(three_js, std::ios::binary).rdbuf() << '\n';
    else if (line == "<!--cut.js-->")
      out << cut_js;
    else if (line == "<!--voronoi.js-->")
      out << voronoi_js;
    else if (line == "<!--view.js-->")
      out << view_js;
    else
      out << line << '\n';
}

inline void check_that_view_is_possible(const Options& options, const Triangulation& tr)
{
  if (options.view.empty())
    return;
  if (tr.dimension() < 3)
    throw std::runtime_error(options.view + ": there are no tetrahedra to be viewed");
  if (tr.number_of_finite_cells() > most_tetrahedra_of_view)
    throw std::runtime_error(options.view + ": " + std::to_string(tr.number_of_finite_cells()) +
                             " tetrahedra are too many for a browser, which takes " +
                             std::to_string(most_tetrahedra_of_view));
}

template <class Traits>
void write_view(const Options& options, const Surface& surface, const Triangulation& tr,
                const Vertices& vertices, const Traits& traits, bool has_replaced_order,
                files::Output_file& file, Report& report, Messages& messages)
{
  DFS::Insertion_order order;
  if (!has_replaced_order)
    order = order_of(surface, traits, options.seed);
  const View view = make_view(surface, tr, vertices, order, options.threads > 1);
  const std::string name = options.input == "-"
                               ? "standard input"
                               : std::filesystem::path(options.input).filename().string();
  if (!view.doubt.empty() && !options.inside && !options.mark_inside) // else it has been said
    messages.warn(options.input + ": " + view.doubt);
  write_page(file.stream(), name, options.three_js, view);
  const auto bytes = file.stream().tellp();
  file.finish();
  report("view", options.view + ", " + decimals(double(bytes) / 1e6, 1) + " MB");
}

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_WRITE_VIEW_H
