#!/usr/bin/env bash
# Does what docs/tasks/many-machines.md says, on a Slurm of one node: the job file of that page, with its number of parts
# and its names alone exchanged, for a scene of a million pairs. One part is killed and run again; the parts in order must
# be the bytes of one run. Installs Slurm where that is possible, else says so and ends well. It needs
# root. --no-build takes the Release build of the demo that is there.
set -euo pipefail
cd "$(dirname "$0")/../.."
export DOTNET_CLI_TELEMETRY_OPTOUT=1 DOTNET_NOLOGO=1
parts=8 killed=5 bodies=1415

skip() {
  echo "skipped: $1"
  exit 0
}

install_slurm() {
  command -v apt-get > /dev/null || return 1
  apt-get install -y --no-install-recommends slurm-wlm munge > /dev/null 2>&1 && return 0
  apt-get update > /dev/null 2>&1 && apt-get install -y --no-install-recommends slurm-wlm munge > /dev/null 2>&1
}

[ "$(id -u)" = 0 ] || skip "Slurm's daemons are started by root here"
has_slurm() { command -v slurmctld slurmd sbatch munged > /dev/null; }
has_slurm || { install_slurm && has_slurm; } || skip "Slurm is not installed and cannot be installed here"

work=$(mktemp -d)
pids=()
# Ends what was started here, and nothing else.
finish() {
  for file in "$work"/*.pid; do [ ! -f "$file" ] || pids+=("$(cat "$file")"); done
  [ ${#pids[@]} -eq 0 ] || kill "${pids[@]}" 2> /dev/null || true
  sleep 1
  rm -rf "$work"
}
trap finish EXIT
fail() {
  echo "slurm: $1"
  tail -n 20 "$work"/*.log "$work"/jobs/slurm-*.out 2> /dev/null || true
  echo "0 passed, 1 failed"
  exit 1
}

[ "${1:-}" = --no-build ] || dotnet build -c Release -v quiet --nologo src/Gjk.Demo
mkdir "$work/bin" "$work/jobs" "$work/spool" "$work/state"
printf '#!/bin/sh\nexec dotnet "%s" "$@"\n' "$PWD/src/Gjk.Demo/bin/Release/net10.0/gjk-demo.dll" > "$work/bin/gjk-demo"
chmod +x "$work/bin/gjk-demo"
export PATH=$work/bin:$PATH

# A munged of its own, with a key of its own.
head -c 128 /dev/urandom > "$work/munge.key"
chmod 400 "$work/munge.key"
munged --force --key-file="$work/munge.key" --socket="$work/munge.socket" --pid-file="$work/munged.pid" \
  --log-file="$work/munged.log" --seed-file="$work/munge.seed" || fail "munged does not start"

# The least that a node needs: no cgroups, no accounting, ports that are free on most machines.
host=$(hostname -s)
export SLURM_CONF=$work/slurm.conf
cat > "$SLURM_CONF" << CONF
ClusterName=gjk
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge.socket
CredType=cred/munge
SlurmctldPort=26817
SlurmdPort=26818
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MpiDefault=none
ReturnToService=2
KillWait=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=1024 State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONF
slurmctld -D > "$work/slurmctld.out.log" 2>&1 &
pids+=($!)
slurmd -D -N "$host" > "$work/slurmd.out.log" 2>&1 &
pids+=($!)
for _ in $(seq 60); do
  [ "$(sinfo -h -o %T 2> /dev/null)" = idle ] && break
  sleep 1
done
[ "$(sinfo -h -o %T)" = idle ] || fail "the node is not idle: $(sinfo -h -o %T 2>&1)"

# Spheres and boxes in a block; each pair of them is answered.
cd "$work/jobs"
awk -v n=$bodies 'BEGIN {
  printf "{\"version\":1,\"objects\":["
  for (i = 0; i < n; i++) {
    shape = i % 2 ? "{\"type\":\"sphere\",\"radius\":0.7}" : "{\"type\":\"box\",\"halfExtents\":[0.5,0.6,0.7]}"
    printf "%s{\"shape\":%s,\"position\":[%g,%g,%g]}", i ? "," : "", shape, i % 12 * 1.9, int(i / 12) % 12 * 1.7, int(i / 144) * 2.1
  }
  print "]}"
}' > parts.json

# The page's own job file. The node here is small, so it asks for no memory.
page=$OLDPWD/docs/tasks/many-machines.md
sed -n '/^```text job.sh$/,/^```$/p' "$page" | sed '1d;$d' \
  | sed "s/--array=1-16/--array=1-$parts/; s|/16\"|/$parts\"|; /--mem=/d" > job.sh
grep -q "array=1-$parts" job.sh && grep -q -- '--shard' job.sh || fail "the page has no such job file"

wait_for_jobs() {
  for _ in $(seq 300); do
    [ -z "$(squeue -h)" ] && return
    sleep 1
  done
  fail "jobs do not end: $(squeue -h)"
}

# One part waits, to be killed before it has done anything; a second one is killed while it runs.
job=$(sbatch --parsable job.sh) || fail "sbatch"
scancel "${job}_$parts" || fail "scancel"
for _ in $(seq 600); do
  squeue -h -t R -o %K 2> /dev/null | grep -qx $killed && break
  [ -z "$(squeue -h)" ] && break
  sleep 0.1
done
scancel --signal=KILL --full "${job}_$killed" || true
wait_for_jobs
missing=$(for k in $(seq $parts); do [ -f "part.$(printf %04d "$k").csv" ] || echo "$k"; done | paste -sd ,)
case ,$missing, in *,$parts,*) ;; *) fail "part $parts was killed and is there: missing are $missing" ;; esac
echo "killed: $missing; run again: sbatch --array=$missing job.sh"
sbatch --parsable "--array=$missing" job.sh > /dev/null || fail "sbatch again"
wait_for_jobs

gjk-demo query parts.json --out whole.csv 2> wrote.txt
lines=$(wc -l < whole.csv)
[ "$lines" -gt 1000000 ] || fail "only $lines lines"
cat part.*.csv | cmp - whole.csv || fail "the parts are not the bytes of one run"
ls part.* | wc -l | grep -qx $parts || fail "there are $(ls part.*)"
echo "$parts parts of $((lines - 1)) pairs, $missing of them run again: the same bytes as one run"
echo "1 passed, 0 failed"
