#!/usr/bin/env bash
# What takes too long for each change, step by step; .ci/run has what does not. Says how long each step took, and in words
# what was skipped because a tool cannot be had here. Ends with "N steps passed, N failed, N skipped".
#   long.sh              all steps: some eight hours on two cores
#   long.sh STEP...      these alone
#   long.sh --list       their names
# GJK_FUZZ_SECONDS (3600) and GJK_MUTANTS (300) say how long fuzz runs and how many mutants are tried.
set -uo pipefail
cd "$(dirname "$0")/.."
export DOTNET_CLI_TELEMETRY_OPTOUT=1 DOTNET_NOLOGO=1

# One line a step: its name, its usual minutes on two cores, what it is.
steps='
counts-Contacts      60  the tests of that namespace of Gjk.Core.Tests with a hundred times the counts
counts-Queries       90  the same of this one
counts-rest          70  the same of what these shares leave
counts-netstandard   70  the same on netstandard, with the tests that the quick tier leaves out there
counts-others        15  the other projects of tests
mutants              60  a sample of changed lines, each of which a test should notice
fuzz                 60  random pairs against every promise
viewer               10  the pages in Chromium and Firefox, two whole studies, all traces, pictures to look at
arm64                10  hard pairs and golden hashes on emulated 64-bit ARM
mono                  5  the Unity package compiled ahead of time, and without any JIT
debug                20  the tests of a debug build, with its assertions
runtimes              5  bench/runtimes: the library beside the algorithm of the report, on Mono and on .NET
builds               10  the ways in which people build: one folder, artifacts, a path with spaces, one file, no network
slurm                10  the job file of docs/tasks/many-machines.md on a one-node Slurm
'
# The namespaces of Gjk.Core.Tests that have a step of their own; a test holds these lists to what there is.
shares='Contacts Queries'
others='Gjk.Demo.Tests Gjk.Docs.Tests Gjk.Samples.Tests Gjk.Unity.Checks'
names=$(awk 'NF { print $1 }' <<< "$steps")

usage() {
  sed -n '2,8s/^# \{0,1\}//p' "tests/long.sh"
  printf '\nstep            minutes\n%s\n' "$steps" | sed '/^$/d'
}

# PROJECT [OPTION...]
counts() { GJK_LONG=1 dotnet test -c Release "tests/$1" "${@:2}"; }

# Every project is run, whether or not the one before failed.
counts_of() {
  local project status=0
  for project in "$@"; do counts "$project" || status=1; done
  return "$status"
}

run_step() {
  local demo=src/Gjk.Demo left
  left=$(printf '&FullyQualifiedName!~Gjk.Core.Tests.%s.' $shares)
  case $1 in
    counts-rest) counts Gjk.Core.Tests --filter "${left#&}" ;;
    counts-netstandard) counts_of Gjk.Core.Tests.NetStandard20 Gjk.Core.Tests.NetStandard21 ;;
    counts-others) counts_of $others ;;
    counts-*) counts Gjk.Core.Tests --filter "FullyQualifiedName~Gjk.Core.Tests.${1#counts-}." ;;
    mutants) env -u GJK_LONG tests/Gjk.Mutation/run.sh --sample "${GJK_MUTANTS:-300}" ;;
    fuzz) dotnet run -c Release --project $demo -- fuzz --seconds "${GJK_FUZZ_SECONDS:-3600}" ;;
    viewer) GJK_LONG=1 tests/Gjk.Viewer/run.sh ;;
    arm64) tests/Gjk.Arm64/run.sh ;;
    mono) tests/Gjk.Mono/run.sh && GJK_LONG=1 tests/Gjk.Unity.Mono/run.sh ;;
    debug) dotnet test tests/Gjk.Core.Tests -c Debug -f net10.0 ;;
    runtimes) command -v mono > /dev/null && dotnet run -c Release --project bench -- --mono --seconds 2 \
      || { ! command -v mono > /dev/null && echo "skipped: Mono is not installed"; } ;;
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
  table+=$(printf '%-18s %6d s  %s' "$step" $((SECONDS - start)) "$fate")$'\n'
done
printf '\n%s' "$table"
echo "$passed steps passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ]
