// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_PAGE_ARRAY_H
#define CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_PAGE_ARRAY_H

#include <CGAL/Delaunay_from_surface_3/support/form.h>
#include <CGAL/Delaunay_from_surface_3/support/shared_words.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <ctime>
#include <limits>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace CGAL {
namespace Delaunay_from_surface_3 {
namespace core {
inline namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM {

constexpr std::size_t large_page = std::size_t(1) << 21;
constexpr std::size_t small_pages = std::size_t(1) << 18; // bytes that are taken at once

// Returns whether an array of so many bytes begins at a large page. Smaller ones lie in the heap
// like other memory, whose pages the next call finds again, without page faults.
constexpr bool begins_at_large_page(std::size_t bytes)
{
  return bytes >= 16 * large_page;
}

// Small pages have 64 kB at most, nearly everywhere.
constexpr std::size_t rounded_to_small_pages(std::size_t bytes)
{
  constexpr std::size_t page = std::size_t(1) << 16;
  return (bytes + page - 1) / page * page;
}

// To be called before the bytes of [begin, end) are written for the first time: takes their small
// pages from the system at once. A page fault for each costs much more. The system may refuse, as
// Linux before 5.14 does, which is no error. If the last page is there, the others are taken to be
// there, too.
inline void take_pages([[maybe_unused]] void* begin, [[maybe_unused]] void* end)
{
#if defined(__linux__)
  constexpr int populate_write = 23; // which headers of the system name only since 2022
  static const std::uintptr_t page = std::uintptr_t(sysconf(_SC_PAGESIZE)), least = 8 * page;
  const std::uintptr_t first = reinterpret_cast<std::uintptr_t>(begin) / page * page;
  const std::uintptr_t last = reinterpret_cast<std::uintptr_t>(end) / page * page;
  unsigned char is_there = 0;
  if (last >= first + least &&
      (mincore(reinterpret_cast<void*>(last - page), page, &is_there) != 0 || is_there == 0))
    madvise(reinterpret_cast<void*>(first), last - first, populate_write);
#endif
}

// Takes pages for what others are about to allocate in smaller pieces: gives them to glibc's heap,
// which keeps them. If that maps the first of the allocations apart, its threshold for that grows when
// it is given back, untouched, so that the others come from the heap, both at the same address. If
// the user has fixed the threshold, they are mapped apart as well, and begin two words behind a page.
inline void take_pages_for_heap([[maybe_unused]] std::size_t bytes)
{
#if defined(__GLIBC__)
  if (bytes < large_page)
    return;
  std::uintptr_t last = 0;
  for (unsigned k = 0; k < 3; ++k) {
    char* const memory = static_cast<char*>(::operator new(bytes, std::nothrow));
    const auto address = reinterpret_cast<std::uintptr_t>(memory);
    if (k == 2 && address != 0 && address == last && address % 4096 != 2 * sizeof(std::size_t))
      take_pages(memory, memory + bytes);
    last = address;
    ::operator delete(memory);
  }
#endif
}

// The processor time of this thread, so that on a busy machine the turns of others do not count.
struct Thread_clock
{
  static std::chrono::nanoseconds now()
  {
#if defined(__linux__)
    timespec t;
    if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t) == 0)
      return std::chrono::seconds(t.tv_sec) + std::chrono::nanoseconds(t.tv_nsec);
#endif
    return std::chrono::nanoseconds(0);
  }
};

// Large pages for the memory of one array, as long as they are cheap: the first touch of one is one
// page fault instead of 512.
//
// If a host takes free memory back from a virtual machine, it takes large pages and leaves small
// ones. To get one again costs as much as eight or ten in small pages. So each page is advised and
// touched just before it is used, and timed; the first that is dear is the last. Each array finds
// out for itself, since a page that was dear a moment ago may be cheap now, and no state has to
// outlive the array: it loses one page at most. Arrays that are too small to gain as much take no
// large pages.
class Large_pages
{
public:
  Large_pages() = default;
  explicit Large_pages(std::size_t bytes)
    : m_end(begins_at_large_page(bytes) ? bytes / large_page * large_page : 0)
  {
  }

  // To be called before the bytes first, …, last - 1 of the array, which begins at a large page,
  // are written for the first time. Several threads may call it, each for bytes of its own.
  template <class Clock = Thread_clock>
  void touch(void* array, std::size_t first, std::size_t last)
  {
    std::size_t at = (first + large_page - 1) / large_page * large_page;
    for (; at < last && at < load_relaxed(m_end); at += large_page)
      if (!is_cheap<Clock>(static_cast<char*>(array) + at))
        store_relaxed(m_end, std::size_t(0));
  }

  // Bytes before this end are in large pages, if the system has any, once they have been touched.
  std::size_t end() const { return load_relaxed(m_end); }

private:
  // Advice may be ignored, which is no error. A page at hand takes a tenth of a millisecond, any
  // other about five.
  template <class Clock>
  static bool is_cheap(char* page)
  {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    const auto before = Clock::now();
    madvise(page, large_page, MADV_HUGEPAGE);
    *static_cast<volatile char*>(page) = 0;
    return Clock::now() - before < std::chrono::milliseconds(1);
#else
    (void)page;
    return false;
#endif
  }

  std::size_t m_end = 0;
};

// Returns memory that begins at a large page: in Linux apart from the heap, which would keep the
// advice.
inline void* allocate_at_large_page(std::size_t bytes)
{
#if defined(__linux__)
  const std::size_t size = rounded_to_small_pages(bytes), all = size + large_page;
  void* const mapped =
      all < bytes ? MAP_FAILED
                  : mmap(nullptr, all, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapped == MAP_FAILED)
    throw std::bad_alloc();
  char* const begin = static_cast<char*>(mapped);
  const std::size_t before = (0 - reinterpret_cast<std::uintptr_t>(mapped)) % large_page;
  if (before != 0)
    munmap(begin, before);
  munmap(begin + before + size, large_page - before);
  return begin + before;
#else
  return ::operator new(bytes, std::align_val_t(large_page));
#endif
}

inline void deallocate_at_large_page(void* memory, [[maybe_unused]] std::size_t bytes)
{
#if defined(__linux__)
  munmap(memory, rounded_to_small_pages(bytes));
#else
  ::operator delete(memory, std::align_val_t(large_page));
#endif
}

// Memory for large arrays that live for a short time and are filled at once, in large pages if the
// system has them at hand.
template <class T>
struct Large_page_allocator
{
  using value_type = T;

  Large_page_allocator() = default;
  template <class U>
  Large_page_allocator(const Large_page_allocator<U>&)
  {
  }

  T* allocate(std::size_t n)
  {
    T* const data = allocate_untouched(n);
    Large_pages(n * sizeof(T)).touch(data, 0, n * sizeof(T));
    take_pages(data, data + n);
    return data;
  }

  // For callers that touch the memory little by little.
  T* allocate_untouched(std::size_t n)
  {
    if (n > (std::numeric_limits<std::size_t>::max)() / sizeof(T))
      throw std::bad_alloc();
    const std::size_t bytes = n * sizeof(T);
    return static_cast<T*>(begins_at_large_page(bytes) ? allocate_at_large_page(bytes)
                                                       : ::operator new(bytes, cache_line));
  }

  void deallocate(T* data, std::size_t n)
  {
    if (begins_at_large_page(n * sizeof(T)))
      deallocate_at_large_page(data, n * sizeof(T));
    else
      ::operator delete(data, cache_line);
  }

  friend bool operator==(const Large_page_allocator&, const Large_page_allocator&) { return true; }
  friend bool operator!=(const Large_page_allocator&, const Large_page_allocator&) { return false; }

private:
  static constexpr std::align_val_t cache_line = std::align_val_t(64);
};

template <class T>
using Large_vector = std::vector<T, Large_page_allocator<T>>;

// A growing array of trivial elements, made for hundreds of megabytes: its memory is not cleared
// first, parts that are never written take none, and parts can be given back while others are still
// read. Elements up to capacity() may be written; there is no size to keep.
template <class T>
class Page_array
{
  static_assert(std::is_trivially_copyable<T>::value, "elements are moved as bytes");

public:
  Page_array() = default;
  Page_array(const Page_array&) = delete;
  Page_array& operator=(const Page_array&) = delete;
  ~Page_array() { deallocate(); }

  // Takes the memory of another array, even of a larger type if its objects consist of such
  // elements.
  template <class U>
  explicit Page_array(Page_array<U>&& other)
  {
    static_assert(sizeof(U) % sizeof(T) == 0, "elements fill those of the other");
    m_capacity = std::exchange(other.m_capacity, 0) * (sizeof(U) / sizeof(T));
    m_data = reinterpret_cast<T*>(std::exchange(other.m_data, nullptr));
    m_pages = std::exchange(other.m_pages, Large_pages());
  }
  // Takes memory that another array has given away.
  Page_array(T* data, std::size_t capacity)
    : m_data(data)
    , m_capacity(capacity)
  {
  }
  T* give_away()
  {
    m_capacity = 0;
    m_pages = Large_pages();
    return std::exchange(m_data, nullptr);
  }

  Page_array(Page_array&& other) noexcept { swap(other); }
  Page_array& operator=(Page_array&& other) noexcept
  {
    Page_array(std::move(other)).swap(*this);
    return *this;
  }

  void swap(Page_array& other) noexcept
  {
    std::swap(m_data, other.m_data);
    std::swap(m_capacity, other.m_capacity);
    std::swap(m_pages, other.m_pages);
  }

  T* data() { return m_data; }
  const T* data() const { return m_data; }
  T& operator[](std::size_t i) { return m_data[i]; }
  const T& operator[](std::size_t i) const { return m_data[i]; }
  std::size_t capacity() const { return m_capacity; }

  // Makes room for at least n elements and keeps the first `used`. Before others are written,
  // touch() must be called.
  void reserve(std::size_t n, std::size_t used)
  {
    if (n <= m_capacity)
      return;
    Page_array larger;
    larger.m_data = Large_page_allocator<T>().allocate_untouched(n);
    larger.m_capacity = n;
    larger.m_pages = Large_pages(n * sizeof(T));
    for (std::size_t i = 0; i < used;) { // parts that were moved do not take memory twice
      const std::size_t end = (std::min)(used, larger.end_of(large_page, i));
      larger.touch(i, end);
      std::memcpy(static_cast<void*>(larger.m_data + i), m_data + i, (end - i) * sizeof(T));
      if (begins_at_large_page(n * sizeof(T)))
        release(i - (std::min)(i, 2 * (end - i)), end); // pieces are not always whole pages
      i = end;
    }
    larger.swap(*this);
  }

  // Makes room for n elements, all of which are written next.
  void allocate(std::size_t n)
  {
    deallocate();
    reserve(n, 0);
    touch(0, n);
  }

  // To be called before the elements first, …, last - 1 are written for the first time. Several
  // threads may call it, each for elements of its own.
  void touch(std::size_t first, std::size_t last)
  {
    m_pages.touch(m_data, first * sizeof(T), last * sizeof(T));
    take_pages(m_data + first, m_data + last);
  }

  // Returns the first element after those whose pages are taken together with that of element i, or
  // the end of the array.
  std::size_t end_of_pages(std::size_t i) const
  {
    return end_of(m_pages.end() != 0 ? large_page : small_pages, i);
  }

  // To be called when the elements first, …, last - 1 are not read any more. Whole pages go back to
  // the system; they are large if the array may have large ones, which would be torn otherwise.
  // Small pages have 64 kB at most, nearly everywhere; if they have more, the system may refuse.
  void release(std::size_t first, std::size_t last)
  {
#if defined(__linux__)
    const std::uintptr_t page =
        begins_at_large_page(m_capacity * sizeof(T)) ? large_page : std::uintptr_t(1) << 16;
    const auto address = reinterpret_cast<std::uintptr_t>(m_data);
    const std::uintptr_t begin = (address + first * sizeof(T) + page - 1) / page * page;
    const std::uintptr_t end = (address + last * sizeof(T)) / page * page;
    if (begin < end)
      madvise(reinterpret_cast<char*>(m_data) + (begin - address), end - begin, MADV_DONTNEED);
#else
    (void)first, (void)last;
#endif
  }

  // Does the same for an array that ends soon: small arrays leave their pages to the heap.
  void release_before_end(std::size_t first, std::size_t last)
  {
    if (begins_at_large_page(m_capacity * sizeof(T)))
      release(first, last);
  }

  void deallocate()
  {
    if (m_data != nullptr)
      Large_page_allocator<T>().deallocate(m_data, m_capacity);
    m_data = nullptr;
    m_capacity = 0;
    m_pages = Large_pages();
  }

private:
  template <class U>
  friend class Page_array;

  std::size_t end_of(std::size_t bytes, std::size_t i) const
  {
    const std::size_t size = bytes / sizeof(T);
    return (std::min)(m_capacity, i / size * size + size);
  }

  T* m_data = nullptr;
  std::size_t m_capacity = 0;
  Large_pages m_pages;
};

} // namespace CGAL_DELAUNAY_FROM_SURFACE_3_FORM
} // namespace core
} // namespace Delaunay_from_surface_3
} // namespace CGAL

#endif // CGAL_DELAUNAY_FROM_SURFACE_3_SUPPORT_PAGE_ARRAY_H
