// Copyright (c) 2026 The authors of Delaunay_from_surface_3
// SPDX-License-Identifier: GPL-3.0-or-later

// Makes a triangle surface for tests and benchmarks and writes it to a file.

#include <Delaunay_from_surface_3_files/one_line.h>
#include <Delaunay_from_surface_3_surfaces/Indexed_surface.h>
#include <Delaunay_from_surface_3_surfaces/adversarial.h>
#include <Delaunay_from_surface_3_surfaces/cad.h>
#include <Delaunay_from_surface_3_surfaces/clusters.h>
#include <Delaunay_from_surface_3_surfaces/edit.h>
#include <Delaunay_from_surface_3_surfaces/genus_surface.h>
#include <Delaunay_from_surface_3_surfaces/io.h>
#include <Delaunay_from_surface_3_surfaces/lattice_surface.h>
#include <Delaunay_from_surface_3_surfaces/marching_cubes.h>
#include <Delaunay_from_surface_3_surfaces/parametric.h>
#include <Delaunay_from_surface_3_surfaces/refine.h>

#include <CGAL/Real_timer.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>

namespace {

namespace po = boost::program_options;
using surfaces::Indexed_surface;

const char* const introduction = R"(Makes a triangle surface and writes it to a file.

  generate_surface --shape genus --genus 3 --vertices 1000000 --jitter 0.05 -o three_tori.ply
  generate_surface --shape loop --input bunny.off --rounds 2 -o fine_bunny.ply
  generate_surface --shape sphere --noise 0.01 --vertices 50000 --shuffle -o sphere.off

The same options always give the same file.

Shapes (--vertices says about how many points to make):
  genus           smooth closed surface of any --genus: an ellipsoid or a chain of tori
  plate           flat plate with round holes, closed, of any --genus
  sphere          unit sphere with exactly that many points, and --noise
  integer-sphere  integer points exactly on one sphere, for some thousands of points
  lattice         box with square holes, of any --genus, on the integer lattice
  thin-plate      two square lattices at distance --thickness
  torus           regular grid on a torus
  winding-torus   a torus whose points wind around it, of a Fibonacci number
  round-tube      rings, one behind the other
  marching-cubes  marching cubes on a smooth sum of random waves
  noise           marching cubes on nothing but noise
  terrain         hilly land with a boundary
  coplanar        square lattice in one plane
  collinear       points on one line, triangles without area
  loop            Loop subdivision of the mesh --input, --rounds times
  densify         the mesh --input, refined to exactly --vertices points

Solids as CAD gives them, with fans and needles; --seed draws their proportions, --numbering says how
the vertices are numbered: along the profile, along the rings or not at all:
  airfoil         extruded NACA airfoil
  gear            extruded gear with a bore
  i-beam          extruded I-beam with fillets
  drilled-plate   plate with rows of holes with rounded rims
  ribbed-plate    plate with ribs on fillets
  pipe            pipe of straight parts and bends
  cylinder        cylinder of many segments, with fans as caps
  thread          threaded rod, with fans as caps
  vase            turned solid of a smooth outline, with fans as caps

Surfaces that mislead:
  star            a fan around vertex 0 that joins points of a thick sphere at random
  random-faces    points of a thick sphere, faces that join three of them at random
  two-lines       a band from line to line, which are askew: quadratically many cells
  skew-stars      disjoint fans whose hubs lie on two lines askew, their leaves anywhere
  nearly-flat     random points of a square, off their plane by up to 1e-12
  noisy-sheet     square lattice, off its plane by up to 2^-k; --exponent is k
  dented-sheet    square lattice, every tenth point off its plane by 1e-17
  thin-tube       tube along an axis, 2^-k as thick as long
  far-points      thick sphere, every tenth point 2^k times as far from the origin
  sentinels       thick sphere, every twentieth z is 2^k
  all-equal       points at one place
  room            six walls that bulge inwards, and a point in the middle that sees them all

Points without faces:
  cube            random points of a cube
  plummer         a star cluster
  soneira-peebles clusters of clusters, on nine levels
  boxes           turned boxes of very different sizes, in float coordinates

Options)";

po::options_description describe_options()
{
  po::options_description options(introduction);
  auto add = options.add_options();
  add("help,h", "say this and stop");
  add("shape,s", po::value<std::string>()->value_name("NAME"), "what to make, see above");
  add("output,o", po::value<std::string>()->value_name("FILE"),
      "where to: .off (text) or .ply (binary, fast)");
  add("vertices,n", po::value<std::int64_t>()->value_name("N")->default_value(10000),
      "number of vertices");
  add("genus,g", po::value<std::int64_t>()->value_name("G")->default_value(1), "number of handles");
  add("noise", po::value<double>()->value_name("X")->default_value(0),
      "of a sphere: standard deviation of the radius, which is 1");
  add("exponent,k", po::value<std::int64_t>()->value_name("K")->default_value(60),
      "of the power of 2 of flat and far surfaces");
  add("thickness", po::value<double>()->value_name("X")->default_value(0.01),
      "of a thin plate, where neighbours in the lattice have distance 1");
  add("input,i", po::value<std::string>()->value_name("FILE"),
      "triangle mesh to refine (.off, .ply, .obj, .stl)");
  add("rounds,r", po::value<std::int64_t>()->value_name("N")->default_value(1),
      "rounds of Loop subdivision");
  add("jitter,j", po::value<double>()->value_name("X"),
      "move every point by up to this share of its mean edge length (by default 0.05 for loop and "
      "densify, else 0)");
  add("components", po::value<std::int64_t>()->value_name("N")->default_value(1),
      "number of copies, side by side");
  add("holes", po::value<std::int64_t>()->value_name("N")->default_value(0),
      "number of faces to take out");
  add("duplicates", po::value<std::int64_t>()->value_name("N")->default_value(0),
      "number of points to double");
  add("soup", po::bool_switch(), "give every face three points of its own");
  add("numbering", po::value<std::string>()->value_name("NAME")->default_value("profile"),
      "of a CAD solid: profile, ring or shuffled");
  add("decimals", po::value<std::int64_t>()->value_name("N"), "round coordinates to N decimals");
  add("float", po::bool_switch(), "round coordinates to single precision");
  add("shuffle", po::bool_switch(), "put points and faces into random order");
  add("seed", po::value<std::uint64_t>()->value_name("N")->default_value(0),
      "seed of all that is random");
  add("check", po::bool_switch(), "count components and edges too");
  return options;
}

// A count that is not negative: read as a signed number, lest "-1" becomes a huge one.
std::size_t count(const po::variables_map& options, const std::string& name)
{
  const std::int64_t value = options[name].as<std::int64_t>();
  if (value < 0 || value > 1000000000)
    throw std::invalid_argument("--" + name + " must lie between 0 and 1000000000");
  return static_cast<std::size_t>(value);
}

// Of a power of 2 that a double can be multiplied with.
int exponent(const po::variables_map& options)
{
  const std::int64_t value = options["exponent"].as<std::int64_t>();
  if (value < 0 || value > 1000)
    throw std::invalid_argument("--exponent must lie between 0 and 1000");
  return static_cast<int>(value);
}

double finite(const po::variables_map& options, const std::string& name)
{
  const double value = options[name].as<double>();
  if (!std::isfinite(value))
    throw std::invalid_argument("--" + name + " must be a finite number");
  return value;
}

std::string text(const po::variables_map& options, const std::string& name)
{
  if (options.count(name) == 0)
    throw std::invalid_argument("--" + name + " is missing (--help says more)");
  return options[name].as<std::string>();
}

surfaces::Numbering numbering(const po::variables_map& options)
{
  const std::map<std::string, surfaces::Numbering> names = {
      {"profile", surfaces::Numbering::BY_PROFILE},
      {"ring", surfaces::Numbering::BY_RING},
      {"shuffled", surfaces::Numbering::SHUFFLED}};
  const auto name = names.find(text(options, "numbering"));
  if (name == names.end())
    throw std::invalid_argument("--numbering must be profile, ring or shuffled");
  return name->second;
}

Indexed_surface make_shape(const po::variables_map& options)
{
  const std::size_t n = count(options, "vertices"), genus = count(options, "genus");
  const std::uint64_t seed = options["seed"].as<std::uint64_t>();
  std::map<std::string, std::function<Indexed_surface()>> makers = {
      {"genus", [&] { return surfaces::genus_surface(genus, n, 0, seed); }},
      {"plate", [&] { return surfaces::plate_surface(genus, n, 0, seed); }},
      {"sphere", [&] { return surfaces::sphere(n, finite(options, "noise"), seed); }},
      {"integer-sphere", [&] { return surfaces::integer_sphere(n); }},
      {"lattice", [&] { return surfaces::lattice_surface(genus, n); }},
      {"thin-plate", [&] { return surfaces::thin_plate(n, finite(options, "thickness")); }},
      {"torus", [&] { return surfaces::grid_torus(n); }},
      {"terrain", [&] { return surfaces::terrain(n, seed); }},
      {"coplanar", [&] { return surfaces::coplanar(n); }},
      {"collinear", [&] { return surfaces::collinear(n); }},
      {"star", [&] { return surfaces::star(n, seed); }},
      {"random-faces", [&] { return surfaces::faces_at_random(n, seed); }},
      {"two-lines", [&] { return surfaces::two_lines(n); }},
      {"skew-stars", [&] { return surfaces::skew_stars(n, seed); }},
      {"winding-torus", [&] { return surfaces::winding_torus(n); }},
      {"round-tube", [&] { return surfaces::round_tube(n); }},
      {"marching-cubes",
       [&] {
         const auto side = static_cast<std::size_t>(std::lround(std::sqrt(double(n) / 4.2)));
         return surfaces::marching_cubes(surfaces::random_waves(side, 6, seed));
       }},
      {"noise",
       [&] {
         const auto side = static_cast<std::size_t>(std::lround(std::cbrt(double(n) / 1.4)));
         return surfaces::marching_cubes(surfaces::noise(side, seed));
       }},
      {"noisy-sheet", [&] { return surfaces::noisy_sheet(n, exponent(options), seed); }},
      {"dented-sheet", [&] { return surfaces::dented_sheet(n, 1e-17); }},
      {"thin-tube", [&] { return surfaces::thin_tube(n, exponent(options)); }},
      {"far-points", [&] { return surfaces::far_points(n, exponent(options), seed); }},
      {"sentinels", [&] { return surfaces::sentinels(n, exponent(options), seed); }},
      {"all-equal", [&] { return surfaces::all_equal(n); }},
      {"cube", [&] { return surfaces::points_in_box(n, 1, 1, 1, seed); }},
      {"plummer", [&] { return surfaces::plummer_sphere(n, seed); }},
      {"soneira-peebles", [&] { return surfaces::soneira_peebles(n, seed); }},
      {"boxes", [&] { return surfaces::boxes_of_gaussians(n, seed); }},
      {"room", [&] { return surfaces::room(n, seed); }},
      {"nearly-flat", [&] { return surfaces::nearly_flat(n, 1e-12, seed); }},
      {"loop",
       [&] {
         const unsigned rounds = static_cast<unsigned>(count(options, "rounds"));
         return surfaces::loop_subdivided(surfaces::read_mesh(text(options, "input")), rounds, 0);
       }},
      {"densify",
       [&] { return surfaces::densified(surfaces::read_mesh(text(options, "input")), n, 0); }},
  };
  for (const surfaces::Cad_family& family : surfaces::cad_families())
    makers[family.name] = [&, make = family.make] { return make(n, seed, numbering(options)); };
  const std::string name = text(options, "shape");
  const auto maker = makers.find(name);
  if (maker == makers.end())
    throw std::invalid_argument("there is no shape '" + name + "' (--help lists them)");
  return maker->second();
}

// All that can be done to any shape, in this order.
void edit(Indexed_surface& surface, const po::variables_map& options)
{
  const std::uint64_t seed = options["seed"].as<std::uint64_t>();
  const bool refined = options.count("input") != 0;
  if (const std::size_t components = count(options, "components"); components != 1)
    surface = surfaces::copies(surface, components);
  surfaces::jitter(surface,
                   options.count("jitter") ? options["jitter"].as<double>()
                   : refined               ? 0.05
                                           : 0.,
                   seed);
  if (const std::size_t holes = count(options, "holes"))
    surfaces::puncture(surface, holes, seed);
  if (options["float"].as<bool>())
    surfaces::round_to_float(surface);
  if (options.count("decimals"))
    surfaces::round_to_decimals(surface, static_cast<unsigned>(count(options, "decimals")));
  if (const std::size_t duplicates = count(options, "duplicates"))
    surfaces::duplicate_points(surface, duplicates, seed);
  if (options["soup"].as<bool>())
    surfaces::separate_faces(surface);
  if (options["shuffle"].as<bool>())
    surfaces::shuffle(surface, seed);
}

void run(const po::variables_map& options)
{
  const std::string file_name = text(options, "output");
  if (options.count("input") && files::are_same_file(text(options, "input"), file_name))
    throw std::invalid_argument(file_name + ": would overwrite the input");
  files::remove_files_on_signal();
  CGAL::Real_timer timer;
  timer.start();
  Indexed_surface surface = make_shape(options);
  edit(surface, options);
  if (!std::all_of(surface.points.begin(), surface.points.end(), surfaces::is_finite))
    throw std::runtime_error("the coordinates of this surface are too large for double numbers");
  const double made = timer.time();
  surfaces::write_surface(surface, file_name);
  std::cout << surface.points.size() << " vertices, " << surface.faces.size() << " faces; made in "
            << made << " s, written in " << timer.time() - made << " s\n";
  if (options["check"].as<bool>())
    std::cout << surfaces::number_of_components(surface) << " components, Euler characteristic "
              << surfaces::euler_characteristic(surface) << '\n';
}

} // namespace

int main(int argc, char** argv)
{
  try {
    const po::options_description description = describe_options();
    po::variables_map options;
    // An empty positional description: a stray word is an error.
    po::store(po::command_line_parser(argc, argv).options(description).positional({}).run(),
              options);
    po::notify(options);
    if (options.count("help"))
      std::cout << description;
    else
      run(options);
    return EXIT_SUCCESS;
  } catch (const std::bad_alloc&) {
    std::cerr << "generate_surface: not enough memory for a surface of this size\n";
  } catch (const std::exception& error) {
    std::cerr << "generate_surface: " << files::one_line(error.what()) << '\n';
  }
  return EXIT_FAILURE;
}
