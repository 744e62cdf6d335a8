#!/usr/bin/env bash
# Brings the generated parts of the Unity package up to date: the library's DLL, the .meta files, the sample scenes.
# With --export DIR it leaves the repository alone and writes the package, with the DLL of the present build, and a
# tarball to DIR; where the commit has a version's tag, the DLL in the repository must be current. --no-build uses the
# Release build that is there; --force takes the DLL even where its sources have not changed.
set -euo pipefail
cd "$(dirname "$0")/.."

build=yes
target=
options=()
while [ $# -gt 0 ]; do
  case $1 in
    --no-build) build= ;;
    --export) target=$(realpath -m "$2"); shift ;;
    --force) options+=(--force) ;;
    *) echo "unknown option $1" >&2; exit 2 ;;
  esac
  shift
done

if [ -n "$build" ]; then
  dotnet build src/Gjk.Core -c Release -f netstandard2.1 -v quiet --nologo
  dotnet build unity/Gjk.Unity.Pack -c Release -v quiet --nologo
fi

run() { dotnet run --project unity/Gjk.Unity.Pack -c Release --no-build -- "$@"; }

if [ -z "$target" ]; then
  run refresh "${options[@]}"
else
  git describe --exact-match --tags --match 'v*' > /dev/null 2>&1 && options+=(--release)
  run export "$target" "$(git config --get remote.origin.url || true)" "${options[@]}"
fi
