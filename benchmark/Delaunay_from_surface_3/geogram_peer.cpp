// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A peer of compare_with_plain and measure_weights: Geogram's triangulations, by one thread BDEL,
// or BPOW if the points have weights, and PDEL by more.

#include <Delaunay_from_surface_3_comparison/geogram.h>
#include <Delaunay_from_surface_3_comparison/points_file.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace {

// As Geogram wants them: the square root of what the largest weight has more, which rounds.
void replace_weights(std::vector<double>& numbers)
{
  double most = numbers[3];
  for (std::size_t i = 3; i < numbers.size(); i += 4)
    most = std::max(most, numbers[i]);
  for (std::size_t i = 3; i < numbers.size(); i += 4)
    numbers[i] = std::sqrt(most - numbers[i]);
}

} // namespace

int main(int argc, char** argv)
{
  return comparison::run_peer(
      "geogram_peer", true, argc, argv,
      [](unsigned threads, std::vector<double> numbers, bool have_weights) {
        if (have_weights)
          replace_weights(numbers);
        const GEO::coord_index_t dimension = have_weights ? 4 : 3;
        comparison::start_geogram(threads);
        GEO::Delaunay_var delaunay = GEO::Delaunay::create(dimension, threads > 1    ? "PDEL"
                                                                      : have_weights ? "BPOW"
                                                                                     : "BDEL");
        comparison::Stopwatch watch;
        delaunay->set_vertices(static_cast<GEO::index_t>(numbers.size() / dimension),
                               numbers.data());
        watch.stop();
        comparison::print_answer_of_geogram(watch, delaunay->nb_cells());
      });
}
