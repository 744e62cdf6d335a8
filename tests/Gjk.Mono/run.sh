#!/usr/bin/env bash
# Runs the netstandard2.0 library on Mono: the hard pairs, the golden hashes, the bytes allocated, the time per pair; and
# pairs and hashes again on a thread of native code, where a C compiler is. Installs Mono where that is possible, else
# says so and ends well.
set -euo pipefail
cd "$(dirname "$0")"

install_mono() {
  command -v apt-get > /dev/null || return 1
  local packages=(mono-runtime mono-devel)
  apt-get install -y --no-install-recommends "${packages[@]}" > /dev/null 2>&1 && return 0
  apt-get update > /dev/null 2>&1 && apt-get install -y --no-install-recommends "${packages[@]}" > /dev/null 2>&1
}

if ! command -v mono > /dev/null && ! { install_mono && command -v mono > /dev/null; }; then
  echo "skipped: Mono is not installed and cannot be installed here"
  exit 0
fi

dotnet build -c Release -v quiet Gjk.Mono.csproj
folder=bin/Release/net472
options=(--time)
if [ "$(uname -m)" != x86_64 ] || ! command -v gcc > /dev/null; then
  echo "native thread skipped: there is no C compiler, or no x87 unit, here"
else
  gcc -shared -fPIC -pthread -o $folder/libnative_thread.so native_thread.c
  options+=(--native-thread)
fi

exec mono $folder/gjk-mono.exe ../Cases "${options[@]}"
