#!/usr/bin/env bash
# Installs what is missing, builds square_map and the manual, and makes the packages build/package/cgal-ext*.deb and .tar.gz
# of them and of the library.
set -euo pipefail
extra_packages=(doxygen libjs-mathjax python3 dpkg-dev file)
. "$(dirname "${BASH_SOURCE[0]}")/set_up.sh"

cmake --preset package
cmake --build --preset package
cd build/package
cpack
