// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_OPTIONS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_OPTIONS_H

#include "Report.h"

#include <Delaunay_from_surface_3_files/read_polygon_soup.h>

#include <CGAL/version.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// The text of help.txt, of which CMake has made a string.
extern const char* const help_text;

// The requests of the user.
struct Options : Printing
{
  std::string input, from; // `from` is empty if the extension says it
  std::string output, to;  // `to` is a format; both are empty if nothing is written
  std::string view;        // a page for a browser, if any
  std::string three_js = DELAUNAY_FROM_SURFACE_3_THREE_JS;
  std::string traits;
  unsigned int seed = 0, repetitions = 5, threads = 1;
  bool weights = false, inside = false, mark_inside = false;
  bool compare = false, stats = false;
};

// Returns the format of the output, as requested or as the extension says.
inline std::string output_format(const Options& options)
{
  static const std::vector<std::string> formats = {"vtu", "vtk", "msh", "mesh", "tetgen", "cgal"};
  std::string format = options.to;
  if (format.empty()) {
    format = files::file_extension(options.output);
    if (format == "node" || format == "ele" || format == "neigh")
      format = "tetgen";
    if (options.output == "-")
      throw std::runtime_error(
          "'--output -' needs '--to', as there is no extension to tell the format");
  }
  if (std::find(formats.begin(), formats.end(), format) == formats.end())
    throw std::runtime_error(options.to.empty()
                                 ? options.output + ": unknown extension; .vtu, .vtk, .msh, .mesh, "
                                                    ".node, .ele, .neigh and .cgal are written"
                                 : "unknown format '" + format +
                                       "': vtu, vtk, msh, mesh, tetgen and cgal are written");
  if (format == "tetgen" && options.output == "-")
    throw std::runtime_error("TetGen's three files do not fit into the standard output");
  return format;
}

// Returns the format of the input, in the same way.
inline std::string input_format(const Options& options)
{
  if (options.input.empty())
    throw std::runtime_error("no surface given");
  if (options.input == "-" && options.from.empty())
    throw std::runtime_error("the standard input needs '--from': no extension says the format");
  const std::string format =
      options.from.empty() ? files::file_extension(options.input) : options.from;
  if (options.from.empty())
    files::refuse_compressed(options.input, format);
  if (!files::is_format_read(format))
    throw std::runtime_error(
        (options.from.empty() ? options.input + ": unknown extension; "
                              : "unknown format '" + format + "': ") +
        files::formats_read +
        (options.from.empty() ? " are read, under other names with '--from'" : " are read"));
  return format;
}

inline void check_traits(const Options& options)
{
  if (options.traits != "default" && options.traits != "tracing" && options.traits != "plain")
    throw std::runtime_error("unknown traits '" + options.traits +
                             "': they are default, tracing and plain");
}

inline void check_output(const Options& options)
{
  if (options.output.empty() && !options.to.empty())
    throw std::runtime_error("option '--to' needs '--output'");
  if (options.output.empty() && (options.inside || options.mark_inside))
    throw std::runtime_error("options '--inside' and '--mark-inside' need '--output'" +
                             std::string(options.view.empty() ? "" : "; a page shows both anyway"));
  if (options.inside && options.mark_inside)
    throw std::runtime_error("'--inside' and '--mark-inside' exclude each other");
  if ((options.inside || options.mark_inside) && options.to == "cgal")
    throw std::runtime_error("a triangulation of CGAL is written as a whole");
  if (options.mark_inside && (options.to == "mesh" || options.to == "tetgen"))
    throw std::runtime_error("'--mark-inside' needs .vtu, .vtk or .msh: the others hold no data");
  if (options.quiet && options.verbose)
    throw std::runtime_error("'--quiet' and '--verbose' exclude each other");
}

// What is known of surfaces alone is refused for points with weights.
inline void check_weights(const Options& options)
{
  if (!options.weights)
    return;
  if (options.from != "xyz" && options.from != "pts" && options.from != "ply")
    throw std::runtime_error("'--weights' cannot be read from ." + options.from +
                             "; remedy: .xyz or .pts with four numbers in each line, or .ply whose "
                             "vertices have a property weight or radius");
  const auto exclude = [](bool is_given, const std::string& option, const std::string& why) {
    if (is_given)
      throw std::runtime_error("'--weights' excludes '" + option + "': " + why);
  };
  for (const auto& [is_given, option] :
       {std::pair(options.inside, "--inside"), std::pair(options.mark_inside, "--mark-inside")})
    exclude(is_given, option, "what is inside is found without weights; remedy: leave out either");
  exclude(!options.view.empty(), "--view",
          "a page shows no weights; remedy: '--output FILE.vtu', which ParaView shows");
  exclude(options.traits != "default", "--traits " + options.traits,
          "only the default traits know weights; remedy: leave out '--traits'");
  exclude(options.stats, "--stats",
          "it counts and times what goes without weights; remedy: '--compare', which takes both");
  exclude(options.to == "cgal", "--to cgal",
          "what reads .cgal expects no weights; remedy: another format, such as '--to vtu'");
}

inline void check_view(const Options& options)
{
  if (options.view.empty())
    return;
  const std::string extension = files::file_extension(options.view);
  if (extension != "html" && extension != "htm")
    throw std::runtime_error(options.view + ": a page for a browser is .html");
  if (std::ifstream(options.three_js).peek() == std::ifstream::traits_type::eof())
    throw std::runtime_error("'--view' needs three.js, and " + options.three_js +
                             " cannot be read: install Debian's package libjs-three, or name a "
                             "three.min.js by '--three-js'");
}

inline void check_threads(const Options& options)
{
#ifndef CGAL_LINKED_WITH_TBB
  if (options.threads > 1)
    throw std::runtime_error("this program was built without TBB: it has one thread only");
#endif
  if (options.threads > 1 && options.traits != "default")
    throw std::runtime_error("'--threads' needs the default traits");
  if (options.threads > 1 && options.stats)
    throw std::runtime_error("'--stats' counts what one thread does: it excludes '--threads'");
}

// Reads the command line. Prints --help and --version, and then returns nothing.
// Throws std::exception with one clear line.
inline std::optional<Options> parse_command_line(int argc, char* argv[])
{
  namespace po = boost::program_options;
  Options options;
  long long seed = options.seed, repetitions = options.repetitions, threads = options.threads;

  po::options_description all; // help.txt explains them
  all.add_options()("output,o", po::value(&options.output))("from", po::value(&options.from))(
      "to", po::value(&options.to))("inside", po::bool_switch(&options.inside))(
      "mark-inside", po::bool_switch(&options.mark_inside))(
      "traits", po::value(&options.traits)->default_value("default"))("seed", po::value(&seed))(
      "compare", po::bool_switch(&options.compare))("repetitions", po::value(&repetitions))(
      "threads", po::value(&threads))("stats", po::bool_switch(&options.stats))("help,h", "")(
      "version", "")("view", po::value(&options.view))("three-js", po::value(&options.three_js))(
      "input", po::value(&options.input));
  all.add_options()("weights", po::bool_switch(&options.weights));
  options.add_to(all);
  po::variables_map given = read_command_line(argc, argv, all, 1);

  if (given.count("help") != 0) {
    std::cout << help_text;
    return std::nullopt;
  }
  if (given.count("version") != 0) {
    std::cout << "delaunay_from_surface " DELAUNAY_FROM_SURFACE_3_VERSION " (CGAL " CGAL_VERSION_STR
                 ")\n";
    return std::nullopt;
  }
  po::notify(given);

  options.from = input_format(options);
  check_traits(options);
  for (const std::string name : {"output", "view"})
    if (given.count(name) != 0 && given[name].as<std::string>().empty())
      throw std::runtime_error("option '--" + name + "' needs the name of a file");
  if (!options.compare && given.count("repetitions") != 0)
    throw std::runtime_error("option '--repetitions' needs '--compare'");
  options.seed = checked_number("seed", seed, 0);
  options.repetitions = checked_number("repetitions", repetitions, 1);
  options.threads = checked_number("threads", threads, 1, most_threads);
  check_threads(options);
  check_output(options);
  if (!options.output.empty())
    options.to = output_format(options);
  check_output(options);
  check_weights(options);
  if (options.view.empty() && given.count("three-js") != 0)
    throw std::runtime_error("option '--three-js' needs '--view'");
  check_view(options);
  return options;
}

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_DEMO_OPTIONS_H
