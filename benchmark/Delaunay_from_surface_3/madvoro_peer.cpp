// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// MadVoro for measure_tiles_peers.py. It has Voronoi cells, clipped to a box, here a little wider than
// the points, as its time grows with what is empty of the box: instead of tetrahedra the faces between two points' cells are counted, and told as
// pairs of points; and the volumes of cells beside that of the box.

#include <Delaunay_from_surface_3_comparison/mpi_peer.h>

#include <madvoro/Voronoi3D.hpp>

#include <cstddef>
#include <stdexcept>
#include <vector>

namespace {

using MadVoro::Vector3D;

// The points and, wider, the box.
struct Box
{
  comparison::Mpi_peer_point low, high;

  explicit Box(const comparison::Mpi_peer_input& input)
    : low(input.lowest)
    , high(input.highest)
  {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] -= (input.highest[i] - input.lowest[i]) / 1000;
      high[i] += (input.highest[i] - input.lowest[i]) / 1000;
    }
  }
  double volume() const { return (high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]); }
  // Not the image of a point beyond the box.
  bool contains(const Vector3D& p) const
  {
    return low[0] < p.x && p.x < high[0] && low[1] < p.y && p.y < high[1] && low[2] < p.z &&
           p.z < high[2];
  }
};

// Of a face that two ranks have each has one half.
double count_faces(const MadVoro::Voronoi3D& voronoi, const Box& box,
                   std::vector<comparison::Mpi_peer_point>& pairs)
{
  double faces = 0;
  const std::size_t own = voronoi.GetPointNo();
  for (const auto& [a, b] : voronoi.GetAllFaceNeighbors()) {
    const Vector3D p = voronoi.GetMeshPoint(a), q = voronoi.GetMeshPoint(b);
    if ((a >= own && b >= own) || !box.contains(p) || !box.contains(q))
      continue;
    faces += a < own && b < own ? 1 : .5;
    pairs.push_back({p.x, p.y, p.z});
    pairs.push_back({q.x, q.y, q.z});
  }
  return faces;
}

double volume_of_cells(const MadVoro::Voronoi3D& voronoi)
{
  double volume = 0;
  for (std::size_t i = 0; i < voronoi.GetPointNo(); ++i)
    volume += voronoi.GetVolume(i);
  return volume;
}

} // namespace

int main(int argc, char** argv)
{
  return comparison::run_mpi_peer(
      "madvoro_peer", argc, argv, [](const char* file, int tiles, const char* cells) {
        if (tiles != 1)
          throw std::runtime_error("a rank has one part");
        const auto input = comparison::read_part(file);
        std::vector<Vector3D> points;
        for (const auto& p : input.points)
          points.emplace_back(p[0], p[1], p[2]);
        const Box box(input);
        comparison::Mpi_stopwatch watch;
        MadVoro::Voronoi3D voronoi(Vector3D(box.low[0], box.low[1], box.low[2]),
                                   Vector3D(box.high[0], box.high[1], box.high[2]));
        voronoi.BuildParallel(points);
        watch.stop();
        watch.print("MadVoro " DELAUNAY_FROM_SURFACE_3_BUILT_AS);
        std::vector<comparison::Mpi_peer_point> pairs;
        comparison::print_number("faces", count_faces(voronoi, box, pairs));
        comparison::print_number("points_held", double(voronoi.GetTotalPointNumber()));
        comparison::print_number("volume_by_box", volume_of_cells(voronoi) / box.volume());
        comparison::write_corners(cells, input.rank, pairs);
      });
}
