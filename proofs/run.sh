#!/usr/bin/env bash
# Has Gappa prove every script of this folder, and fail at each one's control: the same script with another constant, so
# that no proof is empty. Installs Gappa where that is possible, else says so and ends well. With --best it prints how
# far each constant could go.
set -uo pipefail
cd "$(dirname "$0")"

install_gappa() {
  command -v apt-get > /dev/null || return 1
  apt-get install -y --no-install-recommends gappa > /dev/null 2>&1 && return 0
  apt-get update > /dev/null 2>&1 && apt-get install -y --no-install-recommends gappa > /dev/null 2>&1
}

if ! command -v gappa > /dev/null && ! { install_gappa && command -v gappa > /dev/null; }; then
  echo "skipped: Gappa is not installed and cannot be installed here"
  exit 0
fi

# Reads a script; says "proved", "refused" where Gappa finds no proof, or "broken". A warning is a step taken on trust,
# and counts as broken.
verdict() {
  local said status
  said=$(timeout 60 gappa -Eprecision=160 2>&1)
  status=$?
  if [ $status -eq 0 ] && [ -z "$said" ]; then
    echo proved
  elif ! grep -q Warning <<< "$said" && grep -qE 'some properties were not satisfied|no contradiction was found' <<< "$said"; then
    echo refused
  else
    echo broken
  fi
}

# The script with its constant replaced.
with() { sed "s#^${2%% *} = .*#$2#" "$1"; }

control_of() { sed -n 's/^# control: //p' "$1"; }

# The last of 4096 steps between the constant and its control at which the proof still holds.
best_of() {
  local script=$1 control name good bad middle low=0 high=4096
  control=$(control_of "$script")
  name=${control%% *}
  good=$(sed -n "s/^$name = \(.*\);$/\1/p" "$script" | head -n 1)
  bad=${control#* = }
  bad=${bad%;}
  while [ $((high - low)) -gt 1 ]; do
    middle=$(((low + high) / 2))
    if [ "$(with "$script" "$name = $good + (($bad) - ($good)) * ${middle}b-12;" | verdict)" = proved ]; then
      low=$middle
    else
      high=$middle
    fi
  done
  echo "$script: $name = $good + (($bad) - ($good)) * $low / 4096"
}

if [ "${1:-}" = --best ]; then
  for script in *.g; do best_of "$script"; done
  exit 0
fi

passed=0
failed=0
count() {
  if [ "$1" -eq 0 ]; then passed=$((passed + 1)); else failed=$((failed + 1)); fi
}

for script in *.g; do
  proof=$(verdict < "$script")
  control=$(control_of "$script")
  check=$(with "$script" "${control:-none = none}" | verdict)
  [ "$proof" = proved ]
  count $?
  [ "$check" = refused ]
  count $?
  echo "$script: $proof; with $control $check"
done
echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
