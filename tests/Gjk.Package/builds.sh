#!/usr/bin/env bash
# The ways in which people build: into one folder, into a folder of artifacts, from a path with spaces, as one file for
# this machine and another one, and again without a network. Needs what a restore needs; ends with "N passed, N failed".
set -uo pipefail
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0 failed=0
try() {
  if "$@" > "$work/log" 2>&1; then passed=$((passed + 1)); else
    failed=$((failed + 1))
    echo "FAILED: $*"
    tail -n 5 "$work/log"
  fi
}

clone="$work/a path with spaces"
git clone -q . "$clone"
cd "$clone"
demo=src/Gjk.Demo
quiet=(-c Release -v quiet -nologo -p:RunAnalyzers=false)
try dotnet build "${quiet[@]}" "$demo" -o "$work/demo out"
try dotnet "$work/demo out/gjk-demo.dll" replay --frames 2
try dotnet build "${quiet[@]}" src/Gjk.Web -o "$work/demo out"
try dotnet "$work/demo out/gjk-demo.dll" play --out "$work/play.html"
try dotnet build "${quiet[@]}" Gjk.sln --artifacts-path "$work/artifacts"
try dotnet "$work/artifacts/bin/Gjk.Demo/release/gjk-demo.dll" play --out "$work/play.html"
try dotnet publish "${quiet[@]}" "$demo" -r linux-x64 --self-contained -p:PublishSingleFile=true -o "$work/x64"
try "$work/x64/gjk-demo" replay --frames 2
try dotnet publish "${quiet[@]}" "$demo" -r linux-arm64 --self-contained -o "$work/arm64"
try test -x "$work/arm64/gjk-demo"
try dotnet build "${quiet[@]}" "$demo"
try dotnet build "${quiet[@]}" "$demo" --no-restore
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
