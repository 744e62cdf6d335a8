#!/usr/bin/env bash
# Makes all packages in one folder: Gjk.Core, Gjk.Import and the tool gjk-demo for NuGet, gjk-core for npm, com.gjk.core
# for Unity. --no-build takes the Release build of the solution that is there. --baseline VERSION also compares the
# public surface with that of a published version.
set -euo pipefail
usage='usage: pack.sh FOLDER [--no-build] [--baseline VERSION]'
target=$(realpath -m "${1:?$usage}")
shift
cd "$(dirname "$0")"
options=(-c Release -v quiet -nologo -o "$target")
unity=()
build=yes
while [ $# -gt 0 ]; do
  case $1 in
    --no-build) build= ;;
    --baseline) options+=("-p:PackageValidationBaselineVersion=${2:?$usage}"); shift ;;
    *) echo "$usage" >&2; exit 2 ;;
  esac
  shift
done

mkdir -p "$target"
if [ -n "$build" ]; then
  # The tool holds the library for browsers, which no project of .NET refers to.
  dotnet build -c Release -v quiet -nologo src/Gjk.Web
else
  options+=(--no-build)
  unity+=(--no-build)
fi

for project in Gjk.Core Gjk.Import Gjk.Demo; do dotnet pack "src/$project" "${options[@]}"; done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
bash unity/pack.sh "${unity[@]}" --export "$work" > /dev/null
cp "$work"/*.tgz "$target"
if command -v npm > /dev/null; then bash src/Gjk.Web/pack-npm.sh "$target"; else echo "no npm: gjk-core is left out" >&2; fi
ls "$target"
