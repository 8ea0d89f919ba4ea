// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_EXECUTOR_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_EXECUTOR_H

#include <CGAL/Delaunay_from_surface_3/support/Rounding_to_nearest.h>
#include <CGAL/Delaunay_from_surface_3/support/form.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE {

// A function that an executor runs; it must not throw.
class Task
{
public:
  virtual void operator()(std::size_t t) const = 0;

protected:
  ~Task() = default;
};

// Runs tasks by one thread or many: the threads of TBB, or any others that the caller has.
class Executor
{
public:
  virtual ~Executor() = default;

  // Returns at least 1, and always the same number.
  virtual std::size_t number_of_workers() const = 0;

  // Calls task(0) in the thread that calls this, and task(1), …, task(number - 1) at the same time,
  // or later, anywhere. Returns when all have returned, or throws.
  virtual void run(std::size_t number, const Task& task) const = 0;

  // Is called now and then by long tasks. An exception that it throws stops them.
  virtual void interruption_point() const {}
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_INTERFACE

inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

// Runs all tasks in the caller's thread.
class Alone final : public Executor
{
public:
  std::size_t number_of_workers() const override { return 1; }

  void run(std::size_t number, const Task& task) const override
  {
    for (std::size_t t = 0; t < number; ++t)
      task(t);
  }
};

// Returns into how many blocks of `least` or more an executor cuts n things.
inline std::size_t number_of_blocks(const Executor& executor, std::size_t n, std::size_t least)
{
  return (std::max)(std::size_t(1), (std::min)(executor.number_of_workers(), n / least));
}

// Runs a body as a task, rounding to nearest, and counts its calls.
template <class Body>
class Counted_task final : public Task
{
public:
  explicit Counted_task(const Body& body)
    : m_body(body)
  {
  }

  void operator()(std::size_t t) const override
  {
    const Rounding_to_nearest rounding;
    m_body(t);
    m_calls.fetch_add(1, std::memory_order_relaxed); // the executor joins the threads
  }

  std::size_t calls() const { return m_calls; }

private:
  const Body& m_body;
  mutable std::atomic<std::size_t> m_calls{0};
};

// Calls body(0), …, body(n-1), which must not throw; throws if a call was left out.
template <class Body>
void call_each(const Executor& executor, std::size_t n, const Body& body)
{
  const Counted_task<Body> task(body);
  executor.run(n, task);
  if (task.calls() != n)
    throw std::logic_error("of " + std::to_string(n) + " tasks " + std::to_string(task.calls()) +
                           " were executed");
}

// Returns how many of n things a block has; the last blocks may have fewer.
inline std::size_t size_of_block(std::size_t n, std::size_t blocks)
{
  return (n + blocks - 1) / blocks;
}

// Does what for_each_block() does, for bodies of all types: its code is there once.
inline void for_each_block_of_any(const Executor& executor, std::size_t n, std::size_t blocks,
                                  void (*call)(const void*, std::size_t, std::size_t, std::size_t),
                                  const void* body)
{
  std::vector<std::exception_ptr> errors(blocks);
  call_each(executor, blocks, [&](std::size_t b) {
    try {
      const std::size_t size = size_of_block(n, blocks);
      call(body, (std::min)(n, b * size), (std::min)(n, (b + 1) * size), b);
    } catch (...) {
      errors[b] = std::current_exception();
    }
  });
  for (const std::exception_ptr& error : errors)
    if (error)
      std::rethrow_exception(error);
}

// Calls body(first, last, block) for so many blocks of 0, …, n-1, which may be empty. When all are
// done, throws the exception of the first block that has thrown.
template <class Body>
void for_each_block(const Executor& executor, std::size_t n, std::size_t blocks, const Body& body)
{
  const auto call = [](const void* any, std::size_t first, std::size_t last, std::size_t b) {
    (*static_cast<const Body*>(any))(first, last, b);
  };
  for_each_block_of_any(executor, n, blocks, call, &body);
}

// Counts the steps of a long loop, and calls the executor's interruption_point() now and then.
class Steps
{
public:
  // Keeps a reference.
  explicit Steps(const Executor& executor)
    : m_executor(executor)
  {
  }

  void operator()(std::size_t number = 1)
  {
    if ((m_number += number) >= 1 << 14) {
      m_number = 0;
      m_executor.interruption_point();
    }
  }

private:
  const Executor& m_executor;
  std::size_t m_number = 0;
};

// Returns whether is_right(i) holds for i = 0, …, n-1.
template <class Predicate>
bool holds_for_all(const Executor& executor, std::size_t n, const Predicate& is_right)
{
  const std::size_t blocks = number_of_blocks(executor, n, 4096);
  std::vector<char> is_wrong(blocks, 0);
  for_each_block(executor, n, blocks, [&](std::size_t first, std::size_t last, std::size_t b) {
    Steps step(executor);
    for (std::size_t i = first; i < last && !is_wrong[b]; ++i, step())
      is_wrong[b] = char(!is_right(i));
  });
  return std::find(is_wrong.begin(), is_wrong.end(), 1) == is_wrong.end();
}

// Returns the items with result[k] = items[order[k]].
template <class T>
std::vector<T> permuted(const std::vector<T>& items, const std::vector<std::size_t>& order,
                        const Executor& executor = Alone())
{
  std::vector<T> result;
  if constexpr (std::is_default_constructible<T>::value) {
    const std::size_t blocks = number_of_blocks(executor, order.size(), 4096);
    if (blocks > 1) {
      result.resize(order.size());
      for_each_block(executor, order.size(), blocks,
                     [&](std::size_t first, std::size_t last, std::size_t) {
                       for (std::size_t k = first; k < last; ++k)
                         result[k] = items[order[k]];
                     });
      return result;
    }
  }
  result.reserve(order.size());
  for (const std::size_t i : order)
    result.push_back(items[i]);
  return result;
}

// Returns the permutation with result[order[k]] = k.
inline std::vector<std::size_t> inverse(const std::size_t* order, std::size_t n)
{
  std::vector<std::size_t> result(n);
  for (std::size_t k = 0; k < n; ++k)
    result[order[k]] = k;
  return result;
}
inline std::vector<std::size_t> inverse(const std::vector<std::size_t>& order)
{
  return inverse(order.data(), order.size());
}

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_EXECUTOR_H
