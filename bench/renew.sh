#!/usr/bin/env bash
# Measures all that the pages show of speed, keeps it in bench/results, and writes the pages' tables from there. Takes
# about a quarter of an hour; run nothing beside it. --pages only writes the tables, from the results that are there.
# The files are named after the processor; those of another one go, so that the pages need not choose.
set -euo pipefail
cd "$(dirname "$0")/.."
case ${1:-} in
  '' | --pages) ;;
  *) sed -n '2,4s/^# \{0,1\}//p' bench/renew.sh; [[ $1 == -h || $1 == --help ]] || exit 2; exit 0 ;;
esac
if [ "${1:-}" != --pages ]; then
  command -v mono > /dev/null || { echo 'renew.sh: Mono is not installed; tests/install.sh mono-devel' >&2; exit 2; }
  dotnet build -c Release -v quiet --nologo bench
  # A run that breaks off leaves the old figures.
  old=$(mktemp -d)
  find bench/results -name '*.csv' ! -name 'cited*.csv' ! -name '*-judge.csv' -exec mv {} "$old" \;
  trap 'cp "$old"/*.csv bench/results; rm -rf "$old"' EXIT
  for what in table peers scale mono; do
    dotnet run -c Release --no-build --project bench -- --$what --csv
  done
  trap - EXIT
  rm -rf "$old"
fi

dotnet run -c Release --project docs/Gjk.Pages
