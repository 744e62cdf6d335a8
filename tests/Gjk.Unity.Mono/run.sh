#!/usr/bin/env bash
# Runs the Unity package's tests on Mono with the netstandard2.0 library, then the components' frames again with all
# code compiled ahead of time: with the JIT as a fallback (--aot=full), and without any (--full-aot), which is the rule
# of IL2CPP. Where Mono is missing it says so and ends well.
set -uo pipefail
cd "$(dirname "$0")"

if ! command -v mono > /dev/null; then
  echo "skipped: Mono is not installed (tests/Gjk.Mono/run.sh installs it where it can)"
  exit 0
fi

dotnet build -c Release -v quiet --nologo Gjk.Unity.Mono.csproj || exit 1
output=$(mono bin/Release/net472/gjk-unity-mono.exe)
echo "$output"
tally=$(grep -oE '^[0-9]+ passed, [0-9]+ failed$' <<< "$output" | tail -n 1)
passed=${tally%% *}
failed=${tally#*, }
failed=${failed%% *}
[ -n "$tally" ] || { passed=0; failed=1; }

# A failure here counts as one.
ahead() {
  echo "== $1"
  shift
  if "$@"; then passed=$((passed + 1)); else failed=$((failed + 1)); fi
}

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp -r bin/Release/net472/. "$folder"

# Mono's own assemblies must be compiled too when there is no JIT; they are copied, since the system's may not be changed.
compile_all() {
  local corlib
  corlib=$(dirname "$(readlink -f "$(command -v mono)")")/../lib/mono/4.5
  for name in mscorlib System System.Core System.Numerics netstandard; do
    for place in "$corlib" "$corlib/Facades"; do
      [ -f "$folder/$name.dll" ] || ! [ -f "$place/$name.dll" ] || cp "$place/$name.dll" "$folder/"
    done
  done
  (cd "$folder" && for file in *.dll *.exe; do MONO_PATH=. mono --aot=full "$file" > aot.log 2>&1 || { cat aot.log; return 1; }; done)
}

ahead "compiled ahead of time" compile_all
ahead "frames with ahead-of-time code" env MONO_PATH="$folder" mono "$folder/gjk-unity-mono.exe" frames
ahead "frames without a JIT" env MONO_PATH="$folder" mono --full-aot "$folder/gjk-unity-mono.exe" frames
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
