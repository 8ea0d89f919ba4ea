// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DELAUNAY_FROM_SURFACE_3_TESTS_MEMORY_MODELS_H
#define DELAUNAY_FROM_SURFACE_3_TESTS_MEMORY_MODELS_H

// Three memories that a few threads share, small enough to be explored exhaustively
// (explore_model.h).
//
// Each has
//   choices(t, l)             how many values thread t might load from location l now
//   load(t, l, choice, order) one of them
//   store(t, l, value, order)
//   can_fence(t), fence(t, order)
//   has_pending(t), drain(t)  stores of t that others do not see yet; lets them see the oldest
//   is_newest(t, l)           whether what t may still load from l is what was stored last by anybody
//   value(l)                  when nothing is pending
//   append_to(key)            its state
// and stores_commute: a store of one thread, done now or after any step of another, leads to the
// same states, so that orders of stores need not be tried.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace model {

using Byte = std::uint8_t;
using Location = unsigned;
constexpr unsigned max_threads = 3, max_locations = 80;

enum class Order { RELAXED, ACQUIRE, RELEASE, FULL };

// All steps in one sequence.
class Sequential_consistency
{
public:
  static constexpr const char* name = "sequential consistency";
  static constexpr bool stores_commute = false;

  explicit Sequential_consistency(const std::vector<Byte>& initial)
  {
    std::copy(initial.begin(), initial.end(), m_values.begin());
  }

  unsigned choices(unsigned, Location) const { return 1; }
  Byte load(unsigned, Location l, unsigned, Order) { return m_values[l]; }
  void store(unsigned, Location l, Byte value, Order) { m_values[l] = value; }
  bool can_fence(unsigned) const { return true; }
  void fence(unsigned, Order) {}
  bool has_pending(unsigned) const { return false; }
  void drain(unsigned) {}
  bool is_newest(unsigned, Location) const { return true; }
  Byte value(Location l) const { return m_values[l]; }
  void append_to(std::string& key) const { key.append(m_values.begin(), m_values.end()); }

private:
  std::array<Byte, max_locations> m_values{};
};

// x86: each thread has a queue of its stores, from which it loads first, and which a full fence
// waits for (Owens, Sarkar, Sewell 2009).
class Total_store_order
{
public:
  static constexpr const char* name = "total store order";
  static constexpr bool stores_commute = true; // into the thread's own queue

  explicit Total_store_order(const std::vector<Byte>& initial)
  {
    std::copy(initial.begin(), initial.end(), m_values.begin());
  }

  unsigned choices(unsigned, Location) const { return 1; }
  Byte load(unsigned t, Location l, unsigned, Order) const
  {
    const std::string& queue = m_queues[t];
    for (std::size_t k = queue.size(); k > 0; k -= 2)
      if (Byte(queue[k - 2]) == l)
        return Byte(queue[k - 1]);
    return m_values[l];
  }
  void store(unsigned t, Location l, Byte value, Order)
  {
    m_queues[t] += char(l);
    m_queues[t] += char(value);
  }
  bool can_fence(unsigned t) const { return m_queues[t].empty(); }
  void fence(unsigned, Order) {}
  bool has_pending(unsigned t) const { return !m_queues[t].empty(); }
  void drain(unsigned t)
  {
    m_values[Byte(m_queues[t][0])] = Byte(m_queues[t][1]);
    m_queues[t].erase(0, 2);
  }
  bool is_newest(unsigned t, Location l) const
  {
    for (unsigned other = 0; other < max_threads; ++other)
      for (std::size_t k = 0; k < m_queues[other].size(); k += 2)
        if (other != t && Byte(m_queues[other][k]) == l)
          return false;
    return true;
  }
  Byte value(Location l) const { return m_values[l]; }
  void append_to(std::string& key) const
  {
    key.append(m_values.begin(), m_values.end());
    for (const std::string& queue : m_queues) {
      key += char(queue.size());
      key += queue;
    }
  }

private:
  std::array<Byte, max_locations> m_values{};
  std::array<std::string, max_threads> m_queues; // location, value, location, value, …
};

// Strings by numbers: equal ones have the same.
class Interned_strings
{
public:
  std::uint32_t operator()(const std::string& s)
  {
    const auto [entry, is_new] = m_numbers.emplace(s, std::uint32_t(m_strings.size()));
    if (is_new)
      m_strings.push_back(&entry->first);
    return entry->second;
  }
  const std::string& operator[](std::uint32_t number) const { return *m_strings[number]; }

private:
  std::unordered_map<std::string, std::uint32_t> m_numbers;
  std::vector<const std::string*> m_strings;
};

// C++20's relaxed, acquire and release accesses and fences, by views (as the promising semantics of
// Kang, Hur, Lahav, Vafeiadis, Dreyer 2017, without its promises): a location keeps all that was
// ever stored there; a thread's view says from which store on it may load; who loads with acquire
// what was stored with release takes over the view that went with it. (Until C++17, and on ARM,
// later stores of the same thread to that location release as well; not here.)
//
// Not in it: that a store takes place before a load that comes before it in its thread. The stores
// that matter come after a full fence, or depend on what was loaded. And a store always comes after
// all that are there: two threads that store to one location without knowing of each other are an
// error, which is_newest() tells.
class Views
{
public:
  static constexpr const char* name = "relaxed, acquire, release";
  static constexpr bool stores_commute = true; // who loads may still load what was there before

  explicit Views(const std::vector<Byte>& initial)
  {
    interned() = Interned_strings();
    const std::string nothing(max_locations, '\0');
    m_full = interned()(nothing);
    m_threads.fill({m_full, m_full, m_full});
    for (Location l = 0; l < initial.size(); ++l)
      m_stores[l] = interned()(Stored{initial[l], m_full}.text());
  }

  unsigned choices(unsigned t, Location l) const
  {
    return number_of_stores(l) - oldest(m_threads[t].now, l);
  }
  Byte load(unsigned t, Location l, unsigned choice, Order order)
  {
    Thread& thread = m_threads[t];
    const unsigned k = oldest(thread.now, l) + choice;
    const Stored stored(interned()[m_stores[l]], k);
    thread.now = with(thread.now, l, k);
    thread.after_acquire_fence = join(thread.after_acquire_fence, join(thread.now, stored.view));
    if (order == Order::ACQUIRE)
      thread.now = join(thread.now, stored.view);
    return stored.value;
  }
  void store(unsigned t, Location l, Byte value, Order order)
  {
    Thread& thread = m_threads[t];
    const unsigned k = number_of_stores(l);
    thread.now = with(thread.now, l, k);
    thread.after_acquire_fence = join(thread.after_acquire_fence, thread.now);
    const std::uint32_t view =
        with(order == Order::RELEASE ? thread.now : thread.at_release_fence, l, k);
    m_stores[l] = interned()(std::string(interned()[m_stores[l]]) + Stored{value, view}.text());
  }
  bool can_fence(unsigned) const { return true; }
  void fence(unsigned t, Order order)
  {
    Thread& thread = m_threads[t];
    if (order != Order::RELEASE)
      thread.now = thread.after_acquire_fence;
    if (order == Order::FULL)
      m_full = thread.now = thread.after_acquire_fence = join(m_full, thread.now);
    if (order != Order::ACQUIRE)
      thread.at_release_fence = thread.now;
  }
  bool has_pending(unsigned) const { return false; }
  void drain(unsigned) {}
  bool is_newest(unsigned t, Location l) const { return choices(t, l) == 1; }
  Byte value(Location l) const
  {
    return Stored(interned()[m_stores[l]], number_of_stores(l) - 1).value;
  }
  void append_to(std::string& key) const
  {
    const auto append = [&key](const auto& object) {
      key.append(reinterpret_cast<const char*>(&object), sizeof(object));
    };
    append(m_stores);
    append(m_threads);
    append(m_full);
  }

private:
  // What was stored, and the view that goes with it.
  struct Stored
  {
    Byte value;
    std::uint32_t view;

    static constexpr std::size_t size = 5;
    Stored(Byte v, std::uint32_t w)
      : value(v)
      , view(w)
    {
    }
    Stored(const std::string& all, unsigned k)
      : value(Byte(all[k * size]))
      , view(0)
    {
      for (unsigned b = 0; b < 4; ++b)
        view |= std::uint32_t(Byte(all[k * size + 1 + b])) << 8 * b;
    }
    std::string text() const
    {
      std::string s{char(value)};
      for (unsigned b = 0; b < 4; ++b)
        s += char(view >> 8 * b);
      return s;
    }
  };

  struct Thread
  {
    std::uint32_t now, after_acquire_fence, at_release_fence; // views
  };

  static Interned_strings& interned()
  {
    static Interned_strings strings;
    return strings;
  }
  static unsigned oldest(std::uint32_t view, Location l) { return Byte(interned()[view][l]); }
  static std::uint32_t with(std::uint32_t view, Location l, unsigned k)
  {
    if (oldest(view, l) >= k)
      return view;
    std::string copy = interned()[view];
    copy[l] = char(k);
    return interned()(copy);
  }
  static std::uint32_t join(std::uint32_t a, std::uint32_t b)
  {
    if (a == b)
      return a;
    std::string copy = interned()[a];
    const std::string& other = interned()[b];
    for (Location l = 0; l < max_locations; ++l)
      copy[l] = char((std::max)(Byte(copy[l]), Byte(other[l])));
    return interned()(copy);
  }
  unsigned number_of_stores(Location l) const
  {
    return unsigned(interned()[m_stores[l]].size() / Stored::size);
  }

  std::array<std::uint32_t, max_locations> m_stores{};
  std::array<Thread, max_threads> m_threads;
  std::uint32_t m_full; // view of the last full fence
};

} // namespace model

#endif // DELAUNAY_FROM_SURFACE_3_TESTS_MEMORY_MODELS_H
