#!/usr/bin/env bash
# Shows that pack.sh --baseline works: FOLDER, the packages of these very sources, is a baseline that passes; one with a
# public type more is refused, and the error names that type. It needs the Release build of the libraries.
set -euo pipefail
feed=$(realpath "${1:?usage: baseline.sh FOLDER}")
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "baseline: $1" >&2; cat "$work/log" >&2; exit 1; }

# What the version before had: the library with one type more, for the newest target alone, to be quick.
mkdir "$work/older" "$work/tree"
tar -c --exclude bin --exclude obj ./*.props ./*.md global.json Gjk.snk .editorconfig src/*.props src/Gjk.Core \
  | tar -x -C "$work/tree"
echo 'namespace Gjk.Core; public static class TypeThatWasRemoved { }' > "$work/tree/src/Gjk.Core/TypeThatWasRemoved.cs"
dotnet pack "$work/tree/src/Gjk.Core" -c Release -v quiet -nologo -o "$work/older" -p:TargetFrameworks=net10.0 \
  -p:RunAnalyzers=false -p:EnablePackageValidation=false -p:TreatWarningsAsErrors=false > "$work/log" 2>&1 \
  || fail "the library with one type more could not be packed"
cp "$feed"/Gjk.Import.*.nupkg "$work/older"

! ./pack.sh "$work/refused" --no-build --baseline "$work/older" > "$work/log" 2>&1 \
  || fail "a removed type was not noticed"
grep -q "error CP0001: Type 'Gjk.Core.TypeThatWasRemoved' exists on .*\[Baseline\]" "$work/log" || fail "no clear error"
dotnet pack src/Gjk.Core -c Release -v quiet -nologo --no-build -o "$work/accepted" > "$work/log" 2>&1 \
  "-p:PackageValidationBaselinePath=$(ls "$feed"/Gjk.Core.*.nupkg)" || fail "the same public surface was refused"
! ./pack.sh "$work/none" --no-build --baseline "$work/tree" > "$work/log" 2>&1 || fail "an empty baseline was taken"
grep -q "tree: needs one package of Gjk.Core" "$work/log" || fail "no clear error without a baseline"
echo "baseline: the same surface passes, a removed type is refused"
