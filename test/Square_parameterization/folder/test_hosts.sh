#!/usr/bin/env bash
# map_folder.sh --hosts and brute_force_on_many.sh --hosts by ssh, on two addresses of the loopback interface that stand
# for two machines: test_hosts.sh [SQUARE_MAP [MESHES]]. As root, with openssh-server; a server of its own on a private port,
# with keys of its own, is started and ended.
. "$(dirname "${BASH_SOURCE[0]}")/set_up_server_test.sh"
if [ "$(id -u)" -ne 0 ] || [ ! -x /usr/sbin/sshd ]; then
  echo "skipped: it takes root and openssh-server"
  exit 77
fi

folder=$(mktemp -d)
finish() {
  [ ! -f "$folder/sshd.pid" ] || kill "$(cat "$folder/sshd.pid")"
  rm -rf "$folder"
}
trap finish EXIT
port=$(python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])')
ssh-keygen -q -t ed25519 -N '' -f "$folder/host_key"
ssh-keygen -q -t ed25519 -N '' -f "$folder/key"
cp "$folder/key.pub" "$folder/authorized_keys"
mkdir -p /run/sshd
/usr/sbin/sshd -f /dev/null -o ListenAddress=127.0.0.1:"$port" -o ListenAddress=127.0.0.2:"$port" -o UsePAM=no \
  -o HostKey="$folder/host_key" -o AuthorizedKeysFile="$folder/authorized_keys" -o StrictModes=no \
  -o PasswordAuthentication=no -o PidFile="$folder/sshd.pid" -o PermitRootLogin=prohibit-password \
  -o MaxStartups=100 -o MaxSessions=100 -o LogLevel=ERROR
ssh="ssh -p $port -i $folder/key -o StrictHostKeyChecking=no -o UserKnownHostsFile=/dev/null -o LogLevel=ERROR"
printf '# two machines\n%s root@127.0.0.1\n%s root@127.0.0.2\n' "$ssh" "$ssh" > "$folder/hosts"

mkdir -p "$folder/in/a b"
cp "$meshes"/{nefertiti,patch-01,open_cube,hand,tetrahedron}.off "$folder/in"
cp "$meshes/open_cube.off" "$folder/in/a b/it's"$'\n'"\"{}\" \$(x).off"
cp "$meshes/cube_quad.off" "$folder/in/-quads.off"
status=0
"$repository/scripts/map_folder.sh" "$folder/in" "$folder/out here" || status=$?
[ $status -eq 1 ] # quads are refused
status=0
"$repository/scripts/map_folder.sh" "$folder/in" "$folder/out there" --hosts "$folder/hosts" || status=$?
[ $status -eq 1 ]
diff -r -x .map_folder -x summary.csv "$folder/out here" "$folder/out there"
for host in 127.0.0.1 127.0.0.2; do
  echo "jobs on $host: $(grep -c "root@$host" "$folder/out there/.map_folder/joblog")"
  grep -q "root@$host" "$folder/out there/.map_folder/joblog"
done

cd "$folder"
"$SQUARE_MAP" "$meshes/mushroom.off" --strategy brute-force -o here.obj --svg here.svg
"$repository/scripts/brute_force_on_many.sh" "$meshes/mushroom.off" work --hosts hosts -o there.obj --svg there.svg
cmp here.obj there.obj
cmp here.svg there.svg
grep -q root@127.0.0.1 work/.map_folder/joblog && grep -q root@127.0.0.2 work/.map_folder/joblog

# a machine that cannot be reached: one call that fails, and says so
printf '%s root@127.0.0.3\n' "$ssh" > nowhere
status=0
"$repository/scripts/map_folder.sh" in "out nowhere" --hosts nowhere 2> messages || status=$?
[ $status -eq 2 ] && grep -q 'map_folder.sh: each machine must see' messages
echo "hosts: passed"
