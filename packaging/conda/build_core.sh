#!/usr/bin/env bash
# Called by conda-build in the unpacked source: PREFIX is where to install, CMAKE_ARGS what conda's compiler says.
set -euo pipefail

# shellcheck disable=SC2086 # several words
cmake ${CMAKE_ARGS-} --preset install -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_LIBDIR=lib -DCMAKE_INSTALL_PREFIX="$PREFIX"
cmake --build --preset install
cmake --install build/install
