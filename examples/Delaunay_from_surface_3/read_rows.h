// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef EXAMPLES_READ_ROWS_H
#define EXAMPLES_READ_ROWS_H

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

// Returns the number that a word is. Throws std::runtime_error if it is anything else, or not finite.
inline double number_of(const std::string& word)
{
  char* end = nullptr;
  const double number = std::strtod(word.c_str(), &end);
  if (word.empty() || *end != '\0' || !std::isfinite(number))
    throw std::runtime_error("expected a number, not '" + word + "'");
  return number;
}

// Reads n numbers from each line of a text file. Empty lines and what follows a # are left out.
// Throws std::runtime_error if a line has fewer or more words, or if there is none.
template <std::size_t n>
std::vector<std::array<double, n>> read_rows(const std::string& file_name)
{
  std::ifstream file(file_name);
  std::vector<std::array<double, n>> rows;
  std::string line;
  for (std::size_t number = 1; std::getline(file, line); ++number) {
    std::istringstream stream(line.substr(0, line.find('#')));
    std::vector<std::string> words;
    for (std::string word; stream >> word;)
      words.push_back(word);
    if (words.empty())
      continue;
    const std::string place = file_name + ": line " + std::to_string(number) + ": ";
    if (words.size() != n)
      throw std::runtime_error(place + "expected " + std::to_string(n) +
                               " numbers, as in every line");
    rows.emplace_back();
    try {
      for (std::size_t k = 0; k < n; ++k)
        rows.back()[k] = number_of(words[k]);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(place + error.what());
    }
  }
  if (rows.empty() || file.bad())
    throw std::runtime_error(file_name + ": cannot be read, or has no numbers");
  return rows;
}

#endif // EXAMPLES_READ_ROWS_H
