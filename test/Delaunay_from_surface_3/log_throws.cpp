// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Preloaded, writes the message of each std::exception that a program throws to the file that
// LOG_THROWS names, after the command line of the program (scripts/refusals).

#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <typeinfo>

namespace {

using Throw = void (*)(void*, std::type_info*, void (*)(void*));

const auto real_throw = reinterpret_cast<Throw>(dlsym(RTLD_NEXT, "__cxa_throw"));

// No memory is allocated: a test may have made that fail.
void log(const char* message)
{
  char line[2000] = "";
  const char* const file = std::getenv("LOG_THROWS");
  const int command = open("/proc/self/cmdline", O_RDONLY);
  const ssize_t n = command < 0 ? 0 : read(command, line, 500);
  close(command);
  for (ssize_t i = 0; i < n; ++i)
    if (line[i] == 0 || line[i] == '\n')
      line[i] = ' ';
  const int length = n + std::snprintf(line + n, sizeof(line) - std::size_t(n), "\t%s\n", message);
  const int log = file == nullptr ? -1 : open(file, O_WRONLY | O_APPEND | O_CREAT, 0666);
  if (log >= 0 && length < int(sizeof(line)) && write(log, line, std::size_t(length)) < 0)
    std::abort();
  close(log);
}

} // namespace

extern "C" void __cxa_throw(void* object, std::type_info* type, void (*destroy)(void*))
{
  void* thrown = object;
  if (typeid(std::exception).__do_catch(type, &thrown, 1))
    log(static_cast<std::exception*>(thrown)->what());
  real_throw(object, type, destroy);
  std::abort();
}
