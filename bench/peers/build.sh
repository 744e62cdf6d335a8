#!/usr/bin/env bash
# Builds one program for each engine whose Debian package is there, or can be installed, into the folder that is given.
# Prints a line for each: "built NAME VERSION" or "missing NAME: why".
set -uo pipefail
cd "$(dirname "$0")"
out=${1:?usage: build.sh FOLDER}
mkdir -p "$out"
updated=

install() {
  dpkg -s "$1" > /dev/null 2>&1 && return 0
  command -v apt-get > /dev/null && [ "$(id -u)" = 0 ] || return 1
  if [ -z "$updated" ]; then apt-get update -qq > /dev/null 2>&1; updated=yes; fi
  apt-get install -y -qq --no-install-recommends "$1" > /dev/null 2>&1
}

# NAME PACKAGE PKG-CONFIG-NAME
build() {
  local name=$1 package=$2 config=$3
  if ! install "$package" || ! install pkg-config; then
    echo "missing $name: the package $package is not installed"
    return
  fi

  local version log
  version=$(dpkg-query -W -f '${Version}' "$package")
  # shellcheck disable=SC2046
  if log=$(g++ -w -o "$out/$name" "$name.cpp" $(pkg-config --cflags --libs "$config") \
      -std=c++17 -O3 -march=native -DNDEBUG 2>&1); then
    echo "built $name $version"
  else
    echo "missing $name: $(grep -m 1 error <<< "$log")"
  fi
}

if ! command -v g++ > /dev/null && ! install g++; then
  for name in bullet libccd fcl ode; do echo "missing $name: there is no g++"; done
  exit 0
fi

build bullet libbullet-dev bullet
build libccd libccd-dev ccd
build fcl libfcl-dev fcl
build ode libode-dev ode
