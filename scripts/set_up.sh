#!/usr/bin/env bash
# Installs the Debian packages that are missing (as root or through sudo). Sourced by the other scripts.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

packages=(
  g++ cmake ninja-build
  libcgal-dev libeigen3-dev libboost-dev               # the library
  libboost-program-options-dev nlohmann-json3-dev      # the command
  libpng-dev libtinyexr-dev libtinygltf-dev            # its pictures and textured files
  libjs-three                                          # its page
  libcgal-demo                                         # real meshes
)
# what only some scripts need is named by them
packages+=("${extra_packages[@]}")

missing=()
for package in "${packages[@]}"; do
  dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
done
if [ ${#missing[@]} -gt 0 ]; then
  echo "installing ${missing[*]}" >&2
  as_root=()
  [ "$(id -u)" -eq 0 ] || as_root=(sudo)
  "${as_root[@]}" apt-get update -qq >&2
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >&2
fi
