#!/usr/bin/env bash
# Called by conda-build in the unpacked source: PYTHON is that of the package.
set -euo pipefail

"$PYTHON" -m pip install ./python -vv --no-deps --no-build-isolation --no-index
