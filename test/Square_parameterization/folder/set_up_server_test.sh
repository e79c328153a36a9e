# What test_hosts.sh and test_slurm.sh begin with; sourced by them, with their arguments [SQUARE_MAP [MESHES]].
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
repository=$(cd "$here/../../.." && pwd)
SQUARE_MAP=$(realpath "${1:-$repository/build/bin/square_map}")
meshes=$(realpath "${2:-$repository/build/data/meshes}")
export SQUARE_MAP
