#!/usr/bin/env bash
# scripts/map_folder.slurm in Slurm's own daemons, which are started for it on this machine, with a configuration, ports and
# a key of their own, and ended: test_slurm.sh [SQUARE_MAP [MESHES]]. As root, with slurmctld, slurmd, slurm-client and munge.
. "$(dirname "${BASH_SOURCE[0]}")/set_up_server_test.sh"
missing=$(for program in slurmctld slurmd sbatch munged; do command -v $program > /dev/null || echo $program; done)
if [ "$(id -u)" -ne 0 ] || [ -n "$missing" ]; then
  echo "skipped: it takes root, slurmctld, slurmd, slurm-client and munge"
  exit 77
fi

folder=$(mktemp -d)
chmod 711 "$folder"
finish() {
  for name in slurmd slurmctld munged; do
    [ ! -f "$folder/$name.pid" ] || kill "$(cat "$folder/$name.pid")" 2> /dev/null || true
  done
  sleep 1
  rm -rf "$folder"
}
trap finish EXIT
free_port() {
  python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'
}
head -c 128 /dev/urandom > "$folder/munge.key"
chmod 600 "$folder/munge.key"
munged --force --key-file="$folder/munge.key" --socket="$folder/munge.socket" --pid-file="$folder/munged.pid" \
  --log-file="$folder/munged.log" --seed-file="$folder/munge.seed"
name=$(hostname -s)
export SLURM_CONF=$folder/slurm.conf
cat > "$SLURM_CONF" << END
ClusterName=folder
SlurmctldHost=$name(127.0.0.1)
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
SlurmUser=root
SlurmdUser=root
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
NodeName=$name NodeAddr=127.0.0.1 CPUs=$(nproc)
PartitionName=all Nodes=$name Default=YES State=UP
END
mkdir "$folder/state" "$folder/spool"
slurmctld
slurmd
for _ in $(seq 60); do
  [ "$(sinfo -h -o %t 2> /dev/null)" != idle ] || break
  sleep 0.5
done
sinfo

mkdir -p "$folder/in/a b"
cp "$meshes"/{nefertiti,patch-01,open_cube,hand,tetrahedron}.off "$folder/in"
cp "$meshes/open_cube.off" "$folder/in/a b/it's \"{}\" \$(x).off"
status=0
"$repository/scripts/map_folder.sh" "$folder/in" "$folder/out here" || status=$?
[ $status -eq 0 ]
cd "$repository"
sbatch --wait --array=1-3 --cpus-per-task=1 --output="$folder/task-%a.out" scripts/map_folder.slurm "$folder/in" "$folder/out there"
cat "$folder"/task-*.out
diff -r -x .map_folder -x summary.csv "$folder/out here" "$folder/out there"
[ "$(grep -c '^1' "$folder/out there/.map_folder/joblog")" -eq 3 ] # each task began with a first job
for out in "$folder/out here" "$folder/out there"; do
  python3 -c 'import csv, sys
for row in csv.DictReader(open(sys.argv[1])): print({k: v for k, v in row.items() if k not in ("seconds", "memory_mib")})' \
    "$out/summary.csv" > "$out/table"
done
cmp "$folder/out here/table" "$folder/out there/table"
echo "slurm: passed"
