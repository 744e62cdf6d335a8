#!/usr/bin/env bash
# What takes too long for each change, step by step; .ci/run has what does not. Says how long each step took, and in words
# what was skipped because a tool cannot be had here. Ends with "N steps passed, N failed, N skipped".
#   long.sh              all steps: some twelve hours on two cores
#   long.sh STEP...      these alone
#   long.sh --list       their names
# GJK_FUZZ_SECONDS (3600) and GJK_MUTANTS (300) say how long fuzz runs and how many mutants are tried.
set -uo pipefail
cd "$(dirname "$0")/.."
export DOTNET_CLI_TELEMETRY_OPTOUT=1 DOTNET_NOLOGO=1

# One line a step: its name, its usual minutes on two cores, what it is.
steps='
counts      600  all tests with a hundred times the counts, and those of netstandard that the quick tier leaves out
mutants      60  a sample of changed lines, each of which a test should notice
fuzz         60  random pairs against every promise
viewer       10  the pages in Chromium and Firefox, two whole studies, pictures to look at
arm64        10  hard pairs and golden hashes on emulated 64-bit ARM
mono          5  the Unity package compiled ahead of time, and without any JIT
debug        20  the tests of a debug build, with its assertions
builds       10  the ways in which people build: one folder, artifacts, a path with spaces, one file, no network
slurm        10  the job file of docs/tasks/many-machines.md on a one-node Slurm
'
names=$(awk 'NF { print $1 }' <<< "$steps")

usage() {
  sed -n '2,8s/^# \{0,1\}//p' "tests/long.sh"
  printf '\nstep     minutes\n%s\n' "$steps" | sed '/^$/d'
}

run_step() {
  local demo=src/Gjk.Demo
  case $1 in
    counts) GJK_LONG=1 dotnet test -c Release ;;
    mutants) env -u GJK_LONG tests/Gjk.Mutation/run.sh --sample "${GJK_MUTANTS:-300}" ;;
    fuzz) dotnet run -c Release --project $demo -- fuzz --seconds "${GJK_FUZZ_SECONDS:-3600}" ;;
    viewer) GJK_LONG=1 tests/Gjk.Viewer/run.sh ;;
    arm64) tests/Gjk.Arm64/run.sh ;;
    mono) tests/Gjk.Mono/run.sh && GJK_LONG=1 tests/Gjk.Unity.Mono/run.sh ;;
    debug) dotnet test tests/Gjk.Core.Tests -c Debug -f net10.0 ;;
    builds) tests/Gjk.Package/builds.sh ;;
    slurm) tests/Gjk.Slurm/run.sh ;;
  esac
}

case ${1:-} in
  -h | --help) usage; exit 0 ;;
  --list) echo "$names"; exit 0 ;;
esac
for step in "$@"; do
  grep -qx -- "$step" <<< "$names" || { echo "long.sh: no step is named $step; --help lists them" >&2; exit 2; }
done

log=$(mktemp)
trap 'rm -f "$log"' EXIT
passed=0 failed=0 skipped=0 table=
for step in ${*:-$names}; do
  echo "== $step"
  start=$SECONDS
  run_step "$step" 2>&1 | tee "$log"
  status=${PIPESTATUS[0]}
  fate=passed
  if [ "$status" -ne 0 ]; then
    fate=failed
  elif grep -q '^skipped: ' "$log"; then
    fate=$(grep -m 1 '^skipped: ' "$log")
  fi
  case $fate in
    passed) passed=$((passed + 1)) ;;
    failed) failed=$((failed + 1)) ;;
    *) skipped=$((skipped + 1)) ;;
  esac
  table+=$(printf '%-8s %6d s  %s' "$step" $((SECONDS - start)) "$fate")$'\n'
done
printf '\n%s' "$table"
echo "$passed steps passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ]
