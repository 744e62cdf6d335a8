#!/usr/bin/env bash
# Runs the library on .NET 10 for 64-bit ARM, by QEMU's emulator: every hard pair and the golden hashes; and the same
# program on this machine, whose lines must be the same. Says so and ends well where the emulator or the runtime cannot
# be had.
set -uo pipefail
cd "$(dirname "$0")"
export DOTNET_CLI_TELEMETRY_OPTOUT=1 DOTNET_NOLOGO=1
root=/usr/aarch64-linux-gnu

install_emulator() {
  command -v apt-get > /dev/null || return 1
  local packages=(qemu-user-static libc6-arm64-cross libstdc++6-arm64-cross libgcc-s1-arm64-cross)
  apt-get install -y --no-install-recommends "${packages[@]}" > /dev/null 2>&1 && return 0
  apt-get update > /dev/null 2>&1 && apt-get install -y --no-install-recommends "${packages[@]}" > /dev/null 2>&1
}

is_there() { command -v qemu-aarch64-static > /dev/null && [ -e $root/lib/libstdc++.so.6 ]; }

if ! is_there && ! { install_emulator && is_there; }; then
  echo "skipped: QEMU's emulator of ARM is not installed and cannot be installed here"
  exit 0
fi

# The runtime of ARM comes from the package registry. A fault of the project itself is none of the registry's.
restored=$(dotnet restore -v quiet Gjk.Arm64.csproj 2>&1)
if [ $? -ne 0 ]; then
  if grep -qE 'NU1101|NU1102|NU1301' <<< "$restored"; then
    echo "skipped: the .NET runtime for ARM cannot be had here"
    exit 0
  fi
  echo "$restored"
  exit 1
fi

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
options=(-c Release -v quiet --no-restore Gjk.Arm64.csproj)
dotnet build "${options[@]}" || exit 1
dotnet publish -r linux-arm64 --self-contained -o "$folder/arm" "${options[@]}" || exit 1

dotnet bin/Release/net10.0/gjk-arm64.dll ../Cases > "$folder/here.txt" 2>&1 &
here=$!

# What the emulator is known to stumble over, and what has no part in the answers: memory that is remapped to be
# executed, a collector's thread, and code that is replaced while it runs. A run that ends by a signal is tried once
# more.
export DOTNET_EnableWriteXorExecute=0 DOTNET_gcConcurrent=0 DOTNET_TieredCompilation=0
for attempt in 1 2; do
  qemu-aarch64-static -L $root "$folder/arm/gjk-arm64" ../Cases > "$folder/arm.txt" 2> "$folder/arm.err"
  status=$?
  [ $status -ge 128 ] || break
  echo "the emulator ended by signal $((status - 128))"
done
wait $here
here=$?
cat "$folder/here.txt" "$folder/arm.txt" "$folder/arm.err"
[ $here -eq 0 ] || exit 1

# The tally is the emulated run's and one more for each hash that is also this machine's.
tally=$(grep -oE '^[0-9]+ passed, [0-9]+ failed$' "$folder/arm.txt" | tail -n 1)
[ -n "$tally" ] || exit 1
passed=${tally%% *}
failed=${tally#*, }
failed=${failed%% *}
while read -r line; do
  if grep -qxF "$line" "$folder/arm.txt"; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    echo "on this machine: $line"
  fi
done < <(grep '^hash of ' "$folder/here.txt")
echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
