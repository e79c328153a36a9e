#!/usr/bin/env bash
# Installs what is missing, builds everything and runs every test.
set -euo pipefail
extra_packages=(catch2 libopenmesh-dev doxygen libjs-mathjax chromium python3 python3-pil parallel pkg-config dpkg-dev file)
. "$(dirname "${BASH_SOURCE[0]}")/set_up.sh"

cmake --preset release -DCGAL_EXT_BUILD_TESTS=ON -DCGAL_EXT_BUILD_BENCHMARKS=ON
cmake --build --preset release
ctest --preset release "$@"
