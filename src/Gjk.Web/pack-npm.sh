#!/usr/bin/env bash
# Makes the package for npm in the folder that is given, of the Release build of src/Gjk.Web, with the project's version
# or the one that is given.
set -euo pipefail
target=$(realpath -m "${1:?usage: pack-npm.sh FOLDER [VERSION]}")
version=${2:-}
cd "$(dirname "$0")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$target" "$work/runtime"
cp npm/* "$work"
cp ../Gjk.Demo/bin/Release/net10.0/browser/* ../Gjk.Demo/viewer/src/engine.js "$work/runtime"
rm -f "$work/runtime/stamp"
cp ../../LICENSE "$work"
assemblies=$(cd "$work/runtime" && printf "'%s', " *.dll)
sed -i "s|__ASSEMBLIES__|[${assemblies%, }]|" "$work/index.js"
version=${version:-$(dotnet msbuild Gjk.Web.csproj -getProperty:Version)}
sed -i "s|\"version\": \"0.0.0\"|\"version\": \"$version\"|" "$work/package.json"
(cd "$work" && npm pack --silent --pack-destination "$target" > /dev/null)
