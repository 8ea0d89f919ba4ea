// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_IN_FILES_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_IN_FILES_H

// An engine out of core: the state of a round is in a folder, and what is to be done at a time are
// tasks, one for a range of the input or a tile. A task reads files and writes others, the same
// whenever it is done; so it may be killed at any moment and done again, by any process. When all
// tasks of a stage are done, the stage is closed by one more file.
//
// In memory there is one tile for each thread: it is made again from the points that it keeps when
// its turn comes.

#include <CGAL/Delaunay_from_surface_3/support/Thread_executor.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Delaunay_3_tile.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Stage_progress.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_certificate.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_folder.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tile_source_3.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_options.h>
#include <CGAL/Delaunay_from_surface_3/tiles/Tiles_stages.h>
#include <CGAL/Delaunay_from_surface_3/tiles/run_tasks.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <system_error>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace internal {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

class Tiles_in_files
{
public:
  explicit Tiles_in_files(const std::filesystem::path& folder, std::size_t number_of_threads = 1)
    : m_executor(number_of_threads)
    , m_stages(folder / "state")
  {
  }

  // Begins, or goes on where the folder's state is.
  void begin(const Tile_source_3& source, const Tiles_options& options)
  {
    m_progress = options.progress;
    m_stages.begin(source, options, m_executor.number_of_workers());
    if (m_stages.stage() == Tiles_stages::DONE) // it may have been killed before it had cleaned
      m_stages.clean();
    while (m_stages.stage() < Tiles_stages::ROUND)
      do_stage();
  }

  std::uint64_t number_of_points() const { return m_stages.input().points; }
  std::uint32_t number_of_tiles() const { return m_stages.input().tiles; }
  std::size_t rounds() const { return m_stages.rounds(); }
  std::uint64_t told() const { return m_stages.told(); }

  std::uint64_t exchange()
  {
    if (m_stages.stage() != Tiles_stages::ROUND)
      return 0;
    const std::uint64_t before = told();
    do_stage();
    return told() - before;
  }

  // The seed was drawn when the last round was closed.
  std::vector<Tile_certificate> gather(std::uint64_t)
  {
    if (m_stages.stage() == Tiles_stages::PIECES)
      do_stage();
    return m_stages.certificates();
  }

  std::vector<Tile_certificate> certificates() const { return m_stages.certificates(); }

  void show(const Tile_pairs& pairs) { m_stages.show(pairs); }

  // What tile t has; and that nobody will ask for it again.
  Delaunay_3_tile tile(std::uint32_t t) const { return m_stages.folder().read_piece(t); }
  template <class Sink>
  void give(Sink& sink) const
  {
    for (std::uint32_t t = 0; t < number_of_tiles(); ++t)
      sink(tile(t));
  }
  void drop_tile(std::uint32_t t) const
  {
    std::error_code ignored;
    std::filesystem::remove(m_stages.folder().file("piece", t), ignored);
  }

  // Removes all that there is.
  void forget() { m_stages.forget(); }

  template <class F>
  void together(const F& f) const
  {
    f();
  }

  // For who does tasks one by one: the stage, its tasks, and its closing.
  Tiles_stages& stages() { return m_stages; }

private:
  void do_stage()
  {
    const std::size_t n = m_stages.number_of_tasks();
    const Stage_progress progress(m_progress, m_stages.name(), n);
    run_tasks(m_executor, n, [&](std::size_t k) {
      m_stages.do_task(k, threads_of_task(k, n, m_executor.number_of_workers()));
      progress.tell_next();
    });
    m_stages.close();
  }

  Thread_executor m_executor;
  Tiles_stages m_stages;
  Stage_progress::Function m_progress;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace internal
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_TILES_TILES_IN_FILES_H
