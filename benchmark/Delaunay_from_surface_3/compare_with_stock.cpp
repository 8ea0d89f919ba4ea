// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Builds the Delaunay triangulations of surfaces by CGAL's own range insertion and by the ways of
// this package, alternating in one process, and writes what was measured as JSON.

#include <Delaunay_from_surface_3_comparison/machine.h>
#include <Delaunay_from_surface_3_comparison/measure.h>
#include <Delaunay_from_surface_3_comparison/methods.h>
#include <Delaunay_from_surface_3_comparison/surfaces.h>

#include <boost/program_options.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace comparison;
namespace po = boost::program_options;

const char* const introduction =
    R"(Compares ways to build the Delaunay triangulation of a surface's vertices with CGAL's own
insert(first, last): times, phases, predicate calls, and whether the results are equal.

  compare_with_stock --data-dir meshes --output results.json
  compare_with_stock --surfaces genus-3 sphere --sizes 16384 65536 --methods stock tracing default

Every repetition runs all methods, each time beginning with another one. Phases and predicate calls
come from runs of their own, since to measure them takes time.

Options)";

struct Options
{
  std::vector<std::string> surfaces, methods;
  std::vector<std::size_t> sizes;
  std::size_t repetitions = 3, largest_compared = 300000;
  std::string output = "compare_with_stock.json", data_dir;
  std::uint64_t seed = 0;
  std::string command;
};

po::options_description describe(Options& o)
{
  po::options_description options(introduction);
  auto add = options.add_options();
  add("help,h", "say this and stop");
  add("list", "list surfaces and methods and stop");
  add("surfaces", po::value(&o.surfaces)->multitoken()->value_name("NAME..."), "default: all");
  add("sizes", po::value(&o.sizes)->multitoken()->value_name("N..."),
      "numbers of points; default: 16384 65536 262144 1048576. A surface skips those it is too "
      "detailed for.");
  add("methods", po::value(&o.methods)->multitoken()->value_name("NAME..."),
      "default: all; stock always runs");
  add("repetitions,r", po::value(&o.repetitions)->value_name("N")->default_value(o.repetitions),
      "how often every time is measured");
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

// The items with the given names, in their order; all without names.
template <class Item>
std::vector<Item> chosen(const std::vector<Item>& all, const std::vector<std::string>& names,
                         const std::string& what)
{
  if (names.empty())
    return all;
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

// The first method is stock, whatever was chosen.
std::vector<Method> chosen_methods(std::vector<std::string> names)
{
  const std::vector<Method> all = all_methods();
  names.erase(std::remove(names.begin(), names.end(), all.front().name), names.end());
  if (!names.empty())
    names.insert(names.begin(), all.front().name);
  return chosen(all, names, "method");
}

void list()
{
  for (const Named_surface& surface : named_surfaces(""))
    std::cout << "surface " << std::left << std::setw(20) << surface.name << surface.description
              << '\n';
  for (const Method& method : all_methods())
    std::cout << "method  " << std::left << std::setw(20) << method.name << method.description
              << '\n';
}

// Alternating repetitions; the r-th begins with the r-th method, so that none always comes first.
std::vector<std::vector<Time>> time_methods(const std::vector<Method>& methods, const Mesh& mesh,
                                            const Options& options, std::vector<Json>& results)
{
  const auto seed = static_cast<unsigned int>(options.seed);
  Triangulation stock;
  insert_stock(stock, mesh); // warms up, and is what the others must equal
  const bool compare_all = mesh.number_of_vertices() <= options.largest_compared;

  std::vector<std::vector<Time>> times(methods.size());
  for (std::size_t r = 0; r < options.repetitions; ++r)
    for (std::size_t k = 0; k < methods.size(); ++k) {
      const std::size_t m = (r + k) % methods.size();
      Triangulation tr;
      times[m].push_back(time_of([&] { methods[m].build(tr, mesh, seed); }));
      if (r > 0) // the same seed makes the same triangulation every time
        continue;
      results[m]["equal"] = compare_all ? tr == stock : have_same_counts(tr, stock);
      results[m]["equal_checked_by"] =
          compare_all ? "==" : "numbers of vertices, cells, finite cells, facets and edges";
    }
  return times;
}

Json compare_on(const Mesh& mesh, const std::vector<Method>& methods, const Options& options)
{
  const auto seed = static_cast<unsigned int>(options.seed);
  std::vector<Json> results(methods.size());
  const auto times = time_methods(methods, mesh, options, results);
  const double stock = times_as_json(times.front())["median_cpu"];
  for (std::size_t m = 0; m < methods.size(); ++m) {
    Json result = {{"method", methods[m].name}};
    result.update(times_as_json(times[m]));
    result["ratio_stock_to_method"] = rounded(stock / double(result["median_cpu"]), 1e4);
    result.update(results[m]);
    if (methods[m].time_phases)
      result["phases"] = phases_of(methods[m], mesh, seed);
    result["predicates"] = counts_of(methods[m], mesh, seed);
    std::cerr << "  " << std::left << std::setw(20) << methods[m].name << std::right << std::fixed
              << std::setprecision(3) << std::setw(9) << double(result["median_cpu"]) << " s  "
              << std::setw(6) << double(result["ratio_stock_to_method"]) << " x  "
              << (result["equal"] ? "equal" : "DIFFERENT") << '\n';
    results[m] = std::move(result);
  }
  return results;
}

Json description_of(const std::vector<Method>& methods, const Options& options)
{
  Json names = Json::object();
  for (const Method& method : methods)
    names[method.name] = method.description;
  return {{"program", "compare_with_stock"},
          {"command", options.command},
          {"machine", describe_machine(DELAUNAY_FROM_SURFACE_3_COMPILER_FLAGS)},
          {"load_average_at_start", rounded(load_average(), 100)},
          {"repetitions", options.repetitions},
          {"methods", names}};
}

void write(const Json& report, const std::string& file_name)
{
  std::ofstream file(file_name);
  file << report.dump(1) << '\n';
  if (!file.flush())
    throw std::runtime_error("cannot write '" + file_name + "'");
}

// Returns whether all triangulations were equal to stock's.
bool run(const Options& options)
{
  const std::vector<Method> methods = chosen_methods(options.methods);
  const auto surfaces = chosen(named_surfaces(options.data_dir), options.surfaces, "surface");
  Json report = description_of(methods, options);
  report["results"] = Json::array();
  bool all_equal = true;
  for (const Named_surface& surface : surfaces)
    for (const std::size_t size : options.sizes) {
      if (size < surface.least_size)
        continue;
      const Mesh mesh = surfaces::to_mesh<Mesh>(surface.make(size, options.seed));
      std::cerr << surface.name << ", " << mesh.number_of_vertices() << " points\n";
      Json result = {{"surface", surface.name},
                     {"description", surface.description},
                     {"size", size},
                     {"points", mesh.number_of_vertices()},
                     {"faces", mesh.number_of_faces()}};
      result["methods"] = compare_on(mesh, methods, options);
      for (const Json& method : result["methods"])
        all_equal = all_equal && bool(method["equal"]);
      report["results"].push_back(std::move(result));
      report["load_average_at_end"] = rounded(load_average(), 100);
      write(report, options.output); // what is measured is kept, should the rest be interrupted
    }
  return all_equal;
}

} // namespace

int main(int argc, char** argv)
{
  try {
    Options options;
    const po::options_description description = describe(options);
    po::variables_map given;
    // An empty positional description: a stray word is an error.
    po::store(po::command_line_parser(argc, argv).options(description).positional({}).run(), given);
    po::notify(given);
    if (options.sizes.empty())
      options.sizes = {16384, 65536, 262144, 1048576};
    options.command = "compare_with_stock";
    for (int i = 1; i < argc; ++i)
      options.command += std::string(" ") + argv[i];
    if (options.repetitions == 0)
      throw std::invalid_argument("--repetitions must be at least 1");
    if (given.count("help"))
      std::cout << description;
    else if (given.count("list"))
      list();
    else if (!run(options))
      throw std::runtime_error("a triangulation differs from CGAL's");
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::cerr << "compare_with_stock: " << error.what() << '\n';
  }
  return EXIT_FAILURE;
}
