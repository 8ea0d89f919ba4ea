// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_OPTIONS_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_OPTIONS_H

// The command line of compare_with_plain.

#include <Delaunay_from_surface_3_comparison/machine.h>
#include <Delaunay_from_surface_3_comparison/methods.h>
#include <Delaunay_from_surface_3_comparison/peers.h>
#include <Delaunay_from_surface_3_comparison/read_command_line.h>
#include <Delaunay_from_surface_3_comparison/surfaces.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iomanip>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace comparison {

inline const char* const introduction =
    R"(Compares ways to build the Delaunay triangulation of a surface's vertices with CGAL's own
insert(first, last): times, phases, counts, memory, and whether the results are equal.

  compare_with_plain --data-dir meshes --output results.json
  compare_with_plain --surfaces genus-3 sphere --sizes 16384 65536 --methods plain default
  compare_with_plain --surfaces sphere --sizes 65536 --methods default --peer tetgen=./tetgen_peer

Every repetition runs all methods and peers, each time beginning with another one. Phases, counts
and memory come from runs of their own, since to measure them takes time.

Options)";

struct Options
{
  std::vector<std::string> surfaces, meshes, methods, peers;
  std::vector<std::size_t> sizes = {16384, 65536, 262144, 1048576};
  std::size_t repetitions = 3, largest_compared = 300000;
  std::string output = "compare_with_plain.json", data_dir;
  std::uint64_t seed = 0;
  bool memory = false, only_times = false;
  std::string command;
};

inline boost::program_options::options_description describe(Options& o)
{
  namespace po = boost::program_options;
  po::options_description options(introduction);
  auto add = options.add_options();
  add("help,h", "say this and stop");
  add("list", "list surfaces and methods and stop");
  add("surfaces", po::value(&o.surfaces)->multitoken()->value_name("NAME..."),
      "default: all but those in random order");
  add("mesh", po::value(&o.meshes)->multitoken()->value_name("FILE..."),
      "more surfaces, densified like the bunny and named after their files");
  add("sizes", po::value(&o.sizes)->multitoken()->value_name("N..."),
      "numbers of points; default: 16384 65536 262144 1048576. A surface skips those it is too "
      "detailed for. 0 takes those of --mesh as they are.");
  add("methods", po::value(&o.methods)->multitoken()->value_name("NAME..."),
      "default: all; plain always runs");
  add("peer", po::value(&o.peers)->composing()->value_name("NAME=COMMAND"),
      "one more method, by a program of its own; may be repeated");
  add("repetitions,r", po::value(&o.repetitions)->value_name("N")->default_value(o.repetitions),
      "how often every time is measured");
  add("memory", po::bool_switch(&o.memory),
      "measure the memory of every method as well, in a process for each");
  add("only-times", po::bool_switch(&o.only_times), "leave out phases and counts");
  add("equal-up-to",
      po::value(&o.largest_compared)->value_name("N")->default_value(o.largest_compared),
      "compare with == up to so many points, above only the numbers of cells, facets and edges");
  add("output,o", po::value(&o.output)->value_name("FILE")->default_value(o.output),
      "where the JSON goes");
  add("data-dir,d", po::value(&o.data_dir)->value_name("FOLDER"),
      "where bunny00.off and refined_elephant.off are (Debian: libcgal-demo)");
  add("seed", po::value(&o.seed)->value_name("N")->default_value(o.seed),
      "of surfaces and insertion orders");
  return options;
}

inline void list()
{
  std::cout << std::left;
  for (const Named_surface& surface : with_twins(named_surfaces("")))
    std::cout << "surface " << std::setw(24) << surface.name << surface.description << '\n';
  for (const Method& method : all_methods())
    std::cout << "method  " << std::setw(24) << method.name << method.description << '\n';
}

// Nothing when there is nothing more to do.
inline std::optional<Options> parse_command_line(int argc, char** argv)
{
  namespace po = boost::program_options;
  Options options;
  const po::options_description description = describe(options);
  const po::variables_map given = read_command_line(argc, argv, description);
  options.command = command_line("compare_with_plain", argc, argv);
  if (options.repetitions == 0)
    throw std::invalid_argument("--repetitions must be at least 1");
  if (given.count("list") == 0)
    return options;
  list();
  return std::nullopt;
}

// The items with the given names, in their order.
template <class Item>
std::vector<Item> chosen(const std::vector<Item>& all, const std::vector<std::string>& names,
                         const std::string& what)
{
  std::vector<Item> items;
  for (const std::string& name : names) {
    const auto is_it = [&name](const Item& item) { return item.name == name; };
    const auto found = std::find_if(all.begin(), all.end(), is_it);
    if (found == all.end())
      throw std::invalid_argument("there is no " + what + " '" + name + "' (--list lists them)");
    items.push_back(*found);
  }
  return items;
}

// The first method is plain CGAL, whatever was chosen.
inline std::vector<Method> chosen_methods(const Options& options)
{
  const std::vector<Method> all = all_methods();
  if (options.methods.empty())
    return all;
  std::vector<std::string> names = options.methods;
  names.erase(std::remove(names.begin(), names.end(), all.front().name), names.end());
  names.insert(names.begin(), all.front().name);
  return chosen(all, names, "method");
}

// Those named and those of --mesh; all named ones if neither is given.
inline std::vector<Named_surface> chosen_surfaces(const Options& options)
{
  std::vector<Named_surface> all = named_surfaces(options.data_dir), files;
  if (options.surfaces.empty() && options.meshes.empty())
    return all;
  for (const std::string& file : options.meshes)
    files.push_back(surface_of_file(file));
  std::vector<Named_surface> named = with_twins(all);
  const std::vector<Named_surface> twins = with_twins(files);
  named.insert(named.end(), twins.begin(), twins.end());
  std::vector<Named_surface> result = chosen(named, options.surfaces, "surface");
  for (const Named_surface& file : files) // unless they were named, or their twins were
    if (std::none_of(options.surfaces.begin(), options.surfaces.end(), [&](const std::string& s) {
          return s == file.name || s == file.name + "-shuffled";
        }))
      result.push_back(file);
  return result;
}

inline std::vector<Peer> chosen_peers(const Options& options)
{
  std::vector<Peer> peers;
  const std::vector<Method> methods = all_methods();
  for (const std::string& text : options.peers) {
    peers.push_back(parse_peer(text));
    for (const Method& method : methods)
      if (method.name == peers.back().name)
        throw std::invalid_argument("'" + method.name + "' is a method, a peer needs another name");
  }
  return peers;
}

} // namespace comparison

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_OPTIONS_H
