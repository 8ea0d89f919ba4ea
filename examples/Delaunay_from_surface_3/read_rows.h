// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef EXAMPLES_READ_ROWS_H
#define EXAMPLES_READ_ROWS_H

#include <array>
#include <cstddef>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

// Reads n numbers from each line of a text file. Empty lines and what follows a # are left out.
// Throws std::runtime_error if a line has fewer numbers or anything more.
template <std::size_t n>
std::vector<std::array<double, n>> read_rows(const std::string& file_name)
{
  std::ifstream file(file_name);
  if (!file)
    throw std::runtime_error(file_name + ": cannot be opened");
  std::vector<std::array<double, n>> rows;
  std::string line, rest;
  for (std::size_t number = 1; std::getline(file, line); ++number) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::array<double, n> row;
    if (!(words >> row[0])) {
      words.clear();
      if (!(words >> rest))
        continue;
      words.setstate(std::ios::failbit);
    }
    for (std::size_t k = 1; k < n; ++k)
      words >> row[k];
    if (!words || words >> rest)
      throw std::runtime_error(file_name + ": line " + std::to_string(number) + ": expected " +
                               std::to_string(n) + " numbers, as in every line");
    rows.push_back(row);
  }
  return rows;
}

#endif // EXAMPLES_READ_ROWS_H
