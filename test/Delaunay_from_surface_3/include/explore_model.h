// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_EXPLORE_MODEL_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_EXPLORE_MODEL_H

// All executions of a few workers (insertion_model.h) over a memory (memory_models.h).

#include "insertion_model.h"
#include "memory_models.h"
#include "model_programs.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

namespace model {

// --- the end -----------------------------------------------------------------------------------

// One thread alone.
struct Alone
{
  std::vector<Byte>& memory;

  Byte load(Location l, Order) { return memory[l]; }
  void store(Location l, Byte value, Order) { memory[l] = value; }
  void fence(Order) {}
  void takes(unsigned, Byte, Byte) {}
  void makes(unsigned, Byte, Byte) {}
  void commits(unsigned, unsigned) {}
  void has_written() {}
};

// Compact_complex::is_in_cell().
inline bool is_in_cell(const Layout& at, const Protocol& protocol, const std::vector<Byte>& memory,
                       Byte v)
{
  const unsigned c = memory[at.cell_of(v)];
  return (memory[at.v(c, 0)] & busy) == 0 &&
         (!protocol.looks_for_vertex || memory[at.v(c, 0)] == v || memory[at.v(c, 1)] == v);
}

// Says what is wrong with the cells, if anything: they must make the lower hull of the vertices,
// their neighbours lead back, and is_in_cell() tell which vertices they have.
inline std::string what_is_wrong(const Case& c, const Protocol& protocol,
                                 const std::vector<Byte>& memory, const std::set<Byte>& vertices)
{
  const Layout at(c);
  std::set<std::pair<Byte, Byte>> cells, expected;
  unsigned lower_ends = 0;
  for (unsigned k = 0; k < c.number_of_cells(); ++k) {
    for (unsigned w = 0; w < c.number_of_workers(); ++w)
      if (memory[at.mark(k, w)] != 0)
        return "a mark is left set";
    const Byte v[2] = {memory[at.v(k, 0)], memory[at.v(k, 1)]};
    if ((v[0] & busy) != 0)
      continue;
    if (!cells.insert(std::minmax({v[0], v[1]})).second)
      return "a cell is there twice";
    for (unsigned i = 0; i < 2; ++i) {
      const Byte there = memory[at.neighbor(k, i)];
      if (there == encode(k, i)) {
        ++lower_ends;
        continue;
      }
      if ((memory[at.v(there / 2, 0)] & busy) != 0)
        return "a neighbour is dead";
      if (memory[at.neighbor(there / 2, there % 2)] != encode(k, i))
        return "a neighbour does not lead back";
      if (memory[at.v(there / 2, 1 - there % 2)] != v[1 - i])
        return "a neighbour does not share the facet";
    }
  }
  for (const Byte a : vertices)
    for (const Byte b : vertices)
      if (c.points[a - 1u].x < c.points[b - 1u].x &&
          std::none_of(vertices.begin(), vertices.end(),
                       [&](Byte p) { return p != a && p != b && c.is_below(p, a, b); }))
        expected.insert(std::minmax(a, b));
  if (cells != expected || lower_ends != 2)
    return "wrong cells";
  for (const Byte v : vertices) {
    const bool is_hidden = std::none_of(cells.begin(), cells.end(), [&](const auto& cell) {
      return cell.first == v || cell.second == v;
    });
    if (is_in_cell(at, protocol, memory, v) == is_hidden)
      return "is_in_cell() is wrong about a vertex";
  }
  return "";
}

// --- exploration -------------------------------------------------------------------------------

struct Outcome
{
  std::string error; // the first one found
  std::size_t states = 0, ends = 0;
  std::size_t most_clashes = 0; // at an end
};

template <class Memory>
class Exploration
{
  using Kind = Operation::Kind;

  struct State
  {
    Memory memory;
    std::array<std::uint32_t, max_threads> nodes{};
    std::array<Byte, 16 * 12> made{}; // the second vertex of each cell under each word
    std::string committed; // workers that are writing stars, in the order in which they began to

    std::string key() const
    {
      std::string s;
      memory.append_to(s);
      s.append(reinterpret_cast<const char*>(&nodes), sizeof(nodes));
      s.append(made.begin(), made.end());
      return s + committed;
    }
    Byte& second_vertex(unsigned cell, unsigned word) { return made[16 * cell + word]; }
  };

public:
  Exploration(const Case& c, const Protocol& protocol)
    : m_case(c)
    , m_protocol(protocol)
  {
    for (unsigned t = 0; t < c.number_of_workers(); ++t)
      m_programs.emplace_back(c, protocol, t);
  }

  Outcome operator()()
  {
    State first{Memory(initial_memory(m_case)), {}, {}, {}};
    for (unsigned k = 0; k + 1 < m_case.chain; ++k)
      first.second_vertex(k, k + 1) = Byte(k + 2);
    reach(std::move(first));
    while (!m_open.empty() && m_outcome.error.empty()) {
      const State state = std::move(m_open.back());
      m_open.pop_back();
      if (!expand(state))
        finish(state);
    }
    return m_outcome;
  }

private:
  // Takes the steps that commute with all others at once.
  void reach(State&& state)
  {
    for (unsigned t = 0; t < m_programs.size(); ++t)
      while (m_outcome.error.empty() && is_quiet(state, t))
        take(state, t, 0);
    if (m_outcome.error.empty() && m_known.insert(std::hash<std::string>()(state.key())).second) {
      ++m_outcome.states;
      m_open.push_back(std::move(state));
    }
  }

  bool is_quiet(const State& state, unsigned t) const
  {
    const Operation& o = m_programs[t].node(state.nodes[t]).operation;
    switch (o.kind) {
    case Kind::LOAD:
    case Kind::END:
      return false;
    case Kind::STORE:
      return Memory::stores_commute;
    case Kind::FENCE:
      return o.order != Order::FULL;
    default:
      return true;
    }
  }

  // Returns whether there was any step.
  bool expand(const State& state)
  {
    bool any = false;
    for (unsigned t = 0; t < m_programs.size(); ++t) {
      const Operation& o = m_programs[t].node(state.nodes[t]).operation;
      if (state.memory.has_pending(t)) {
        State next = state;
        next.memory.drain(t);
        reach(std::move(next));
        any = true;
      }
      if (o.kind == Kind::END || (o.kind == Kind::FENCE && !state.memory.can_fence(t)))
        continue;
      any = true;
      const unsigned choices = o.kind == Kind::LOAD ? state.memory.choices(t, o.a) : 1;
      for (unsigned choice = 0; choice < choices; ++choice) {
        State next = state;
        take(next, t, choice);
        reach(std::move(next));
      }
    }
    return any;
  }

  void take(State& state, unsigned t, unsigned choice)
  {
    const Operation o = m_programs[t].node(state.nodes[t]).operation;
    Byte value = 0;
    switch (o.kind) {
    case Kind::LOAD:
      value = state.memory.load(t, o.a, choice, o.order);
      break;
    case Kind::STORE:
      check_store(state, t, o.a);
      state.memory.store(t, o.a, Byte(o.b), o.order);
      break;
    case Kind::FENCE:
      state.memory.fence(t, o.order);
      break;
    case Kind::TAKES:
      if (state.second_vertex(o.a, o.b) != o.c)
        m_outcome.error = "a torn cell is taken as a whole";
      break;
    case Kind::MAKES:
      state.second_vertex(o.a, o.b) = Byte(o.c);
      break;
    default:
      commit(state, t, o.a, o.b);
    }
    state.nodes[t] = m_programs[t].after(state.nodes[t], value);
    if (m_programs[t].node(state.nodes[t]).zone == 0)
      state.committed.erase(std::remove(state.committed.begin(), state.committed.end(), char(t)),
                            state.committed.end());
  }

  // Does an insertion that writes rely on this word of a cell? Of what is beside its zone the
  // vertices count, not the neighbours.
  static bool relies_on(unsigned zone, unsigned beside, unsigned cell, unsigned k)
  {
    return (k < 4 && (zone >> cell & 1) != 0) || (k < 2 && (beside >> cell & 1) != 0);
  }

  // A worker is going to write. Does it know the newest of all that it relies on?
  void commit(State& state, unsigned t, unsigned zone, unsigned beside)
  {
    const Layout at(m_case);
    for (unsigned c = 0; c < m_case.number_of_cells(); ++c)
      for (unsigned k = 0; k < 4; ++k)
        if (relies_on(zone, beside, c, k) && !state.memory.is_newest(t, at.v(c, 0) + k))
          m_outcome.error = "written from what is no more true";
    state.committed += char(t);
  }

  // Nobody changes what one relies on who has begun to write later. And whoever stores the cell of
  // a vertex knows of the one before: so the last one is the newest.
  void check_store(const State& state, unsigned t, Location l)
  {
    if (l >= Layout(m_case).cell_of(1) && !state.memory.is_newest(t, l))
      m_outcome.error = "two give a vertex a cell, and do not know of each other";
    const unsigned size = 4 + m_case.number_of_workers();
    const std::size_t own = state.committed.find(char(t));
    for (std::size_t i = own; i < state.committed.size(); ++i)
      if (const auto& later =
              m_programs[Byte(state.committed[i])].node(state.nodes[Byte(state.committed[i])]);
          i > own && relies_on(later.zone, later.beside, l / size, l % size))
        m_outcome.error = "two write at once, one of them from what is no more true";
  }

  // The caller inserts alone what clashed; then all must be right.
  void finish(const State& state)
  {
    ++m_outcome.ends;
    std::vector<Byte> memory(initial_memory(m_case).size());
    for (Location l = 0; l < memory.size(); ++l)
      memory[l] = state.memory.value(l);
    std::set<Byte> vertices;
    for (Byte v = 1; v <= m_case.chain; ++v)
      vertices.insert(v);
    std::vector<Byte> free_cells; // it could have fresh ones too
    std::vector<Task> put_off;
    for (unsigned t = 0; t < m_programs.size(); ++t) {
      const Worker_state& worker = m_programs[t].state(state.nodes[t]);
      free_cells.insert(free_cells.end(), worker.free_cells.begin(), worker.free_cells.end());
      const std::vector<Byte>& clashed = worker.clashed;
      for (Byte k = 0; k < m_case.tasks[t].size(); ++k)
        if (std::count(clashed.begin(), clashed.end(), k) != 0)
          put_off.push_back(m_case.tasks[t][k]);
        else
          vertices.insert(m_case.tasks[t][k].vertex);
    }
    m_outcome.most_clashes = (std::max)(m_outcome.most_clashes, put_off.size());
    m_outcome.error = what_is_wrong(m_case, m_protocol, memory, vertices);
    for (std::size_t k = 0; k < put_off.size() && m_outcome.error.empty(); ++k) {
      Alone alone{memory};
      Worker<Alone> worker(m_case, m_protocol, alone, 0, free_cells);
      vertices.insert(put_off[k].vertex);
      m_outcome.error =
          worker.insert(put_off[k].vertex, put_off[k].start, m_case.number_of_cells(), 99)
              ? what_is_wrong(m_case, m_protocol, memory, vertices)
              : "no end: an insertion clashes with nobody";
    }
  }

  const Case& m_case;
  const Protocol& m_protocol;
  std::vector<Program_tree> m_programs;
  std::vector<State> m_open;
  std::unordered_set<std::size_t>
      m_known; // hashes: two of some millions agree by chance once in 10^6 runs
  Outcome m_outcome;
};

} // namespace model

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_EXPLORE_MODEL_H
