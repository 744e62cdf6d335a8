#!/usr/bin/env bash
# Runs the Unity package's tests and its components on Mono with the netstandard2.0 library: with the JIT; the components
# with code compiled ahead of time (--aot=full); and all of it without any JIT (--full-aot), which stands in for the rule
# of IL2CPP. What is compiled ahead is for GJK_LONG=1. Where Mono is missing it says so and ends well.
set -uo pipefail
cd "$(dirname "$0")"

if ! command -v mono > /dev/null; then
  echo "skipped: Mono is not installed (tests/Gjk.Mono/run.sh installs it where it can)"
  exit 0
fi

dotnet build -c Release -v quiet --nologo Gjk.Unity.Mono.csproj || exit 1
program=gjk-unity-mono.exe
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp bin/Release/net472/*.dll bin/Release/net472/$program "$folder"
passed=0
failed=0

# Runs a command and adds up its own tally; one that gives none counts as a failure.
tally() {
  local name=$1 output counts
  shift
  output=$("$@" 2>&1)
  counts=$(grep -oE '^[0-9]+ passed, [0-9]+ failed$' <<< "$output" | tail -n 1)
  echo "== $name"
  grep -vE '^[0-9]+ passed' <<< "$output" | head -n 40
  if [ -z "$counts" ]; then
    failed=$((failed + 1))
    return
  fi
  passed=$((passed + ${counts%% *}))
  counts=${counts#*, }
  failed=$((failed + ${counts%% *}))
}

# Without a JIT the system's assemblies must be compiled too. They may not be changed where they are, so copies are.
system_assembly() {
  local place
  for place in "$system" "$system/Facades"; do
    [ -f "$place/$1.dll" ] || continue
    cp -L "$place/$1.dll" "$folder"
    (cd "$folder" && MONO_PATH=$folder mono --aot=full "$1.dll") > "$folder/$1.log" 2>&1 || cat "$folder/$1.log"
    return
  done
}

tally "on Mono" mono "$folder/$program"
if [ "${GJK_LONG:-}" != 1 ]; then
  echo "$passed passed, $failed failed"
  [ "$failed" -eq 0 ]
  exit
fi

# The program's own assemblies first: they are compiled against the system's netstandard.dll where it is.
for file in "$folder"/*.dll "$folder/$program"; do
  (cd "$folder" && mono --aot=full "$(basename "$file")") > "$file.log" 2>&1 || cat "$file.log"
done
tally "compiled ahead of time" mono "$folder/$program" frames

system=$(dirname "$(readlink -f "$(command -v mono)")")/../lib/mono/4.5
for name in mscorlib netstandard System System.Core System.Numerics; do system_assembly $name; done

# Mono names the next assembly that it needs compiled, and leaves a crash report where it runs; a dozen is more than there
# are.
cd "$folder" || exit 1
for _ in 1 2 3 4 5 6 7 8 9 10 11 12; do
  missing=$(MONO_PATH=$folder mono --full-aot "$folder/$program" frames 2>&1 \
    | grep -oP "Failed to load AOT module '[^']*/\K[^/']+(?=\.dll\.so')" | head -n 1)
  [ -n "$missing" ] || break
  system_assembly "$missing"
done
tally "without a JIT" env MONO_PATH="$folder" mono --full-aot "$folder/$program"

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
