#!/usr/bin/env bash
# Would the tests notice a wrong line? Changes the library one place at a time and runs the tests that reach it until one
# fails. All of Solvers, Simplex, Contacts and Minkowski with GJK_LONG=1, for hours; a sample of 300 without.
#   run.sh --branches                                    which conditions no test finds true, or none false
#   run.sh --operators '^constant' --files GjkTolerances named constants, four times larger and smaller
#   run.sh --seed 7 --budget 20                          another sample, 20 seconds of tests for each mutant at most
# What became of each mutant is in mutants.tsv of --work, by default /tmp/gjk-mutation. Program.cs tells all options.
set -euo pipefail
cd "$(dirname "$0")"

case ${1:-} in
  -h | --help) sed -n '2,7s/^# \{0,1\}//p' run.sh; exit 0 ;;
esac

sample=()
if [ "${GJK_LONG:-}" != 1 ]; then sample=(--sample 300); fi
dotnet build -c Release -v quiet ../Gjk.Core.Tests/Gjk.Core.Tests.csproj -p:RunAnalyzers=false
dotnet build -c Release -v quiet Gjk.Mutation.csproj
exec bin/Release/net10.0/gjk-mutation run --repository ../.. "${sample[@]}" "$@"
