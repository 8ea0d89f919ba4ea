// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_READ_COMMAND_LINE_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_READ_COMMAND_LINE_H

#include <boost/program_options.hpp>

#include <cstdlib>
#include <iostream>

namespace comparison {

// Sets what the options name, and returns which were given. With --help the program says them and
// ends.
inline boost::program_options::variables_map
read_command_line(int argc, char** argv, const boost::program_options::options_description& options)
{
  namespace po = boost::program_options;
  po::variables_map given;
  // An empty positional description: a stray word is an error.
  po::store(po::command_line_parser(argc, argv).options(options).positional({}).run(), given);
  po::notify(given);
  if (given.count("help") != 0) {
    std::cout << options;
    std::exit(EXIT_SUCCESS);
  }
  return given;
}

} // namespace comparison

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_COMPARISON_READ_COMMAND_LINE_H
