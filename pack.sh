#!/usr/bin/env bash
# Makes all packages in one folder: Gjk.Core, Gjk.Import and the tool gjk-demo for NuGet, gjk-core for npm, com.gjk.core
# for Unity. --no-build takes the Release build of the solution that is there. --baseline FOLDER also compares the
# public surface of the libraries with that of the packages there, those of the last release. Where the commit has no
# version's tag, the packages for NuGet and npm have a version of their own, after that in Directory.Build.props: NuGet
# keeps what it has once unpacked, so a second package of one version would never be seen.
set -euo pipefail
usage='usage: pack.sh FOLDER [--no-build] [--baseline FOLDER]'
target=$(realpath -m "${1:?$usage}")
shift
options=(-c Release -v quiet -nologo -o "$target")
unity=()
build=yes
baseline=
while [ $# -gt 0 ]; do
  case $1 in
    --no-build) build= ;;
    --baseline) baseline=$(realpath -m "${2:?$usage}"); shift ;;
    *) echo "$usage" >&2; exit 2 ;;
  esac
  shift
done

cd "$(dirname "$0")"
mkdir -p "$target"
if [ -n "$build" ]; then
  # The tool holds the library for browsers, which no project of .NET refers to.
  dotnet build -c Release -v quiet -nologo src/Gjk.Web
else
  options+=(--no-build)
  unity+=(--no-build)
fi

version=$(dotnet msbuild src/Gjk.Core -getProperty:Version)
if ! git describe --exact-match --tags --match 'v*' > /dev/null 2>&1; then
  # The number of commits, and the time where something is not committed.
  count=$(git rev-list --count HEAD)
  [ -z "$(git status --porcelain)" ] || count+=.$(date +%s)
  case $version in
    *-*) version+=.$count ;;
    *) version=${version%.*}.$((${version##*.} + 1))-local.$count ;;
  esac
fi
options+=("-p:PackageVersion=$version")
# Gjk.Import names its version of Gjk.Core by what was restored.
[ -n "$build" ] || dotnet restore src/Gjk.Import -v quiet "-p:PackageVersion=$version"

for project in Gjk.Core Gjk.Import Gjk.Demo; do
  last=()
  if [ -n "$baseline" ] && [ "$project" != Gjk.Demo ]; then
    packages=("$baseline/$project".[0-9]*.nupkg)
    if [ ! -f "${packages[0]}" ] || [ ${#packages[@]} != 1 ]; then
      echo "$baseline: needs one package of $project" >&2
      exit 2
    fi

    # The SDK notes when it compared last, but not with what.
    rm -f "src/$project"/obj/Release/*ValidatePackage*.semaphore
    last=("-p:PackageValidationBaselinePath=${packages[0]}")
  fi
  dotnet pack "src/$project" "${options[@]}" "${last[@]}"
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
bash unity/pack.sh "${unity[@]}" --export "$work" > /dev/null
cp "$work"/*.tgz "$target"
if command -v npm > /dev/null; then bash src/Gjk.Web/pack-npm.sh "$target" "$version"; else echo "no npm: gjk-core is left out" >&2; fi
ls "$target"
