// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_MODEL_PROGRAMS_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_MODEL_PROGRAMS_H

// What a worker does next depends only on where it began and on the values it has loaded since. So
// its program is run again from there, fed with those values, until it asks for one more; that is
// kept in a tree, whose nodes are all that a state of the exploration has to know about a worker.

#include "insertion_model.h"
#include "memory_models.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace model {

struct Operation
{
  enum Kind { LOAD, STORE, FENCE, TAKES, MAKES, COMMITS, END } kind = END;
  Order order = Order::RELAXED;
  unsigned a = 0, b = 0, c = 0; // location, value; or what is said to the checker
};

// Runs until an operation whose value is not known yet.
class Replay
{
public:
  struct Pause
  {
  };

  explicit Replay(const std::vector<Byte>& values)
    : m_values(values)
  {
  }

  Byte load(Location l, Order order) { return step({Operation::LOAD, order, l, 0, 0}); }
  void store(Location l, Byte value, Order order) { step({Operation::STORE, order, l, value, 0}); }
  void fence(Order order) { step({Operation::FENCE, order, 0, 0, 0}); }
  void takes(unsigned c, Byte word, Byte v1)
  {
    step({Operation::TAKES, Order::RELAXED, c, word, v1});
  }
  void makes(unsigned c, Byte word, Byte v1)
  {
    step({Operation::MAKES, Order::RELAXED, c, word, v1});
  }
  void commits(unsigned zone, unsigned beside)
  {
    m_zone = zone;
    m_beside = beside;
    step({Operation::COMMITS, Order::RELAXED, zone, beside, 0});
  }
  void has_written() { m_zone = m_beside = 0; }

  Operation operation() const { return m_operation; }
  unsigned zone() const { return m_zone; } // being written
  unsigned beside() const { return m_beside; }

private:
  Byte step(const Operation& operation)
  {
    if (m_at < m_values.size())
      return m_values[m_at++];
    m_operation = operation;
    throw Pause();
  }

  const std::vector<Byte>& m_values;
  std::size_t m_at = 0;
  Operation m_operation;
  unsigned m_zone = 0, m_beside = 0;
};

class Program_tree
{
public:
  struct Node
  {
    std::size_t state;        // in which the worker began its attempt
    std::vector<Byte> values; // of all operations since
    Operation operation;
    unsigned zone, beside; // of a star being written
    std::map<Byte, std::uint32_t> next;
  };

  Program_tree(const Case& c, const Protocol& protocol, unsigned number)
    : m_case(c)
    , m_protocol(protocol)
    , m_number(number)
  {
    Worker_state first;
    for (std::size_t k = 0; k < c.tasks[number].size(); ++k)
      first.tasks_left.push_back(Byte(k));
    for (unsigned k = 0; k < c.fresh_cells; ++k)
      first.free_cells.push_back(Byte(c.chain - 1 + number * c.fresh_cells + k));
    root_of(first); // is node 0
  }

  const Node& node(std::uint32_t n) const { return m_nodes[n]; }
  const Worker_state& state(std::uint32_t n) const { return m_states[m_nodes[n].state]; }

  // After the node's operation, which has returned `value`.
  std::uint32_t after(std::uint32_t n, Byte value)
  {
    const auto found = m_nodes[n].next.find(value);
    if (found != m_nodes[n].next.end())
      return found->second;
    std::vector<Byte> values = m_nodes[n].values;
    values.push_back(value);
    const std::uint32_t next = add(m_nodes[n].state, std::move(values));
    m_nodes[n].next[value] = next;
    return next;
  }

private:
  std::uint32_t root_of(const Worker_state& state)
  {
    const auto [entry, is_new] = m_roots.emplace(state.key(), 0);
    if (is_new) {
      m_states.push_back(state);
      const std::uint32_t root = add(m_states.size() - 1, {});
      m_roots[state.key()] = root;
      return root;
    }
    return entry->second;
  }

  std::uint32_t add(std::size_t first, std::vector<Byte> values)
  {
    Worker_state state = m_states[first];
    Replay replay(values);
    try {
      attempt(state, replay);
    } catch (Replay::Pause) {
      m_nodes.push_back({first, values, replay.operation(), replay.zone(), replay.beside(), {}});
      return std::uint32_t(m_nodes.size() - 1);
    }
    if (!state.tasks_left.empty())
      return root_of(state);
    m_states.push_back(state);
    m_nodes.push_back({m_states.size() - 1, {}, Operation(), 0, 0, {}});
    return std::uint32_t(m_nodes.size() - 1);
  }

  // As Parallel_triangulation::work(), but what clashed is tried only once more at the end.
  void attempt(Worker_state& state, Replay& replay) const
  {
    const Byte k = state.tasks_left.front();
    const Task task = m_case.tasks[m_number][k];
    Worker<Replay> worker(m_case, m_protocol, replay, m_number, state.free_cells);
    if (!worker.insert(task.vertex, task.start, m_case.chain - 1))
      state.clashed.push_back(k);
    state.tasks_left.erase(state.tasks_left.begin());
    if (state.tasks_left.empty() && m_case.tries_again && !state.is_second_try) {
      state.tasks_left.swap(state.clashed);
      state.is_second_try = true;
    }
  }

  const Case& m_case;
  const Protocol& m_protocol;
  const unsigned m_number;
  std::vector<Node> m_nodes;
  std::vector<Worker_state> m_states;
  std::map<std::string, std::uint32_t> m_roots;
};

} // namespace model

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_MODEL_PROGRAMS_H
