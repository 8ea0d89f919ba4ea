// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_OPTIONS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_OPTIONS_H

#include <CGAL/version.h>

#include <boost/program_options.hpp>

#include <iostream>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

// What the user asked for.
struct Options
{
  std::string input, output, traits;
  unsigned int seed = 0, repetitions = 5;
  bool compare = false, stats = false;
};

inline const char* const usage_text =
    "Usage: delaunay_from_surface SURFACE [OPTION...]\n"
    "\n"
    "Builds the 3D Delaunay triangulation of the vertices of a surface. The connectivity of the\n"
    "surface serves to find the place of each vertex; the result is the same as without it.\n"
    "\n"
    "SURFACE is an .off, .ply, .obj or .stl file: a mesh, a polygon soup, or points alone.\n"
    "\n"
    "Example, with a comparison and all figures:\n"
    "  delaunay_from_surface bunny.off --output bunny.vtu --compare --stats\n"
    "\n";

inline const char* const exit_codes_text =
    "\nResults go to the standard output, progress and notes to the standard error.\n"
    "Exit code: 0 if all went well, 1 after an error, 2 if --compare found a difference.\n";

inline const char* const traits_text =
    "how to go about it:\n"
    "  default  \tthe fastest measured\n"
    "  tracing  \tthe algorithm of the paper (Choi, SoCG 2002): random order, rounds, and the "
    "surface traced through the triangulation after each round\n"
    "  plain    \tthe order and the starting cells of CGAL's own insert(first, last)";

// A number in [lowest, largest of unsigned int]; Boost alone would take -1 for 4294967295.
inline unsigned int checked_number(const std::string& option, long long value, long long lowest)
{
  if (value < lowest || value > (long long)(std::numeric_limits<unsigned int>::max)())
    throw std::runtime_error("option '--" + option + "' needs a whole number from " +
                             std::to_string(lowest) + " to 4294967295");
  return static_cast<unsigned int>(value);
}

// Reads the command line. Prints --help and --version, and then returns nothing.
// Throws std::exception with one clear line.
inline std::optional<Options> parse_command_line(int argc, char* argv[])
{
  namespace po = boost::program_options;
  Options options;
  long long seed = options.seed, repetitions = options.repetitions;

  po::options_description visible("Options", 100);
  visible.add_options()                                                                      //
      ("output,o", po::value(&options.output)->value_name("FILE"),                           //
       "write the tetrahedra to FILE: .vtu (ParaView, VTK) or .mesh (Medit); otherwise "     //
       "nothing is written")                                                                 //
      ("traits", po::value(&options.traits)->default_value("default")->value_name("NAME"),   //
       traits_text)                                                                          //
      ("seed", po::value(&seed)->default_value(seed)->value_name("NUMBER"),                  //
       "seed of the insertion order")                                                        //
      ("compare", po::bool_switch(&options.compare),                                         //
       "run CGAL's own insert(first, last) on the same points beside it, in turns; print "   //
       "median times, their ratio, and whether both triangulations are equal")               //
      ("repetitions",                                                                        //
       po::value(&repetitions)->default_value(repetitions)->value_name("NUMBER"),            //
       "how often --compare runs each")                                                      //
      ("stats", po::bool_switch(&options.stats),                                             //
       "count cells and predicate calls by round, take the time by phase (in runs of their " //
       "own), and count the edges and triangles of the surface that are Delaunay")           //
      ("help,h", "print this text")                                                          //
      ("version", "print the version");

  po::options_description all;
  all.add(visible).add_options()("input", po::value(&options.input));
  const po::positional_options_description positional =
      po::positional_options_description().add("input", 1);
  po::variables_map given;
  const int style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
  po::store(
      po::command_line_parser(argc, argv).options(all).positional(positional).style(style).run(),
      given);

  if (given.count("help") != 0) {
    std::cout << usage_text << visible << exit_codes_text;
    return std::nullopt;
  }
  if (given.count("version") != 0) {
    std::cout << "delaunay_from_surface " DELAUNAY_FROM_SURFACE_3_VERSION " (CGAL " CGAL_VERSION_STR
                 ")\n";
    return std::nullopt;
  }
  po::notify(given);

  if (options.input.empty())
    throw std::runtime_error("no surface given");
  if (options.traits != "default" && options.traits != "tracing" && options.traits != "plain")
    throw std::runtime_error("unknown traits '" + options.traits +
                             "': they are default, tracing and plain");
  if (!options.compare && !given["repetitions"].defaulted())
    throw std::runtime_error("option '--repetitions' needs '--compare'");
  options.seed = checked_number("seed", seed, 0);
  options.repetitions = checked_number("repetitions", repetitions, 1);
  return options;
}

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_OPTIONS_H
