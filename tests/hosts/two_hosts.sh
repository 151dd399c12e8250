#!/usr/bin/env bash
# Lets processes on two hosts share a run, and compares its files with those of one process. The hosts are network namespaces of this
# machine, joined by a virtual cable; Open MPI reaches them through TCP and a launcher in place of ssh. Needs root, iproute2, Open MPI.
#
#   tests/hosts/two_hosts.sh target/release/demeter        built with --features mpi
set -euo pipefail
demeter=$(realpath "$1")
place=$(mktemp -d)
one=demeter-one other=demeter-other
clean() {
    ip netns del "$one" 2>/dev/null || true
    ip netns del "$other" 2>/dev/null || true
    rm -rf "$place"
}
trap clean EXIT

ip netns add "$one"
ip netns add "$other"
ip link add cable-one netns "$one" type veth peer name cable-other netns "$other"
ip -n "$one" addr add 10.213.77.1/24 dev cable-one
ip -n "$other" addr add 10.213.77.2/24 dev cable-other
for host in "$one cable-one" "$other cable-other"; do
    read -r name cable <<<"$host"
    ip -n "$name" link set lo up
    ip -n "$name" link set "$cable" up
done

# what Open MPI calls like ssh: HOST COMMAND...
cat >"$place/launcher" <<END
#!/bin/sh
case "\$1" in
    10.213.77.1) host=$one ;;
    *) host=$other ;;
esac
shift
exec ip netns exec "\$host" sh -c "\$*"
END
chmod +x "$place/launcher"

scenario=$(realpath "$(dirname "$0")/../../crates/demeter/tests/engine/shared_runs/mixer.toml")
cd "$place"
run=(run "$scenario" --set 'stage.mix.duration="0.2 ms"' --threads 1)
"$demeter" "${run[@]}" --out alone >/dev/null 2>&1
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
ip netns exec "$one" mpirun --host 10.213.77.1:2,10.213.77.2:2 -n 4 --oversubscribe \
    --mca plm_rsh_agent "$place/launcher" --mca pml ob1 --mca btl self,tcp --mca btl_tcp_if_include 10.213.77.0/24 \
    --mca oob_tcp_if_include 10.213.77.0/24 --mca mpi_yield_when_idle 1 \
    "$demeter" "${run[@]}" --out shared
passed=$(ip netns exec "$one" cat /sys/class/net/cable-one/statistics/tx_bytes)
echo "$passed bytes went from one host to the other"
if [ "$passed" -lt 1000000 ]; then
    echo "error: the processes on the two hosts said nothing to each other" >&2
    exit 1
fi
cmp alone/series.csv shared/series.csv
for frame in alone/frames/*; do
    cmp "$frame" "shared/frames/${frame##*/}"
done
echo "four processes on two hosts wrote the files of one process"
